// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "wheel_rail_contact/core/normal_problem.h"
#include "wheel_rail_contact/core/sides.h"

namespace wheel_rail_contact::core
{
/// Methods for the tangential problem of rolling contact.
enum class CreepMethod
{
  none,     ///< no friction
  linear,   ///< linear theory with saturation (Shen, Hedrick and Elkins 1983); not for large spin
  fastsim,  ///< simplified theory on strips (Kalker 1982)
  exact     ///< complete theory: steady rolling of half-spaces on the cells of the pressure (Kalker 1990)
};

/// All methods.
constexpr std::array<CreepMethod, 4> all_creep_methods{CreepMethod::none, CreepMethod::linear, CreepMethod::fastsim,
                                                       CreepMethod::exact};

/// Name of the method; a string with static lifetime.
const char* toString(CreepMethod method);

/// Method by its name.
/// @throw std::invalid_argument with the name if there is no such method.
CreepMethod creepMethodNamed(std::string_view name);

/// Velocity of the wheel relative to the rail at a contact, over the absolute running speed. Patch frame: x forward, y
/// left in the tangent plane, z out of the rail.
struct Creepage
{
  double x = 0;     ///< along x [-]
  double y = 0;     ///< along y [-]
  double spin = 0;  ///< rotation about z, right-handed [1/m]
};

/// Creep and spin coefficients of the linear theory [-].
struct KalkerCoefficients
{
  double c11 = 0;  ///< longitudinal creepage to longitudinal force
  double c22 = 0;  ///< lateral creepage to lateral force
  double c23 = 0;  ///< spin to lateral force; with the other sign, lateral creepage to moment
  double c33 = 0;  ///< spin to moment
};

/// Largest ratio a/b, and b/a, of the table of the coefficients.
constexpr double kalker_ratio_limit = 10;

/// Coefficients of an elliptic contact (Kalker 1990, table E3; also Johnson 1985, section 8.4).
///
/// The table has 19 ratios a/b from 0.1 to 10, and Poisson's ratios 0, 1/4 and 1/2. The polynomial of second order
/// through the latter three is used. Between the ratios the logarithm of a coefficient is linear in that of a/b. Beyond
/// the ends the last line is continued, as the asymptotic formulas are nearly powers of a/b.
/// @param ratio a/b [-], > 0: semi-axis a along the track, b across
/// @param poisson Poisson's ratio of both bodies [-], 0 to 0.5
/// @throw std::invalid_argument if a parameter is out of range.
KalkerCoefficients kalkerCoefficients(double ratio, double poisson);

/// Elasticity of two half-spaces under tangential traction. The displacements along the normal by a traction, and
/// tangential ones by the pressure, are neglected: for equal materials they cancel out.
struct ShearElasticity
{
  double modulus = 8.203125e10;  ///< shear modulus G [Pa], > 0: 1/G is the mean of both bodies. The default is steel
  double poisson = 0.28;         ///< Poisson's ratio nu [-], 0 to 0.5: nu/G is the mean of both bodies
};

/// Elasticity of wheel and rail.
/// @throw std::invalid_argument if a material is out of range, or nu of the pair is negative.
ShearElasticity shearElasticity(const Material& first, const Material& second);

/// Coulomb friction, optionally falling with the slip velocity w: mu(w) = mu ((1 - A) exp(-B w) + A) (Polach 2005,
/// Creep forces in simulations of traction vehicles running on adhesion limit, Wear 258). w is that of the bodies in
/// each column, or at the origin of a plane patch. The paper gives A = 0.4 and B = 0.6 s/m for a dry rail.
struct FrictionLaw
{
  double coefficient = 0.3;  ///< mu, at rest [-], 0 to 2
  double slip_share = 1;     ///< A: share of mu at infinite slip [-], 0 to 1; 1: constant
  double slip_decay = 0;     ///< B [s/m], >= 0; 0: constant

