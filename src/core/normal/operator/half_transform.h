// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/normal/operator/lanes.h"

namespace wheel_rail_contact::core
{
/// Cosine sums over one direction of a grid with n = 2 `half` cells, and the transposed sums. The modes are those of a
/// grid of twice the length.
///
/// The even part of a field has values at x = k + 1/2, k < half, and the modes cos(pi a x / n), a < n. The odd part,
/// multiplied by (-1)^k, has the same sums, for its sine modes n - a. The even a alone are the modes of the period of
/// the grid itself.
///
/// The sums of even a are a cosine transform of the second kind (DCT-II) of size `half`, those of odd a one of the
/// fourth kind (DCT-IV). Long transforms are split into transforms of half the size (Rao and Yip 1990, sec. 4.4):
///   DCT-II of x: DCT-II of (x_k + x_mirror), DCT-IV of (x_k - x_mirror),
///   DCT-IV of x: DCT-II of the pairs (x_k, x_mirror) rotated by (2k + 1) pi / (4 half), then sums and differences.
/// Splitting ends at sizes for which a matrix product is faster. The values to be combined, k and its mirror image, are
/// stored at the same position of two blocks; see place().
class HalfTransform
{
 public:
  /// Layout of the values and modes of one call: many lines of single numbers, or one line of vectors.
  struct Lines
  {
    int count = 1;    ///< number of lines, stored one after another
    int unit = 1;     ///< doubles of a value: 1, or in a single line a multiple of lane_padding
    int pitch = 1;    ///< doubles from value to value, at least `unit`; modes have no gaps
    bool all = true;  ///< true: all modes; false: those of even number only
  };

  explicit HalfTransform(int half_cells);

  int half() const { return half_; }
  /// Position in memory of value k, counted from the centre outward.
  int place(int k) const { return place_[static_cast<std::size_t>(k)]; }
  /// (-1)^k in the order of the values in memory, padded to lanes.
  const double* sign() const { return sign_.data(); }
  /// Number of doubles from line to line, for lines of single numbers: of values, and of modes.
  int valueStride() const { return roundUpToLanes(half_); }
  int modeStride(bool all) const { return roundUpToLanes(all ? 2 * half_ : half_); }
  /// Number of the mode at a position in memory, for the even part (parity 0) or the odd part (parity 1).
  int number(int parity, int place) const;

  /// Computes modes from values. Unless it is null, `scale`, in the layout of the modes, multiplies them. `work` has
  /// the size of `modes`.
  void forward(const Lines& lines, const double* values, const double* scale, double* work, double* modes) const;
  /// Transposed transform: computes values from modes. Overwrites `modes`.
  void backward(const Lines& lines, double* modes, double* work, double* values) const;

 private:
  /// Kind of transform: DCT-II, DCT-IV, and both with their modes in reverse order (mode 0 of DCT-II stays first).
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
    int at = 0, count = 0;  ///< index of the first value, number of values of each of the two blocks
    int level = 0;          ///< of the splitting
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
  std::vector<Matrix> matrices_;      ///< matrices of the leaves, by Kind; without splitting a single one, of all modes
  std::vector<LaneBuffer> turns_;     ///< by level of the splitting
  std::vector<Step> before_, after_;  ///< steps before and after the leaves
  std::vector<Leaf> leaves_;
};
}  // namespace wheel_rail_contact::core
