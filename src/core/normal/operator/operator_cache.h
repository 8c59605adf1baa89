// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "core/normal/operator/influence_operator.h"

namespace wheel_rail_contact::core
{
/// Keeps influence operators, so that each set of coefficients is computed only once.
///
/// Operators whose aspect is in the series of cell_aspect.h are computed once in a process and kept until it ends. All
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
    bool in_series = false;  ///< its aspect is in the series of cell_aspect.h
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
