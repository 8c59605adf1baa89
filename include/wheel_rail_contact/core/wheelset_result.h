// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "wheel_rail_contact/core/creep.h"
#include "wheel_rail_contact/core/normal_problem.h"
#include "wheel_rail_contact/core/rail_compliance.h"
#include "wheel_rail_contact/core/stress.h"
#include "wheel_rail_contact/core/track.h"

namespace wheel_rail_contact::core
{
/// Pose and load of a wheelset at one instant: the input of WheelsetContact::evaluate().
///
/// Track frame: x forward, y left, z up; z = 0 is the plane on the tops of both undeflected rails. The axle is rolled
/// first, then yawed (fixed axes). A value that is not finite or beyond its limit below gives a result with the status
/// ContactStatus::invalid_input.
struct WheelsetState
{
  double y = 0;  ///< lateral displacement of the axle centre, to the left positive [m]; at most 0.1 m from the
                 ///< middle of both displaced rails
  /// Height of the axle centre [m]; |z| <= 1. Used only if WheelsetConfig::solve_height_and_roll is false.
  double z = 0;
  double yaw = 0;  ///< rotation of the axle about z, positive to the left [rad]; |yaw| <= 0.2
  /// Rotation of the axle about x, positive if the left wheel is raised [rad]; |roll| <= 0.2. Used only if
  /// WheelsetConfig::solve_height_and_roll is false.
  double roll = 0;
  /// Rotation of the wheelset about its axle, positive as it rolls forward [rad]. Used only with
  /// WheelsetConfig::out_of_round.
  double pitch = 0;
  /// Vertical force on the axle centre, up positive [N], of everything but the normal pressure of the rails: of the
  /// vehicle, the weight of the wheelset itself (negative), inertia, and friction. With CreepConfig::method, the
  /// friction of the contacts is not part of it. |force_z| <= 1e8. Not required if height and roll are given.
  double force_z = 0;
  /// Moment on the axle centre about x [N m]: a positive moment unloads the left wheel. |torque_x| <= 1e8. Not required
  /// if height and roll are given. With Balance::wheel_loads, it is the moment that the vertical forces of the rails
  /// balance alone, at the running circles: it also contains the moment of all lateral forces on the wheels. With
  /// Balance::moments, it is the moment of all forces except those of the normal pressure: of the vehicle, and of
  /// friction. With CreepConfig::method, the friction of the contacts is not part of it in either case.
  double torque_x = 0;
  /// Lateral force on the rail of each Side, outward positive [N]; at most 1e8. Used only with
  /// RailBendingConfig::LateralForce::topic.
  Sides<double> rail_lateral_force{};
  /// Displacement of the rail of each Side at this wheelset, besides its deflection under this wheel: by a track model
  /// of the caller, or by the forces of other wheelsets. At most 0.1 m and 0.2 rad. Added to RailBendingConfig.
  Sides<RailDeflection> rail_displacement{};
  /// Velocity of the rail of each Side by its vibration, at most 1000 m/s and 10 000 rad/s. Used only with
  /// CreepConfig::method.
  Sides<RailRates> rail_velocity{};
  /// Velocities of the axle, at most 1000 m/s and 10 000 rad/s; used only with CreepConfig::method. Below 0.01 m/s
  /// there are no creep forces. The vertical velocity and the roll rate are used only if height and roll are given:
  /// where they are solved, the wheels follow their rails. The rotation is used only with Rotation::given.
  WheelsetMotion motion{};
  /// False: `motion` is relative to the track frame, which turns on a line with a design, and its speed is that of the
  /// frame along the centre line. True: it is over ground, and contains the motion of the frame.
  bool motion_over_ground = false;
  double x = 0;         ///< position of the axle centre along the track [m]; not checked, only copied to the result
  double distance = 0;  ///< place of the wheelset on TrackConfig::line and on rails with sections [m]
};

/// Whether a result is usable, and if not, why. The numbers are those of the message, which also has NO_TRANSFORM = 5.
enum class ContactStatus : std::uint8_t
{
  ok,                ///< every wheel carries its load; usable
  lift_off,          ///< at least one wheel carries no load, the other one is solved; usable
  off_profile,       ///< the contact would be beyond the end of a profile; not usable
  not_converged,     ///< normal solution, balance, coupling with the rails or friction did not converge; not usable
  invalid_input,     ///< a value of the state is NaN, infinite or beyond its limit; not usable
  outside_line = 6,  ///< the place of the wheelset is not on the line, or beyond the sections of a rail; not usable
  too_deep           ///< the given height is more than 10 mm below first touch, or was never set; not usable
};

/// Name of a status, as in the message: "OK", "LIFT_OFF", ... Also of NO_TRANSFORM, which only a message
/// has; "unknown" for any other number.
inline const char* nameOf(ContactStatus status)
{
  constexpr std::array names{"OK",           "LIFT_OFF",     "OFF_PROFILE", "NOT_CONVERGED", "INVALID_INPUT",
                             "NO_TRANSFORM", "OUTSIDE_LINE", "TOO_DEEP"};
  const auto number = static_cast<std::size_t>(status);
  return number < names.size() ? names[number] : "unknown";
}

/// Deflection of one rail and the forces on it, in the axes of its side: outward (away from the track centre) and up.
struct RailResult
{
  RailDeflection deflection;  ///< whole displacement of the rail head from its place in the ideal track
  /// Its part by the line (TrackConfig::line) and with the state (WheelsetState::rail_displacement).
  RailDeflection given;
  /// Lateral force that bends the rail, outward positive [N]; its source is RailBendingConfig::lateral_force.
  double lateral_force = 0;
  double vertical_force = 0;  ///< vertical force of the wheel on the rail, down positive [N]
  double moment = 0;  ///< moment of both forces about the reference point of the head, outward roll positive [N m]
  /// Direction of the rail: change of its displacement by the line, and of the cant, along the track [-], [rad/m].
  RailRates slope;
};

/// Largest plausible contact force of a wheel: about ten times that of a freight wheel [N]. That of a model is smaller
/// by the square of its modelScale().
constexpr double plausible_force = 1e6;

/// Contact forces of all patches of a wheel on its rail.
struct WheelForces
{
  double vertical = 0;           ///< whole vertical force Q, of normal pressure and friction, down positive [N]
  double lateral = 0;            ///< whole lateral force Y, of normal pressure and friction, outward positive [N]
  double friction_vertical = 0;  ///< part of Q by friction [N]
  double friction_lateral = 0;   ///< part of Y by friction [N]
};

/// Friction in a patch, in the patch frame.
struct PatchCreep
{
  Creepage creepage;          ///< of the wheel relative to the rail
  CreepForce force;           ///< of the rail on the wheel
  double vertical_force = 0;  ///< vertical part of it on the rail, down positive [N]
  double lateral_force = 0;   ///< lateral part of it on the rail, outward positive [N]
  double adhesion_share = 0;  ///< resultant over the friction limit [-]
  double power = 0;           ///< dissipated power [W]
  double error_estimate = 0;  ///< of the forces over the friction limit [-]; of the method and its grid, not a bound
  /// Traction on the wheel along x in each cell of the pressure [Pa]; empty without CreepConfig::field and `exact`.
  Eigen::ArrayXXd traction_x;
  Eigen::ArrayXXd traction_y;  ///< the same along y [Pa]
};

/// Force and moment, track axes.
struct Wrench
{
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< [N]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< about the axle centre [N m]

