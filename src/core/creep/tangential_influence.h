// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/normal/operator/lanes.h"

namespace wheel_rail_contact::core
{
/// Displacements by a uniform traction on a rectangle, times pi G / traction: of the wheel relative to the rail, with
/// the traction on the wheel and the opposite one on the rail.
struct TangentialInfluence
{
  double xx = 0, yy = 0;  ///< along the traction, which is along x or y [m]
  double xy = 0;          ///< across the traction [m]
};

/// Influence at (x, y) [m] from the centre of a rectangle dx × dy [m], on half-spaces of equal material.
///
/// A force F at a point (Cerruti 1882; Johnson 1985, eq. 3.75) displaces both bodies against one another by F / (pi G)
/// times (1/rho - nu y²/rho³) along it, where y is across it, and times nu x y / rho³ across it. As x²/rho³ + y²/rho³ =
/// 1/rho, three integrals are sufficient. Their antiderivatives are y ln(x + rho) of x²/rho³, x ln(y + rho) of y²/rho³
/// and -rho of x y / rho³; compare Kalker (1990), section 4.2.
TangentialInfluence tangentialInfluence(double x, double y, double dx, double dy, double poisson);

/// Influence coefficients of a grid by the distance of its cells, for cells of width 1. They depend only on the aspect
/// of the cells; a smaller grid uses a part of the table.
class TangentialTable
{
 public:
  /// Coefficients of one distance along the track: [j] is that of j columns, from -(columns - 1), and is followed by
  /// zeros.
  struct Row
  {
    const double *xx, *xy, *yy;
    double sign;  ///< factor of xy, which is odd in x
  };

  /// True if the table has the coefficients of a grid.
  bool serves(int rows, int columns, double aspect, double poisson) const;
  /// Computes the table.
  void set(int rows, int columns, double aspect, double poisson);
  /// Coefficients for the displacement of a row by the traction in another one, `ahead` rows before it.
  Row row(int ahead) const
  {
    const double* at = table_.data() + 3 * (ahead < 0 ? -ahead : ahead) * line_ + centre_;
    return {at, at + line_, at + 2 * line_, ahead > 0 ? -1.0 : 1.0};
  }

 private:
  int rows_ = 0, columns_ = 0;
  double aspect_ = 0, poisson_ = 0;
  int line_ = 0;    ///< doubles of a kind in a row of the table
  int centre_ = 0;  ///< place of the distance 0 in them
  LaneBuffer table_;
};

/// The tables of the last few aspects.
class TangentialTables
{
 public:
  /// Table of a grid. Computes it, and then allocates, unless it is one of the last tables. The reference is valid
  /// until the next call.
  const TangentialTable& find(int rows, int columns, double given_aspect, double poisson);

 private:
  std::vector<TangentialTable> tables_;
  std::vector<long> last_use_;
  long uses_ = 0;
};
}  // namespace wheel_rail_contact::core
