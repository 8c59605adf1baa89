// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <new>
#include <vector>

namespace wheel_rail_contact::core
{
/// Fields are padded to a multiple of this number of doubles and aligned to it.
constexpr int lane_padding = 8;

constexpr int roundUpToLanes(int count)
{
  return (count + lane_padding - 1) / lane_padding * lane_padding;
}

/// Aligned array of doubles. It only grows: a size that is not larger than a previous one allocates nothing.
class LaneBuffer
{
 public:
  /// Reserves memory for `size` doubles. Sets all of them to zero if the size differs from the last one.
  void resize(int size);

  double* data() { return data_.get(); }
  const double* data() const { return data_.get(); }
  double& operator[](int index) { return data_.get()[index]; }
  double operator[](int index) const { return data_.get()[index]; }

 private:
  struct Free
  {
    void operator()(double* data) const { ::operator delete[](data, std::align_val_t{lane_padding * sizeof(double)}); }
  };
  std::unique_ptr<double[], Free> data_;
  int size_ = 0, capacity_ = 0;
};

/// Product of a lane-major matrix with a strided one: out(l, c) = scale(l, c) * sum over k of a(l, k) * b(k, c), for
/// all l < lanes (a multiple of lane_padding), k < inner, c < columns. l is contiguous in memory.
struct LaneProduct
{
  int lanes = 0, inner = 0, columns = 0;
  const double* a = nullptr;
  int a_stride = 0;  ///< doubles from a(0, k) to a(0, k + 1)
  const double* b = nullptr;
  int b_inner = 0;   ///< doubles from b(k, c) to b(k + 1, c)
  int b_column = 0;  ///< doubles from b(k, c) to b(k, c + 1)
  double* out = nullptr;
  int out_stride = 0;             ///< doubles from out(0, c) to out(0, c + 1)
  const double* scale = nullptr;  ///< layout of out; null: all ones
};

/// Pairs of neighbouring blocks of values in lines of memory.
struct BlockLines
{
  int lines = 1;
  int stride = 0;  ///< doubles from line to line
  int count = 0;   ///< values in each block
  int unit = 1;    ///< doubles in a value: 1 (count is then a multiple of lane_padding), or a multiple of lane_padding
};

/// Layout of values with gaps between them.
struct Spread
{
  int stride = 0;  ///< doubles from line to line
  int pitch = 1;   ///< doubles from value to value
};

/// Combination of two blocks P and Q, see HalfTransform; in brackets the combination of their first values.
enum class Combination
{
  forwards,             ///< (P + Q, P - Q), [P, -Q]; its own transpose
  backwards,            ///< (P - Q, P + Q), [-Q, P]
  backwards_transposed  ///< (P + Q, Q - P), [Q, -P]
};

/// Sum over some of the cells, and their number.
struct CellSum
{
  double sum = 0;
  double count = 0;
};

/// Violation of the contact conditions [m]. w is the distance of the deformed surfaces.
struct Violation
{
  double inside = 0;   ///< largest |w| where p > 0
  double outside = 0;  ///< largest -w elsewhere
};

/// Sums over the cells whose pressure may change.
struct MaskedSums
{
  double count = 0;
  double z = 0, q = 0, z_q = 0, z_r = 0;  ///< of z, q, z q and z r
};

/// Parameters of a trial point: p + length * (z - shift + beta * last step).
struct TrialStep
{
  double length = 0, shift = 0, beta = 0;
};

/// Sums that determine the length of a step.
struct StepSums
{
  double s_q = 0;   ///< curvature: step * matrix * step
  double fall = 0;  ///< largest relative decrease of a pressure, max(-s / p): 1 / fall is the longest step with p >= 0
};

/// Inner loops of the operator and the solvers, compiled for one instruction set. `size` is a multiple of
/// lane_padding in all of them.
struct LaneKernels
{
  const char* name = nullptr;

  void (*multiply)(const LaneProduct& product) = nullptr;
  /// Even and odd parts of pairs of blocks: out = (a + b, sign (a - b)). `sign` has the length of one block. `in` and
  /// `out` may be the same.
  void (*fold)(int pairs, int block, const double* sign, const double* in, double* out) = nullptr;
  /// Transpose of fold: out = (e + sign o, e - sign o).
  void (*unfold)(int pairs, int block, const double* sign, const double* in, double* out) = nullptr;

  /// (a, b) = (a + b, a - b).
  void (*butterfly)(const BlockLines& blocks, double* data) = nullptr;
  /// (a, b) = (c a + s b, c' b - s' a) with the table c, s, c', s' of the values, each padded to lane_padding; and the
  /// transposed operation.
  void (*turn)(const BlockLines& blocks, const double* turns, double* data) = nullptr;
  void (*turn_back)(const BlockLines& blocks, const double* turns, double* data) = nullptr;
  /// Writes the butterfly of `in` into two blocks of `out`, and, unless `turns` is null, its rotation by `turn` into
  /// two more blocks; and the transposed operation. `blocks` describes `out` of split and `in` of join. `spread`
  /// describes the other array.
  void (*split)(const BlockLines& blocks, const double* turns, const Spread& spread, const double* in,
                double* out) = nullptr;
  void (*join)(const BlockLines& blocks, const double* turns, const Spread& spread, const double* in,
               double* out) = nullptr;
  void (*combine)(const BlockLines& blocks, Combination combination, double* data) = nullptr;
  /// values = values * factors.
  void (*multiply_by)(int size, const double* factors, double* values) = nullptr;

  double (*sum)(int size, const double* values) = nullptr;
  void (*scale)(int size, double factor, double* values) = nullptr;
  /// out += factor * values.
  void (*add)(int size, double factor, const double* values, double* out) = nullptr;
  double (*dot)(int size, const double* a, const double* b) = nullptr;
  /// Number of values below a limit.
  double (*count_below)(int size, double limit, const double* values) = nullptr;
  /// p = sqrt(max(level - gap, 0)); returns the sum of p.
  double (*root_depth)(int size, double level, const double* gap, double* p) = nullptr;
  /// p = max(p + length s, 0), u += length q; returns the sum of u + gap over the cells with p > 0.
  CellSum (*advance)(int size, double length, const double* s, const double* q, const double* gap, double* p,
                     double* u) = nullptr;
  /// With w = u + gap - shift: r = -w where p > 0 or w < 0, otherwise 0.
  Violation (*residual)(int size, double shift, const double* p, const double* u, const double* gap,
                        double* r) = nullptr;
  /// Sums over the cells with r != 0.
  MaskedSums (*masked_sums)(int size, const double* r, const double* z, const double* q) = nullptr;
  /// out = max(p + step, 0), with a step only in cells with r != 0; returns the sum of out.
  double (*trial)(int size, const TrialStep& step, const double* r, const double* p, const double* z,
                  const double* last, double* out) = nullptr;
  /// trial = scale trial - p; returns its product with r.
  double (*chord)(int size, double scale, const double* r, const double* p, double* trial) = nullptr;
  StepSums (*step_sums)(int size, const double* p, const double* s, const double* q) = nullptr;
};

/// Kernels that this processor supports, widest registers first.
std::vector<const LaneKernels*> supportedLaneKernels();

/// The first of supportedLaneKernels().
const LaneKernels& laneKernels();
}  // namespace wheel_rail_contact::core
