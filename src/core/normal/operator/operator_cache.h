// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "core/normal/operator/influence_operator.h"

namespace wheel_rail_contact::core
{
/// Keeps influence operators, so that each set of coefficients is computed once.
///
/// Operators with an aspect on the ladder (aspect_ladder.h) are computed once in a process and kept until it ends: all
/// caches, in whatever thread, share them. Of other aspects the few last used are kept.
class OperatorCache
{
 public:
  /// Computes the operators of a grid, whole and (nx even) symmetric, for patches from `widest` times as wide as long
  /// to `longest` times as long as wide, so that find() computes and allocates nothing for them later.
  /// @throw std::invalid_argument as InfluenceOperator.
  void prepare(int nx, int ny);

  static constexpr double widest = 4;    ///< of the patches prepared for, width over length [-]
  static constexpr double longest = 16;  ///< length over width [-]

  /// The operator for a grid; computed now if it is new. Aspects within 1e-9 of a rung count as the rung.
  /// @throw std::invalid_argument as InfluenceOperator.
  std::shared_ptr<const InfluenceOperator> find(int nx, int ny, bool symmetric, double aspect);

 private:
  struct Entry
  {
    std::shared_ptr<const InfluenceOperator> influence;
    bool rounded_aspect = false;
    unsigned long last_use = 0;
  };
  struct Family
  {
    int nx = 0, ny = 0;
    bool symmetric = false;
    std::vector<Entry> entries;  ///< by rising aspect
  };

  Family& family(int nx, int ny, bool symmetric);
  static void forgetOldest(Family& family);

  std::vector<Family> families_;
  unsigned long uses_ = 0;
};
}  // namespace wheel_rail_contact::core
