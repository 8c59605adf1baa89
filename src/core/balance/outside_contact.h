// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/track/gap.h"
#include "core/track/rail_search.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// A grid on the rail, for a patch of the problem.
struct PlacedGrid
{
  SurfaceOrigin origin;
  double half_length = 0;  ///< of the expected pressure along the track [m]
  bool whole = true;       ///< it covers the whole overlap
};

/// Variance of the position along the track in a half-elliptic pressure [m²].
double pressureVariance(double half_length);

/// Displacement of a half-space by a point force (Johnson 1985, eq. 3.22b) [m/N].
/// @param variance  mean square distance along the track [m²]
/// @param y, z      distance in the section [m]
double displacementPerForce(double modulus, double variance, double y, double z);

/// Contact outside of the grids of a wheel, which a solution on these grids does not show.
///
/// Beside a contact, the gap of the displaced surfaces grows with the distance from the contact. There is another
/// contact only if the gap falls again farther away, below zero.
class OutsideContact
{
 public:
  /// Keeps references to all of them.
  OutsideContact(const RailSearch& search, const std::vector<PlacedGrid>& grids,
                 const std::vector<std::vector<SurfaceColumn>>& columns)
      : search_(search), grids_(grids), columns_(columns)
  {
  }

  /// True if the surfaces may touch outside of the grids, displaced by the forces in them.
  /// @param spans  parameters of the rail profile between which a grid lies [m]
  bool isPossible(const std::vector<OverlapInterval>& intervals, const std::vector<std::pair<double, double>>& spans,
                  const NormalProblem& problem, const NormalSolution& solution);

 private:
  template <typename Station>
  bool mayTouchFarther(const std::vector<std::pair<double, double>>& spans, const NormalProblem& problem,
                       const NormalSolution& solution, Station station, Station end) const;
  double displacementAt(const OverlapStation& station, const NormalProblem& problem,
                        const NormalSolution& solution) const;

  const RailSearch& search_;
  const std::vector<PlacedGrid>& grids_;
  const std::vector<std::vector<SurfaceColumn>>& columns_;
  std::vector<OverlapStation> stations_;
  std::vector<Eigen::ArrayXd> column_forces_;  ///< of each patch [N]
};
}  // namespace wheel_rail_contact::core
