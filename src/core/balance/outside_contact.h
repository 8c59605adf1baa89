// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "core/balance/grid_layout.h"
#include "core/track/gap.h"
#include "core/track/rail_search.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// A grid on the rail, for a patch of the problem.
struct PlacedGrid
{
  GridLayout layout;
  double half_length = 0;  ///< of the expected pressure along the track [m]
  bool whole = true;       ///< it covers the whole overlap
};

/// Sets the displacement of the columns of each grid by the forces in the columns of the others: that of a point force
/// on a half-space (Johnson 1985, eq. 3.22b), at the root mean square distance of two half-ellipses along the track,
/// and projected onto the normal.
/// @param columns  of each grid
void couple(const std::vector<PlacedGrid>& grids, const std::vector<std::vector<SurfaceColumn>>& columns,
            CurvedProblem& problem);

/// Contact outside of the grids of a wheel, which a solution on these grids does not show.
///
/// Beside a contact, the gap of the displaced surfaces grows with the distance from the contact. There is another
/// contact only if the gap falls again farther away, below zero.
class OutsideContact
{
 public:
  /// Keeps references to all of them: the grids of the solution, and their columns.
  OutsideContact(const RailSearch& search, const std::vector<PlacedGrid>& grids,
                 const std::vector<std::vector<SurfaceColumn>>& columns)
      : search_(search), grids_(grids), columns_(columns)
  {
  }

  /// True if other grids for the same patches contain the whole contact: no pressure reaches the edge of one that the
  /// overlap exceeds, and the surfaces outside of them, displaced by the forces, do not touch.
  bool isContained(const std::vector<PlacedGrid>& others, const std::vector<OverlapInterval>& intervals,
                   const NormalProblem& problem, const NormalSolution& solution);

 private:
  bool isPossible(const std::vector<OverlapInterval>& intervals, const NormalProblem& problem,
                  const NormalSolution& solution);
  template <typename Station>
  bool mayTouchFarther(const NormalProblem& problem, const NormalSolution& solution, Station station,
                       Station end) const;
  double displacementAt(const OverlapStation& station, const NormalProblem& problem,
                        const NormalSolution& solution) const;

  const RailSearch& search_;
  const std::vector<PlacedGrid>& grids_;
  const std::vector<std::vector<SurfaceColumn>>& columns_;
  std::vector<std::pair<double, double>> spans_;  ///< parameters of the rail profile at the ends of the other grids [m]
  std::vector<OverlapStation> stations_;
  std::vector<Eigen::ArrayXd> column_forces_;  ///< of each patch [N]
};
}  // namespace wheel_rail_contact::core
