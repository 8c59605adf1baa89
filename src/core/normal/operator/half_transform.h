// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/normal/operator/lanes.h"

namespace wheel_rail_contact::core
{
/// Cosine sums of half a direction of n = 2 half cells, over the modes of a grid twice as long, and the transposed
/// sums.
///
/// The even part of a field has values at x = k + 1/2, k < half, and the modes cos(pi a x / n), a < n. Its odd part,
/// multiplied by (-1)^k, has the same sums as its sine modes n - a. Even a alone are the modes of the grid's own
/// period.
///
/// Even a are a cosine transform of the second kind (DCT-II) of size `half`, odd a one of the fourth (DCT-IV). Long
/// ones are split into transforms of half the size (Rao and Yip 1990, sec. 4.4),
///   II of x: II of (x_k + x_mirror), IV of (x_k - x_mirror),
///   IV of x: II of the pairs (x_k, x_mirror) turned by (2k + 1) pi / (4 half), then sums and differences,
/// down to sizes where a matrix product is faster. Values are stored so that each pair to be combined lies in two
/// blocks, k and mirror at the same place: see place().
class HalfTransform
{
 public:
  /// What the values and modes of one call look like: many lines of single numbers, or one line of vectors.
  struct Lines
  {
    int count = 1;    ///< lines, one after another
    int unit = 1;     ///< doubles of a value: 1, or, in a single line, a multiple of kLanes
    int pitch = 1;    ///< doubles from value to value, at least `unit`; modes lie close together
    bool all = true;  ///< all modes, or those of even number only
  };

  explicit HalfTransform(int half_cells);

  int half() const { return half_; }
  /// Place in memory of value k, counted from the centre outward.
  int place(int k) const { return place_[static_cast<std::size_t>(k)]; }
  /// (-1)^k by place, padded to lanes.
  const double* sign() const { return sign_.data(); }
  /// Doubles from line to line, of values and of modes, if these are single numbers.
  int valueStride() const { return roundUpToLanes(half_); }
  int modeStride(bool all) const { return roundUpToLanes(all ? 2 * half_ : half_); }
  /// Number of the mode at a place in memory, for the even part (0) and the odd part (1).
  int number(int parity, int place) const;

  /// Modes of values; `scale`, shaped like the modes, multiplies them unless it is null. `work` is as large as `modes`.
  void forward(const Lines& lines, const double* values, const double* scale, double* work, double* modes) const;
  /// Transposed: values from modes, whose memory is used up.
  void backward(const Lines& lines, double* modes, double* work, double* values) const;

 private:
  /// Kind of transform: DCT-II, DCT-IV, and the same with modes backwards (mode 0 of DCT-II staying first).
  enum Kind
  {
    ii,
    ii_backwards,
    iv,
    iv_backwards
  };
  struct Step
  {
    enum class Action
    {
      butterfly,
      turn,
      combine,
      combine_backwards
    };
    Action action = Action::butterfly;
    int at = 0, count = 0;  ///< first value, values of each of the two blocks
    int level = 0;          ///< of splitting
  };
  struct Leaf
  {
    Kind kind = ii;
    int at = 0;
  };
  struct Matrix
  {
    int mode_stride = 0, value_stride = 0;
    LaneBuffer by_mode;   ///< [value][mode]
    LaneBuffer by_value;  ///< [mode][value]
  };

  static std::vector<int> storageOrder(int size, int depth);
  static std::vector<int> modeOrder(Kind kind, int size, int depth);
  static Matrix matrix(const std::vector<int>& modes, int values);
  static LaneBuffer turnTable(int size, int depth);
  void addSteps(Kind kind, int level, int at);
  int modesSize(const Lines& lines) const;
  BlockLines blocks(const Lines& lines, int count) const;
  void apply(const Lines& lines, const Step& step, bool back, double* data) const;
  void products(const Lines& lines, const double* in, double* out, const double* scale, bool back) const;
  LaneProduct product(const Lines& lines, const Leaf& leaf, bool back) const;

  int half_ = 0, depth_ = 0;
  std::vector<int> place_, modes_;
  LaneBuffer sign_;
  std::vector<Matrix> matrices_;      ///< of a leaf, by Kind; without splitting only one, of all modes
  std::vector<LaneBuffer> turns_;     ///< by level
  std::vector<Step> before_, after_;  ///< steps before and after the leaves
  std::vector<Leaf> leaves_;
};
}  // namespace wheel_rail_contact::core