  /// Coefficient at a slip velocity [m/s], >= 0.
  double at(double slip_velocity) const;
};

/// Checks that all numbers are within their range. `group` is the text before their names in the message.
/// @throw std::invalid_argument with the name of the parameter, its value and the broken rule.
void validate(const FrictionLaw& law, const std::string& group);

/// Rolling with slip in one patch, whose pressure is known.
struct CreepProblem
{
  Creepage creepage;  ///< of the wheel relative to the rail, at the origin of the patch
  /// The same for each column of the grid, at its middle (x = 0) and along its own tangent plane, for a patch on a
  /// curved surface; not used by `linear`. Empty: the patch is plane.
  std::vector<Creepage> columns;
  /// Running speed [m/s]: the leading edge is at +x if it is positive, at -x if it is negative. Its value determines
  /// only the slip velocity of the friction law.
  double speed = 1;
  double normal_force = 0;  ///< [N], >= 0
  /// Semi-axis a of the ellipse that replaces the patch, along the track [m], > 0; used only by `linear`, and by the
  /// error estimate of `fastsim`.
  double semi_axis_along = 0;
  double semi_axis_across = 0;  ///< semi-axis b [m], > 0
  PatchGrid grid;               ///< cells of the pressure; not used by `linear`
  /// Pressure of each cell [Pa]; not used by `linear`. The other methods scale it to the normal force. Contacts that do
  /// not touch one another may lie on one grid.
  Eigen::ArrayXXd pressure;
  ShearElasticity elasticity;  ///< of both bodies
  FrictionLaw friction;        ///< of the patch
};

/// Reason for which a solution ended.
enum class CreepStatus
{
  converged,        ///< usable
  no_slip,          ///< no force: method `none`, no normal force, no friction, or no speed; usable
  iteration_limit,  ///< the tractions still change by more than the tolerance; not usable
  invalid_problem   ///< a number is not finite or out of range, or the shape of the pressure differs from the grid
};

/// Text of a status for messages.
const char* toString(CreepStatus status);

/// True if the forces may be used.
inline bool isUsable(CreepStatus status)
{
  return status == CreepStatus::converged || status == CreepStatus::no_slip;
}

/// Tangential force of the rail on the wheel, in the patch frame.
struct CreepForce
{
  double x = 0;       ///< [N]
  double y = 0;       ///< [N]
  double moment = 0;  ///< about z, right-handed [N m]
};

/// Result of a CreepSolver. Arrays keep their memory for the next solution.
struct CreepSolution
{
  CreepStatus status = CreepStatus::invalid_problem;  ///< whether the solution is usable; check it first
  CreepForce force;                                   ///< of the rail on the wheel
  /// Forces of each column on the wheel along its tangent plane, and their moment about its middle (x = 0); empty with
  /// `linear`. On a curved surface `force` is their sum as if the patch were plane.
  std::vector<CreepForce> columns;
  std::vector<double> limits;  ///< friction limit of each of these columns [N]
  double friction = 0;         ///< coefficient of friction at this slip velocity, the mean of the columns [-]
  double adhesion_share = 0;   ///< resultant of x and y over the friction limit [-]
  double power = 0;            ///< dissipated power [W], >= 0
  /// Estimated error of the forces over the friction limit [-], not a bound: of the method and its grid.
  double error_estimate = 0;
  int iterations = 0;  ///< sweeps over all cells; 0 with `linear`, 1 with `fastsim`
  /// Traction on the wheel along x in each cell of the pressure [Pa]. Only `exact` fills them.
  Eigen::ArrayXXd traction_x;
  Eigen::ArrayXXd traction_y;  ///< the same along y [Pa]
};

/// Solver for the tangential problem of one patch. An object keeps memory between solutions and is not thread-safe.
class CreepSolver
{
 public:
  virtual ~CreepSolver() = default;

  /// Solves `problem`. If `warm` is true and `solution` has tractions of the same shape, `exact` starts from them. For
  /// shapes that it has solved before, it allocates no memory. Does not throw for a numerical failure.
  void solve(const CreepProblem& problem, bool warm, CreepSolution& solution);
  /// Solves the last problem at other creepages (and another amount of the speed). All else in `problem`, and
  /// `solution`, are as the last call left them.
  void solveAgain(const CreepProblem& problem, CreepSolution& solution);

 protected:
  /// True if only creepages and speed differ from those of the last problem.
  bool isAgain() const { return is_again_; }

 private:
  /// Fills columns with their limits (or force, if the method has no columns), iterations, error estimate and tractions
  /// of a problem with friction limit > 0, whose numbers are valid but for grid and pressure. Returns the status.
  virtual CreepStatus fill(const CreepProblem& problem, bool warm, CreepSolution& solution) = 0;