  /// Adds another one about the same point.
  Wrench& operator+=(const Wrench& added)
  {
    force += added.force;
    moment += added.moment;
    return *this;
  }
};

/// True if the result may be used: the status is `ok` or `lift_off`.
inline bool isUsable(ContactStatus status)
{
  return status == ContactStatus::ok || status == ContactStatus::lift_off;
}

/// Pose of a patch frame, in track axes. Origin: centre of pressure, on the rail. Axes: x forward, y left in the
/// tangent plane, z along the resultant of the pressure, out of the rail. The frame is pitched about y, then rotated
/// about x (fixed axes).
struct PatchPose
{
  double x = 0;         ///< position of the origin, from the axle centre [m]
  double y = 0, z = 0;  ///< position of the origin, track frame [m]
  double angle = 0;     ///< rotation about x, right-handed [rad]
  double pitch = 0;     ///< rotation about y before it: minus the angle of the rail along the track [rad]

  /// Rotation of the patch frame.
  Eigen::Quaterniond rotation() const
  {
    return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY());
  }
};

/// One contact patch of a result.
struct PatchResult
{
  Side side = Side::left;   ///< side of the wheel
  std::string_view method;  ///< method that solved the patch, named as in toString(NormalMethod); never "auto"
  PatchPose pose;           ///< patch frame in the track frame
  /// Angle between tangent plane and track plane [rad]. Positive where the wheel presses the rail outward, as on a
  /// conical tread or a flange; negative at the back of a flange.
  double contact_angle = 0;
  double normal_force = 0;  ///< resultant of the pressure, compressive positive [N]; along z of the patch frame
  /// Slope of the surface of the rail along the track, in the patch frame, at the centre of pressure [-]; upward
  /// positive.
  double slope_along = 0;
  double approach = 0;  ///< approach of wheel and rail along the patch normal, from first touch of the patch [m]
  double area = 0;      ///< contact area [m²]; its edge is located to a fraction of a cell
  /// Highest pressure [Pa], found between the cells and corrected for the bias of the grid. It may be below the
  /// pressure of the highest cell.
  double max_pressure = 0;
  /// Largest of the estimated relative errors of max_pressure, area and approach [-]: that of the solution, and that by
  /// the noise of measured profiles (Profile::errorAt()). It is an estimate, not a bound.
  double error_estimate = 0;
  int iterations = 0;   ///< number of products with the influence matrix; see NormalSolution::iterations
  double residual = 0;  ///< largest violation of the contact conditions, relative [-]; see NormalSolution::residual
  /// Half the angle by which the section of wheel or rail turns across the patch [rad], the larger of the two.
  double half_space_ratio = 0;
  /// Bound of the relative error of max_pressure and area because both bodies are taken to be half-spaces [-], a
  /// function of half_space_ratio; 1: not known. It adds to error_estimate. See doc/half_space.md.
  double model_error = 0;
  /// What the method leaves out of the contact of curved surfaces: "column normals" (each column of cells has its own),
  /// "patch coupling" (patches deform one another), or both, separated by a comma; empty: nothing.
  std::string_view left_out;
  double vertical_force = 0;  ///< Q, of normal pressure and friction, on the rail, down positive [N]
  double lateral_force = 0;   ///< Y, of normal pressure and friction, on the rail, outward positive [N]
  /// Semi-axis a along the track of the ellipse with the area of the patch and the ratio of its second moments about x
  /// and y of the patch frame [m].
  double semi_axis_along = 0;
  double semi_axis_across = 0;  ///< semi-axis b of this ellipse, across the track [m]
  double rolling_radius = 0;    ///< radius of the undeformed wheel at the centre of pressure [m]
  /// Place of the centre of pressure on the wheel's profile: arc length from the origin of the profile, outward
  /// positive [m].
  double wheel_s = 0;
  double rail_s = 0;  ///< the same on the rail's profile [m]
  double wheel_angle =
      0;  ///< place around the wheel: angle about the axle from its lowest line, forward positive [rad]
  /// Combined curvature of wheel and rail along the track at the centre of pressure, for an axle without yaw [1/m];
  /// convex positive. That of the rail is to second order over the contact.
  double curvature_along = 0;
  double curvature_across = 0;  ///< combined curvature of both profiles [1/m], convex positive
  /// Change of normal_force per approach along the normal, with the rail held and the other contacts unloaded [N/m]:
  /// that of a flat punch with the shape of the contact (Barber 2003). NaN where half_space_ratio is above 0.4 rad: the
  /// bodies do not approach along one normal there.
  double normal_stiffness = 0;
  PatchCreep creep;          ///< friction; all zero without CreepConfig::method
  PatchStress wheel_stress;  ///< in the wheel; all zero without StressConfig::depths
  PatchStress rail_stress;   ///< the same in the rail
  PatchGrid grid;            ///< grid of `pressure`
  Eigen::ArrayXXd pressure;  ///< nx × ny pressures [Pa], compressive positive; pressure(i, j) belongs to cell (i, j)
};

