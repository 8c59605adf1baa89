// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/balance/wheelset_balance.h"
#include "core/stress/stress_search.h"

namespace wheel_rail_contact::core
{
/// Stress beneath the patches of a wheelset, as StressConfig requires it.
class StressBeneath
{
 public:
  /// Keeps a reference to `config`, which must outlive the object.
  explicit StressBeneath(const ContactModelConfig& config) : config_(config) {}

  /// Fills the stress in wheel and rail beneath an island of a wheel, whose other members are set. All pressure on the
  /// grid of the island counts, so that nothing jumps where two islands merge. That on other grids does not.
  void fill(Side side, const WheelsetBalance& balance, std::size_t island, PatchResult& patch);

 private:
  void fillBody(double poisson, const ColumnRange& columns, const SemiAxes& axes, double max_pressure,
                PatchStress& stress);

  const ContactModelConfig& config_;
  StressSearch search_;
  PatchGrid grid_;            ///< whole grid of the island; y is outward, from the centre of pressure
  Eigen::ArrayXXd pressure_;  ///< its pressure [Pa]
};
}  // namespace wheel_rail_contact::core