  bool is_filled_ = false, is_again_ = false;
};

/// Creates a solver of the given method.
std::unique_ptr<CreepSolver> makeCreepSolver(CreepMethod method);

/// Elliptic contact with the pressure of Hertz.
struct CreepEllipse
{
  double semi_axis_along = 0;   ///< a, along the track [m], > 0
  double semi_axis_across = 0;  ///< b [m], > 0
  double normal_force = 0;      ///< [N], > 0
  int nx = 48;                  ///< cells along the track on 1.05 times the ellipse; used by `fastsim` and `exact`
  int ny = 48;                  ///< cells across the track
};

/// Problem of an elliptic contact, rolling forward, with the default elasticity and friction.
/// @throw std::invalid_argument if a number of the ellipse is out of range.
CreepProblem ellipseProblem(const CreepEllipse& ellipse, const Creepage& creepage);

/// Force on the wheel in an elliptic contact that rolls forward.
/// @throw std::invalid_argument if a number is out of range.
/// @throw std::runtime_error if the solution is not usable.
CreepForce ellipseCreepForce(const CreepEllipse& ellipse, const Creepage& creepage, CreepMethod method,
                             const FrictionLaw& friction = {}, const ShearElasticity& elasticity = {});

/// Motion of a wheelset, track axes.
struct WheelsetMotion
{
  double speed = 0;              ///< V: velocity of the axle centre along the track [m/s]
  double lateral_velocity = 0;   ///< of the axle centre, to the left [m/s]
  double vertical_velocity = 0;  ///< of the axle centre, up [m/s]; see followRails()
  double yaw_rate = 0;           ///< about z [rad/s]
  double roll_rate = 0;          ///< about x [rad/s]; see followRails()
  double rotation = 0;           ///< about the axle [rad/s], positive when it rolls forward
  double yaw = 0, roll = 0;      ///< rotation of the axle [rad], as in WheelsetResult; not read in a WheelsetState
};

/// Direction of the axle of a wheelset with this yaw and roll [rad], to the left; track axes.
Eigen::Vector3d axleDirection(double yaw, double roll);

/// A contact as seen from the wheelset, track axes.
struct ContactPlace
{
  /// Place on the undeformed wheel, from the axle centre [m]: that of the patch, less its approach along the normal.
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double angle = 0;    ///< rotation of the patch frame about x, right-handed [rad]
  double slope_y = 0;  ///< direction of the rail at the patch: change of its lateral place along the track [-]
  double slope_z = 0;  ///< change of its vertical place along the track [-]
  /// Velocity of the rail head at the patch, to the left [m/s]: by its deflection in time, not by its direction.
  double rail_velocity_y = 0;
  double rail_velocity_z = 0;  ///< the same, up [m/s]
};

/// Normal of the section of the rail at a contact, out of the rail; track axes.
Eigen::Vector3d sectionNormal(const ContactPlace& place);

/// Axes of a patch in track axes, as columns: along the rail, to the left in the tangent plane, out of the rail.
Eigen::Matrix3d patchAxes(const ContactPlace& place);

/// Creepages of a contact: velocity of the wheel's particles relative to those of the rail, over |V|; the spin is that
/// of the rotation vector along the normal, over |V|.
///
/// The particles of the rail stand still whatever its direction: its slopes in y and z cancel out of the velocities,
/// and only turn the axes of the patch.
/// @throw std::invalid_argument if the speed is not finite or zero.
Creepage creepages(const WheelsetMotion& motion, const ContactPlace& place);

/// Friction of the contacts of a wheelset. On a TrackConfig::line, the direction of the rails counts in the creepages.
/// Not with rail_sections.
struct CreepConfig
{
  /// Source of the rotation of the wheelset about its axle.
  enum class Rotation
  {
    given,  ///< WheelsetMotion::rotation
    free    ///< the one at which friction has no moment about the axle
  };
  CreepMethod method = CreepMethod::none;  ///< default: no friction
  Sides<FrictionLaw> friction;             ///< of each side
  Rotation rotation = Rotation::free;      ///< default: a wheelset that is neither driven nor braked
  bool field = false;                      ///< true: results have the tractions of each cell, with `exact`
};

/// Checks that every parameter is within its range.
/// @throw std::invalid_argument with the name of the parameter, its value and the broken rule.
void validate(const CreepConfig& creep);

/// Velocity of the wheel's particles relative to those of the rail along the normal of a contact [m/s], opening
/// positive.
double normalVelocity(const WheelsetMotion& motion, const ContactPlace& place);

/// Sets roll rate and vertical velocity of a wheelset whose wheels follow their rails: neither of the two contacts
/// opens or closes. A wheelset with one contact is given by the same place twice; its roll rate is then zero. So it is
/// where the roll hardly moves the wheels apart, near a contact angle of 1.26 rad of one wheel: the rate is not
/// determined there.
void followRails(const ContactPlace& left, const ContactPlace& right, WheelsetMotion& motion);
}  // namespace wheel_rail_contact::core
