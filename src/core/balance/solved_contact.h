// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/normal/solvers/contact_tangent.h"
#include "core/track/gap.h"

namespace wheel_rail_contact::core
{
/// Coordinates of wheel and rail. The forces along them are the wheel's load [N], its moment about the axle centre
/// [N m], and the outward force [N], the upward force [N] and the moment about the reference point of the head [N m] on
/// the rail. Side axes.
enum Motion
{
  wheel_up,      ///< wheel upwards [m]
  wheel_roll,    ///< roll about the axle centre [rad]
  rail_lateral,  ///< rail head outward [m]
  rail_up,       ///< rail head upwards [m]
  rail_roll,     ///< roll of the rail head about its reference point [rad], outward positive
  motions
};
using MotionVector = Eigen::Matrix<double, motions, 1>;
using MotionMatrix = Eigen::Matrix<double, motions, motions>;

/// Forces of a solved contact and what follows from them: a value, without references. Side axes.
///
/// The forces follow from the derivatives of the gap (SurfaceColumn); they are therefore the derivatives of the elastic
/// energy.
class SolvedContact
{
 public:
  /// Sets the solution of a problem; all of it is replaced.
  /// @param columns    of each patch
  /// @param axle       centre of the axle for which the gap is
  /// @param reference  reference point of the rail head
  void set(const std::vector<std::vector<SurfaceColumn>>& columns, const CurvedProblem& problem,
           const NormalSolution& solution, const PlanePoint& axle, const PlanePoint& reference);
  /// Sets no contact, as at first.
  void clear();

  /// True if there is pressure.
  bool isLoaded() const { return !loaded_.empty(); }
  /// Elastic energy [J].
  double energy() const { return energy_; }
  /// Forces along the coordinates.
  const MotionVector& forces() const { return forces_; }
  /// Openings of each patch for ContactTangent: by wheel_up, wheel_roll, rail_lateral and rail_roll. The rail moving up
  /// opens the gap as the wheel moving down does.
  const std::vector<Eigen::ArrayXXd>& openings() const { return openings_; }
  /// Derivatives of the forces with respect to the coordinates, with negative sign: elastic part and geometric part.
  /// @param elastic  of ContactTangent for these openings
  MotionMatrix stiffness(const ContactTangent::Stiffness& elastic) const;
  /// Their row wheel_up alone.
  MotionVector verticalStiffness(const ContactTangent::Forces& elastic) const;
  /// Height change of the axle centre per unit of a coordinate, under the same load and with the distribution of the
  /// pressure kept.
  double heightPer(Motion motion) const { return -forces_[motion] / forces_[wheel_up]; }
  /// Mean height of the columns over the reference point of the rail head, weighted with their normal forces [m].
  double heightOverReference() const;
  /// Largest opening of the gap under the pressure by a movement [m]. If the load is given, besides the one that a
  /// height change under the same load removes.
  double opening(const MotionVector& move) const;
  /// True if there is pressure beside columns without bodies, or at an end of the wheel profile.
  /// @param wheel_end  length of the wheel profile [m]
  bool isLoadedAtEnd(double wheel_end) const;

 private:
  /// A column under pressure.
  struct LoadedColumn
  {
    SurfaceColumn column;
    MotionVector opening;   ///< by each coordinate
    double force = 0;       ///< along its normal [N]
    double curvature = 0;   ///< of the wheel across the track [1/m]
    double width = 0;       ///< [m]
    bool at_bodies = true;  ///< the columns beside it have points of both bodies
  };

  MotionVector moved(const SurfaceColumn& column, double outward, double up) const;
  MotionMatrix geometricStiffness() const;

  PlanePoint axle_{}, reference_{};
  bool under_load_ = false;                ///< the load is given
  std::vector<Eigen::ArrayXXd> openings_;  ///< see openings()
  std::vector<LoadedColumn> loaded_;
  Eigen::VectorXd column_forces_;  ///< memory for those of a patch
  MotionVector forces_ = MotionVector::Zero();
  double energy_ = 0;
};
}  // namespace wheel_rail_contact::core
