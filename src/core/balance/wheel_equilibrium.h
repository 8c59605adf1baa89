// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/balance/rail_support.h"
#include "core/balance/wheel_contact.h"
#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact::core
{
/// What the search of a wheel keeps of its last solution.
struct KeptResult
{
  bool grids = false;     ///< it starts on the same grids, see OverlapGrids::Choice
  bool response = false;  ///< derivatives, which hardly differ on another grid: respond() then does nothing
};

/// One wheel on its rail, which bends. Side axes.
///
/// Unknown are the forces on the rail, whose deflection is compliance * forces, and under a load the height. Where the
/// contact's own lateral force bends the rail, the equilibrium is the minimum of the potential energy: the elastic
/// energy of contact and rail and, under a load, load times height. Newton's method with the stiffness of the contact
/// finds it. The contact is solved for a rail at rest: the rail deflects a hundred times as far as the surfaces. A
/// step after which the energy is higher is shortened (Levenberg 1944, Marquardt 1963).
class WheelEquilibrium
{
 public:
  /// Keeps references to `config` and `solver`, which must outlive the object.
  /// @param accuracy  largest opening by the remaining deflection of the rail, over the overlap [-]: see opening()
  WheelEquilibrium(const ContactModelConfig& config, Side side, NormalSolver& solver, double accuracy);

  /// The next solution starts from an undeflected rail.
  void reset();
  /// Moves along the line to x [m], which the sections of the rail contain.
  void moveTo(double x);
  /// Sets the course of the rail there.
  void setCourse(const RailCourse& course)
  {
    const RailCourse& before = rail_.course();
    if (placed_ && !(course.rise == before.rise && course.motion == before.motion))
    {
      placed_->setConstant(NAN);  // it is to be placed again, with the same profile
    }
    rail_.setCourse(course);
  }
  /// Sets the rim of the wheel, if it is not round.
  void setRim(const WheelRim& rim)
  {
    rim_ = rim;
    placed_ = placed_ ? std::optional<Eigen::Vector3d>(Eigen::Vector3d::Constant(NAN)) : std::nullopt;
  }
  const WheelRim& rim() const { return rim_; }
  /// False if an edge of the rail places the contact, see RailCourse.
  bool isSmooth() const { return rail_.course().smooth; }
  /// Rail in the ideal track at the place of the last moveTo().
  const PlacedRail& restingRail() const { return rail_.atRest(); }
  /// The rail on its supports.
  const SupportedRail& support() const { return rail_; }
  /// Sets what else moves the rail. The start is the deflection of the last solution.
  /// @param lateral    given lateral force, outward positive [N]; only without RailBendingConfig::LateralForce::contact
  /// @param displaced  displacement of the rail, besides that by this wheel and RailBendingConfig::prescribed
  void setRail(double lateral, const RailDeflection& displaced);
  /// Sets the friction on the rail, along its coordinates. It is constant in a search.
  void setFriction(const Eigen::Vector3d& forces) { rail_.bear(forces); }

  /// Finds height and deflection at a pose under a load [N]; the height of `pose` is the start. Without a positive
  /// load, the height of first touch.
  WheelStatus solveUnderLoad(const WheelsetPose& pose, double load, const KeptResult& kept = {})
  {
    return load > 0 ? search(pose, load, kept) : touchAtRest(pose);
  }
  /// Finds the deflection at a given pose.
  WheelStatus solveAtPose(const WheelsetPose& pose, const KeptResult& kept) { return search(pose, 0, kept); }

  /// Height of the axle centre in the last solution [m].
  double height() const { return height_; }
  /// Computes the derivatives of height, moment and deflection, which takes a few products with the influence matrix.
  /// Before this call, rate() is for a constant distribution of the pressure and constant forces on the rail.
  void respond();
  /// True if rate() needs no respond().
  bool responded() const { return response_.is_exact || !loaded_; }
  /// What changes in equilibrium.
  enum Output
  {
    height_rate,   ///< height of the axle centre [m]
    moment_rate,   ///< moment() [N m]; of the roll and the lateral position only with moments in balance
    lateral_rate,  ///< forces on the rail along its coordinates, the first of three [N], [N m]
    outputs = lateral_rate + 3
  };
  /// By what it changes.
  enum Input
  {
    by_roll,     ///< roll of the wheel, with the load kept [rad]
    by_lateral,  ///< movement of the wheel outward, with the load kept [m]
    by_load,     ///< load [N]
    inputs
  };
  /// Change of height or moment per unit of an input.
  double rate(Output output, Input input) const;
  /// Change of the height by a roll of the rail about its reference point, outward positive [m/rad].
  double heightPerRailRoll() const { return loaded_ ? contact_.solved().heightPer(rail_roll) : 0; }
  /// Largest opening of the gap by a roll [rad] and by the deflection under a change of the load [N], over the overlap
  /// [-]: see SolvedContact::opening().
  double opening(double roll, double load) const;
  /// Prepares the next solution for a movement of the wheel outward [m], a roll [rad] and a change of the load [N]: its
  /// start is the deflection that follows.
  void predict(double lateral, double roll, double load);
  /// True if the wheel carries load.
  bool loaded() const { return loaded_; }
  /// Forces and deflection of the rail, with friction.
  RailResult rail() const;
  /// Moment of the contact on the wheel about the axle centre, side axes: positive if it lifts the wheel [N m].
  double moment() const { return loaded_ ? contact_.solved().forces()[wheel_roll] : 0; }

  WheelContact& contact() { return contact_; }
  const WheelContact& contact() const { return contact_; }

 private:
  struct Trial;

  /// Derivatives of the solution.
  struct Response
  {
    bool is_exact = false;  ///< of the stiffness of a contact on the same rail; otherwise of a constant distribution
    /// Those of forces on the rail may be of an earlier solution.
    Eigen::Matrix<double, outputs, inputs> rates = Eigen::Matrix<double, outputs, inputs>::Zero();
    /// Of the height by forces on the rail, through its deflection [m/N].
    Eigen::Vector3d height_per_force = Eigen::Vector3d::Zero();
    Eigen::Matrix3d per_force = Eigen::Matrix3d::Zero();  ///< of the forces by forces [-], negative
  };

  bool isUnderLoad() const { return contact_.problem().control == NormalProblem::Control::load; }
  WheelStatus search(const WheelsetPose& pose, double load, const KeptResult& kept);
  WheelStatus solveOn(const Eigen::Vector3d& forces, const WheelsetPose& pose, double load, OverlapGrids::Choice choice,
                      Trial& trial);
  bool isEquilibrium(const Trial& trial, Eigen::Vector3d& step);
  static bool isNearlyClosed(const Trial& trial);
  bool isNear(const Eigen::Vector3d& step) const;
  WheelStatus accept(const Trial& trial, const Eigen::Vector3d& step, WheelStatus status);
  bool jumps(const Trial& best, const Trial& trial) const;
  double shortened(const Trial& best, const Trial& trial, bool jump) const;
  Eigen::Vector3d restForces() const;
  WheelStatus touchAtRest(const WheelsetPose& pose);
  void place(const Eigen::Vector3d& forces);
  Eigen::Vector3d target() const;
  Eigen::Vector3d step(const Eigen::Vector3d& open) const;
  static MotionVector railMove(const Eigen::Vector3d& move);
  void approximateRates();
  void setRates(const MotionMatrix& stiffness);

  const ContactModelConfig& config_;
  double accuracy_;
  SupportedRail rail_;
  WheelRim rim_;
  WheelContact contact_;
  bool own_force_ = true;
  double given_lateral_ = 0;
  Eigen::Vector3d forces_ = Eigen::Vector3d::Zero();  ///< on the rail, along its coordinates
  std::optional<Eigen::Vector3d> placed_;             ///< coordinates at which the rail lies, since moveTo()
  double height_ = 0, touch_slope_ = 0;
  bool loaded_ = false;
  Response response_;
};
}  // namespace wheel_rail_contact::core
