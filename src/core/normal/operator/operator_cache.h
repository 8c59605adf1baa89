// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "core/normal/operator/influence_operator.h"

namespace wheel_rail_contact::core
{
/// Series of cell aspects dx/dy whose influence coefficients are computed in advance: 2^(k/8) for the indices k = -24 …
/// 40, that is 1/8 to 32. A moving contact therefore computes no logarithm. Rounding to this series makes a box at most
/// 4.4 % larger than required.
namespace cell_aspect
{
constexpr int lowest_index = -24;  ///< index of aspect 1/8
constexpr int highest_index = 40;  ///< index of aspect 32

/// Aspect dx/dy of the series by its index [-].
double aspect(int index);

/// Smallest index of the series, continued beyond lowest_index and highest_index, whose value is at least `value` (>
/// 0).
int indexAbove(double value);

/// Index of the aspect nearest to `dx_over_dy` (> 0) in the logarithm, limited to lowest_index … highest_index.
int nearestIndex(double dx_over_dy);

/// Cell of an nx × ny grid whose aspect is in the series.
struct Cell
{
  double dx = 0, dy = 0;  ///< [m]
};

/// Smallest cell with an aspect of the series whose nx × ny grid covers `length` × `width` [m] (both > 0).
Cell coveringCell(double length, double width, int nx, int ny);
}  // namespace cell_aspect

/// Keeps influence operators, so that each set of coefficients is computed only once.
///
/// Operators whose aspect is in that series are computed once in a process and kept until it ends. All
/// caches share them, in all threads. Of other aspects only the few used last are kept.
class OperatorCache
{
 public:
  /// Computes the operators of a grid, whole and (nx even) symmetric. They cover patches from `widest` times as wide as
  /// long to `longest` times as long as wide. For these, find() later computes and allocates nothing.
  /// @throw std::invalid_argument see InfluenceOperator.
  void prepare(int nx, int ny);

  static constexpr double widest = 4;    ///< width over length of the widest prepared patch [-]
  static constexpr double longest = 16;  ///< length over width of the longest prepared patch [-]

  /// Operator for a grid; computed now if it is new. An aspect within 1e-9 of one of the series is taken as that one.
  /// @throw std::invalid_argument see InfluenceOperator.
  std::shared_ptr<const InfluenceOperator> find(int nx, int ny, bool symmetric, double aspect);

 private:
  struct Entry
  {
    std::shared_ptr<const InfluenceOperator> influence;
    bool in_series = false;  ///< its aspect is in that series
    unsigned long last_use = 0;
  };
  struct Family
  {
    int nx = 0, ny = 0;
    bool symmetric = false;
    std::vector<Entry> entries;  ///< by increasing aspect
  };

  Family& family(int nx, int ny, bool symmetric);
  static void forgetOldest(Family& family);

  std::vector<Family> families_;
  unsigned long uses_ = 0;
};
}  // namespace wheel_rail_contact::core
