// SPDX-License-Identifier: BSD-3-Clause
#include "result_check.h"

#include "../standard_headers.h"
#include "core/balance/rail_support.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core::stability
{
namespace
{
/// Relative rounding error of a sum over up to some thousand cells [-].
constexpr double rounding = 1e-9;
constexpr double least_radius = 5e-3;  ///< smaller than all radii of the rails [m]

double wheelLoad(const ContactModelConfig& config, const WheelsetState& state, Side side)
{
  const double transfer = 0.5 * state.torque_x / config.wheelset.halfBase();
  return -0.5 * state.force_z - sideSign(side) * transfer;
}

/// True for methods whose pressures meet the contact conditions in each cell.
bool meetsConditionsInCells(std::string_view method)
{
  return method != "hertz" && method != "kik_piotrowski";
}

/// True for methods that meet the load on a curved surface. The others take a patch as flat (PatchResult::left_out);
/// their load differs by the turn of the normals.
bool meetsLoad(const ContactModelConfig& config)
{
  return config.contact.method == NormalMethod::automatic || config.contact.method == NormalMethod::conjugate_gradient;
}

/// Forces of the pressures on a rail: outward, down, and moment about the reference point of the head.
struct Forces
{
  double outward = 0, down = 0, moment = 0;
  double sum = 0, height = 0;  ///< of the normal forces [N], and of their product with the height [N m]
};

void addForces(const PressedSurface& surface, const PlanePoint& reference, int first, int columns, Forces& forces)
{
  for (int j = first; j < first + columns; ++j)
  {
    const SurfaceColumn& column = surface.columns[j];
    const double force = surface.grid.cellArea() * surface.pressure.col(j).sum();
    const double outward = -force * column.perOutward(), down = force * column.perUp();
    forces.outward += outward;
    forces.down += down;
    forces.moment += outward * (column.z - reference.z) + down * (column.y - reference.y);
    forces.sum += force;
    forces.height += force * (column.z - reference.z);
  }
}

/// Size of a deflection: a roll counts as a displacement at this distance.
double sizeOf(const RailDeflection& deflection)
{
  constexpr double arm = 0.1;  // [m]
  return std::hypot(deflection.lateral, deflection.vertical) + arm * std::abs(deflection.roll);
}

RailDeflection difference(const RailDeflection& a, const RailDeflection& b)
{
  return {a.lateral - b.lateral, a.vertical - b.vertical, a.roll - b.roll};
}

SurfaceDisplacement displacementOf(const ContactModelConfig& config, Side side)
{
  return SurfaceDisplacement(contactModulus(config.wheel_material[side], config.rail_material[side]));
}

/// Depth of the overlap of the rigid bodies [m].
double overlapOf(const std::vector<PressedSurface>& surfaces)
{
  double least = -1e-15;
  for (const PressedSurface& surface : surfaces)
  {
    least = std::min(least, surface.gap.minCoeff());
  }
  return -least;
}
}  // namespace

ResultCheck::ResultCheck(const ContactModelConfig& config)
    : config_(config), displacement_(displacementOf(config, Side::left), displacementOf(config, Side::right))
{
}

void ResultCheck::fault(const char* what, double value)
{
  char text[200];
  std::snprintf(text, sizeof text, "%s (%.3g)", what, value);
  faults_.emplace_back(text);
}

const std::vector<std::string>& ResultCheck::faults(const WheelsetState& state, const WheelsetResult& result)
{
  faults_.clear();
  violation_ = 0;
  checkNumbers(result);
  if (!isUsable(result.status))
  {
    if (result.reason.empty())
    {
      fault("refused without a reason", static_cast<double>(result.status));
    }
    if (!result.patches.empty())
    {
      fault("refused with patches", static_cast<double>(result.patches.size()));
    }
    return faults_;
  }
  for (const PatchResult& patch : result.patches)
  {
    checkPatch(patch);
  }
  for (const Side side : sides)
  {
    checkLoads(state, result, side);
    checkDeflection(state, result, side);
    checkWheel(state, result, side);
  }
  return faults_;
}

void ResultCheck::checkNumbers(const WheelsetResult& result)
{
  double sum = result.y + result.z + result.yaw + result.roll;
  for (const Side side : sides)
  {
    const RailResult& rail = result.rail[side];
    const RailDeflection& d = rail.deflection;
    sum += d.lateral + d.vertical + d.roll + rail.lateral_force + rail.vertical_force + rail.moment;
  }
  for (const PatchResult& p : result.patches)
  {
    sum += p.pose.x + p.pose.y + p.pose.z + p.pose.angle + p.contact_angle + p.normal_force + p.approach + p.area +
           p.max_pressure + p.error_estimate + p.residual + p.half_space_ratio + p.model_error + p.pressure.sum();
  }
  if (!std::isfinite(sum))
  {
    fault("value not finite", sum);
  }
}

void ResultCheck::checkPatch(const PatchResult& patch)
{
  const PatchGrid& grid = patch.grid;
  if (!(patch.pressure.minCoeff() >= 0))
  {
    fault("negative pressure", patch.pressure.minCoeff());
  }
  if (!(patch.normal_force > 0 && patch.area > 0 && patch.approach > 0 && patch.error_estimate >= 0))
  {
    fault("force, area or approach not positive, or error estimate negative", patch.normal_force);
  }
  // Cells next to curvature discontinuities and edges are too high: by up to 9 % on 8 × 16 cells (300 random
  // wheelsets).
  if (!(patch.max_pressure >= 0.85 * patch.pressure.maxCoeff()))
  {
    fault("highest pressure more than 15 % below the highest cell", patch.max_pressure);
  }
  // The origin is the centre of pressure.
  const Eigen::ArrayXd along = patch.pressure.rowwise().sum(), across = patch.pressure.colwise().sum().transpose();
  double x = 0, y = 0;
  for (int i = 0; i < grid.nx; ++i)
  {
    x += along[i] * grid.x(i);
  }
  for (int j = 0; j < grid.ny; ++j)
  {
    y += across[j] * grid.y(j);
  }
  const double off = std::max(std::abs(x) / grid.dx, std::abs(y) / grid.dy) / patch.pressure.sum();
  if (off > 1e-6)
  {
    fault("the origin is not the centre of pressure; cells", off);
  }
}

/// Equilibrium of the vertical load of a wheel.
void ResultCheck::checkLoads(const WheelsetState& state, const WheelsetResult& result, Side side)
{
  constexpr double tolerance = 1e-7;
  double vertical = 0;
  for (const PatchResult& patch : result.patches)
  {
    vertical += patch.side == side ? patch.normal_force * std::cos(patch.contact_angle) : 0;
  }
  const double load = std::max(wheelLoad(config_, state, side), 0.0);
  if (config_.wheelset.solve_height_and_roll && meetsLoad(config_) && std::abs(vertical - load) > tolerance * load)
  {
    fault("vertical force of a wheel differs from its load", vertical - load);
  }
}

/// The deflection must equal the compliance table times forces and moment.
void ResultCheck::checkDeflection(const WheelsetState& state, const WheelsetResult& result, Side side)
{
  const RailBendingConfig& bending = config_.rail_bending;
  const RailResult& rail = result.rail[side];
  const RailDeflection& found = rail.deflection;
  RailDeflection expected = bending.prescribed;
  if (bending.model == RailBendingConfig::Model::none)
  {
    expected = {};
  }
  if (bending.model == RailBendingConfig::Model::compliance)
  {
    using LateralForce = RailBendingConfig::LateralForce;
    const double given =
        bending.lateral_force == LateralForce::topic ? state.rail_lateral_force[side] : bending.lateral_force_value;
    if (bending.lateral_force != LateralForce::contact && std::abs(given - rail.lateral_force) > rounding * 1e4)
    {
      fault("lateral force on the rail differs from the given one", rail.lateral_force);
    }
    expected = deflectionInTrack(bending.table[side], {rail.lateral_force, rail.vertical_force, rail.moment},
                                 config_.track.rail_inclination[side]);
  }
  expected += state.rail_displacement[side];
  const double scale = sizeOf(found), off = sizeOf(difference(expected, found));
  if (off > rounding * scale + 1e-15)
  {
    fault("deflection differs from the compliance table", off / scale);
  }
}

/// Builds the surfaces under the patches of a wheel and checks what belongs to them.
void ResultCheck::checkWheel(const WheelsetState& state, const WheelsetResult& result, Side side)
{
  const PlacedRail rail = restingRail(config_, side, state.distance).deflected(result.rail[side].deflection);
  const WheelsetPose pose = toSide(side, {result.y, result.z, result.yaw, result.roll});
  const PlacedWheel wheel(*config_.wheel_profile[side], config_.wheelset, side, pose);
  std::vector<PressedSurface> surfaces;
  try
  {
    surfaces = surfacesUnder(result.patches, side, wheel, rail);
  }
  catch (const std::runtime_error& error)
  {
    fault(error.what(), 0);
    return;
  }
  bool in_cells = true;
  for (const PressedSurface& surface : surfaces)
  {
    for (const SurfacePart& part : surface.parts)
    {
      // A point between two columns is on their chord. The frame belongs to the deflection of the last solution.
      const double sag = std::pow(part.patch->grid.dy, 2) / (8 * least_radius);
      const double moved = config_.contact.tolerance * (overlapOf(surfaces) + sizeOf(result.rail[side].deflection));
      if (const double distance = distanceFromRail(*part.patch, rail); distance > sag + moved + 1e-9)
      {
        fault("the origin is not on the rail", distance);
      }
      checkFrame(surface, part);
      in_cells = in_cells && meetsConditionsInCells(part.patch->method);
    }
  }
  checkRailForces(state, result, surfaces, rail, side);
  if (in_cells)
  {
    checkConditions(surfaces, side);
  }
}

/// Normal force and angle of a patch must be those of the resultant of its pressure.
void ResultCheck::checkFrame(const PressedSurface& surface, const SurfacePart& part)
{
  Forces forces;
  addForces(surface, {}, part.first, part.columns, forces);
  const PatchResult& patch = *part.patch;
  const double along = std::hypot(forces.outward, forces.down) / patch.normal_force - 1;
  const double angle = std::atan2(forces.outward, forces.down) - sideSign(patch.side) * patch.pose.angle;
  if (std::abs(along) > config_.contact.tolerance)
  {
    fault("normal force differs from the resultant of the pressures", along);
  }
  if (std::abs(angle) > config_.contact.tolerance ||
      std::abs(sideSign(patch.side) * patch.pose.angle - patch.contact_angle) > rounding)
  {
    fault("angle differs from that of the resultant", angle);
  }
}

/// The forces that deflect the rail must be those of the pressures.
void ResultCheck::checkRailForces(const WheelsetState& state, const WheelsetResult& result,
                                  const std::vector<PressedSurface>& surfaces, const PlacedRail& rail, Side side)
{
  const RailBendingConfig& bending = config_.rail_bending;
  if (bending.model != RailBendingConfig::Model::compliance || surfaces.empty())
  {
    return;
  }
  using LateralForce = RailBendingConfig::LateralForce;
  Forces forces;
  for (const PressedSurface& surface : surfaces)
  {
    addForces(surface, rail.referencePoint(), 0, surface.grid.ny, forces);
  }
  if (bending.lateral_force != LateralForce::contact)
  {
    const double given =
        bending.lateral_force == LateralForce::topic ? state.rail_lateral_force[side] : bending.lateral_force_value;
    forces.moment += (given - forces.outward) * forces.height / forces.sum;  // it acts at the height of the contact
    forces.outward = given;
  }
  constexpr double arm = 0.05;  // half the width of a rail head [m]
  const RailResult& found = result.rail[side];
  const double off = std::hypot(found.lateral_force - forces.outward, found.vertical_force - forces.down,
                                (found.moment - forces.moment) / arm) /
                     forces.sum;
  if (off > config_.contact.tolerance)
  {
    fault("forces and moment on a rail differ from those of the pressures, relative", off);
  }
}

void ResultCheck::checkConditions(const std::vector<PressedSurface>& surfaces, Side side)
{
  const double overlap = overlapOf(surfaces);
  for (const PressedSurface& surface : surfaces)
  {
    const Eigen::ArrayXXd w = displacement_[side].at(surface, surfaces) + surface.gap;
    const double inside = (surface.pressure > 0).select(w.abs(), 0.0).maxCoeff();
    const double outside = (surface.pressure > 0).select(0.0, (-w).max(0.0)).maxCoeff();
    violation_ = std::max({violation_, inside / overlap, outside / overlap});
  }
}
}  // namespace wheel_rail_contact::core::stability