/// Derivatives of the contact of a wheelset, with ContactConfig::derivatives; otherwise empty. Track axes. An entry is
/// NaN where the derivative does not exist; WheelsetResult::reason then gives the reason. Columns of motion are there
/// with creep forces only.
struct ContactDerivatives
{
  /// Columns of `forces`: y, z [m], roll and yaw [rad] of the axle.
  static constexpr int positions = 4;
  /// Columns of `solution`: y [m], yaw [rad], force_z [N], torque_x [N m].
  static constexpr int givens = 4;
  /// Further columns of `forces` with creep forces: running speed, lateral and vertical velocity [m/s], roll rate, yaw
  /// rate, and rotation about the axle [rad/s].
  static constexpr int force_motions = 6;
  static constexpr int solution_motions = 4;  ///< of `solution`: the same without vertical velocity and roll rate

  /// Height and roll given. Rows: forces x, y, z [N] and moments x, y, z about the axle centre [N m] of both rails on
  /// the wheelset, as in WheelsetResult::rail_wrench. The deflection of the rails is included.
  Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor, 6, positions + force_motions> forces;
  /// Height and roll solved; otherwise empty. Rows: z [m], roll [rad], Q and Y of the left wheel, then of the right one
  /// [N].
  Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor, 6, givens + solution_motions> solution;
};

