// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "wheel_rail_contact/core/creep.h"

namespace wheel_rail_contact::core
{
/// Compliance of a patch in the simplified theory: displacement over traction [m/Pa], so that its tractions without a
/// bound have the forces of the linear theory (Kalker 1982; Kalker 1990, section 2.2): 8a / (3 G C11) for x, 8a / (3 G
/// C22) for y, pi a sqrt(a/b) / (4 G C23) for spin.
struct Flexibility
{
  double x = 0, y = 0, spin = 0;
};

/// Velocity of the slip of rigid bodies [m/s].
double slipVelocity(double speed, const Creepage& creepage);

/// Creepage of a column of the grid, at its own place. In a plane patch the spin changes the one along x.
Creepage creepageOf(const CreepProblem& problem, int column);

/// Coefficient of friction of a column.
double frictionOf(const CreepProblem& problem, int column);

/// Work of a force on the wheel that becomes heat, per length of the way [N].
inline double workOf(const CreepForce& force, const Creepage& creepage)
{
  return -(force.x * creepage.x + force.y * creepage.y + force.moment * creepage.spin);
}

/// Factor of the pressures that makes their sum the normal force [-].
double pressureScale(const CreepProblem& problem);

/// Calls visit(k, weight) for each column that belongs together with column `j`, itself first: until a column without
/// force. The weight is min(f) / min(f1, f2), where f1 and f2 are the forces of the two columns, and min(f) is the
/// least one from one to the other.
template <typename Force, typename Visit>
void visitConnected(int count, int j, const Force& force, const Visit& visit)
{
  visit(j, 1.0);
  for (const int step : {1, -1})
  {
    double least = force(j);
    for (int k = j + step; k >= 0 && k < count && least > 0 && force(k) > 0; k += step)
    {
      least = std::min(least, force(k));
      const double smaller = std::min(force(j), force(k));
      visit(k, least < smaller ? least / smaller : 1.0);
    }
  }
}

/// A column of the pressure as a semi-ellipse with its first two moments.
struct CreepStrip
{
  double force = 0;         ///< normal force [N]; 0 without load
  double centre = 0;        ///< x of its centre [m]
  double half = 0;          ///< half its length [m]
  double area = 0;          ///< [m^2]
  Flexibility flexibility;  ///< of its ellipse
  double creepage_x = 0;    ///< mean longitudinal creepage of its ellipse, weighted with the forces [-]
  double middle = 0;        ///< x of the centre of pressure of its ellipse [m]
};

/// Strips of a patch, each with the ellipse of the strips around it.
///
/// The ellipse has the area of the strips, and the ratio of their second moments. Strips count with the weight of
/// visitConnected(): one where the force has one maximum across the patch, as in an ellipse, and zero beyond a column
/// without load. Nothing jumps where two contacts join on a grid. The weight is our own.
class CreepStrips
{
 public:
  /// Area [m^2] of an ellipse, and the ratio of its semi-axes, along over across.
  struct Ellipse
  {
    double area = 0, ratio = 0;
  };

  /// Finds the strips of a valid pressure. Allocates no memory for numbers of columns that it has had before.
  const std::vector<CreepStrip>& find(const CreepProblem& problem);
  /// The strips at other creepages.
  const std::vector<CreepStrip>& roll(const CreepProblem& problem);
  /// Finds forces and lengths of the strips only.
  void measure(const CreepProblem& problem);
  /// Ellipse of measured strips from one to another, which may lie in a strip: a share of it counts.
  Ellipse ellipseOf(const CreepProblem& problem, double first, double end) const;

 private:
  struct Sums;
  double forceOf(int column) const;
  double areaOf(const CreepProblem& problem, int column) const;
  bool hasOnePeak(int column) const;
  void addTo(Sums& sums, const CreepProblem& problem, int column, double weight) const;
  void setEllipse(const CreepProblem& problem, int column);

  std::vector<CreepStrip> strips_;
  Eigen::MatrixXd shares_;  ///< of the strips (rows) in the force of the ellipse of each strip (columns) [-]
  Eigen::VectorXd creepages_;
};
}  // namespace wheel_rail_contact::core
