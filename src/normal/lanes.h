// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <new>

namespace wheel_rail_contact
{
/// Vectors are padded to a multiple of this many doubles and aligned to it.
constexpr int kLanes = 8;

constexpr int roundUpToLanes(int count)
{
  return (count + kLanes - 1) / kLanes * kLanes;
}

/// Aligned array of doubles; grows only, so that a shape seen before allocates nothing.
class LaneBuffer
{
 public:
  LaneBuffer() = default;
  explicit LaneBuffer(int size) { resize(size); }

  /// Makes room for `size` doubles and sets all of them to zero.
  void resize(int size);

  double* data() { return data_.get(); }
  const double* data() const { return data_.get(); }
  double& operator[](int index) { return data_.get()[index]; }
  double operator[](int index) const { return data_.get()[index]; }

 private:
  struct Free
  {
    void operator()(double* data) const { ::operator delete[](data, std::align_val_t{kLanes * sizeof(double)}); }
  };
  std::unique_ptr<double[], Free> data_;
  int capacity_ = 0;
};

/// Product of a lane-major matrix with a strided one: out(l, c) = scale(l, c) * sum over k of a(l, k) * b(k, c),
/// l being contiguous in memory, for all l < lanes (a multiple of kLanes), k < inner, c < columns.
struct LaneProduct
{
  int lanes = 0, inner = 0, columns = 0;
  const double* a = nullptr;
  int a_stride = 0;  ///< from a(0, k) to a(0, k + 1)
  const double* b = nullptr;
  int b_inner = 0;   ///< from b(k, c) to b(k + 1, c)
  int b_column = 0;  ///< from b(k, c) to b(k, c + 1)
  double* out = nullptr;
  int out_stride = 0;             ///< from out(0, c) to out(0, c + 1)
  const double* scale = nullptr;  ///< shaped like out, or null for ones
};

/// Sums over the cells of one patch that carry pressure.
struct LoadedCells
{
  double sum = 0;    ///< of displacement + gap [m]
  double count = 0;  ///< cells [-]
};

struct Violation
{
  double inside = 0;   ///< max |w| where p > 0 [m]
  double outside = 0;  ///< max (-w) elsewhere [m]
};

struct DirectionSums
{
  double z_r = 0, z_r_old = 0;
};

struct TrialSums
{
  double sum = 0;      ///< of the trial pressure
  double clipped = 0;  ///< cells where a positive pressure was cut to zero
};

struct StepSums
{
  double r_d = 0, d_q = 0;
  double longest = 0;  ///< largest step that keeps p >= 0
};

/// The loops of the solver, compiled for one instruction set; `size` is a multiple of kLanes everywhere.
struct LaneKernels
{
  int width = 0;  ///< doubles in one register

  void (*multiply)(const LaneProduct& product) = nullptr;

  /// Even and odd parts of `pairs` pairs of blocks of `block` doubles: out = (a + b, sign (a - b)), sign being an
  /// array.
  void (*fold)(int pairs, int block, const double* sign, const double* in, double* out) = nullptr;
  /// Its transpose: out = (e + sign o, e - sign o).
  void (*unfold)(int pairs, int block, const double* sign, const double* in, double* out) = nullptr;

  /// p = max(p + step d, 0), u += step q.
  LoadedCells (*advance)(int size, double step, const double* d, const double* q, const double* gap, double* p,
                         double* u) = nullptr;
  /// w = u + gap - shift; r = -w where p > 0 or w < 0, else 0.
  Violation (*residual)(int size, double shift, const double* p, const double* u, const double* gap,
                        double* r) = nullptr;
  /// Sum of z and number of cells where r != 0.
  LoadedCells (*maskedSum)(int size, const double* r, const double* z) = nullptr;
  /// z = z - shift where r != 0, else 0.
  DirectionSums (*project)(int size, double shift, const double* r, const double* r_old, double* z) = nullptr;
  /// d = z + beta d; trial = max(p + step d, 0).
  TrialSums (*trial)(int size, double beta, double step, const double* p, const double* z, double* d,
                     double* trial) = nullptr;
  /// d = scale trial - p.
  void (*chord)(int size, double scale, const double* p, const double* trial, double* d) = nullptr;
  StepSums (*stepLength)(int size, const double* p, const double* r, const double* d, const double* q) = nullptr;
};

/// The kernels for the widest registers of this machine.
const LaneKernels& laneKernels();
}  // namespace wheel_rail_contact