/// Contact of a wheelset with both rails in one state: the output of WheelsetContact::evaluate().
struct WheelsetResult
{
  ContactStatus status = ContactStatus::invalid_input;  ///< whether the result is usable; check it first
  std::string reason;  ///< one sentence: reason for the status, or a warning; empty if there is none
  /// The estimated error of the solution of at least one wheel is above ContactConfig::tolerance, or friction and the
  /// balance of the normal forces agree within 2 % of a wheel's force only (CreepConfig). The error of a single
  /// patch may be above it although its wheel is within it.
  bool above_tolerance = false;
  /// A contact is where points of a profile file are missing (ShapeError::missing): its shape is not known there, and
  /// the error estimate of the patch is at least 1.
  bool points_missing = false;
  /// Another equilibrium of the same state was found, in which the forces on the rails differ by more than 5 %: the
  /// result depends on the states before. Only with ContactConfig::check_branches.
  bool near_branch = false;
  /// The contact force of a wheel is beyond a plausible bound; `reason` gives it.
  bool implausible_force = false;
  double x = 0, y = 0, z = 0;      ///< axle centre in the track frame [m]; z is the solved (or given) height
  double yaw = 0, roll = 0;        ///< rotation of the axle [rad]; roll is the solved (or given) one
  double distance = 0;             ///< place of the wheelset on the line [m]; that of the state
  Sides<WheelForces> wheel;        ///< forces of each Side; valid only if the result is usable
  Wrench rail_wrench;              ///< of both rails on the wheelset, with friction; valid only if the result is usable
  double speed = 0;                ///< running speed along the track [m/s]; zero without creep forces
  double rotation = 0;             ///< of the wheelset about its axle [rad/s], given or free; zero without creep forces
  Sides<RailResult> rail;          ///< rail of each Side; valid only if the result is usable
  ContactDerivatives derivatives;  ///< empty unless the result is usable
  std::vector<PatchResult> patches;  ///< left side first; empty unless the result is usable
};
}  // namespace wheel_rail_contact::core
