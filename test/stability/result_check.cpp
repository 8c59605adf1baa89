// SPDX-License-Identifier: BSD-3-Clause
#include "result_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core::stability
{
namespace
{
constexpr std::array<Side, 2> sides{Side::left, Side::right};

/// Relative rounding error of a sum over up to some thousand cells [-].
constexpr double rounding = 1e-9;

/// Parameter of the point of a curve that is nearest to (y, z), among samples 0.25 mm apart [m].
template <typename Curve>
double nearestPlace(double length, double y, double z, const Curve& curve)
{
  constexpr double distance = 2.5e-4;
  double nearest = 0, least = 1e9;
  for (double u = 0; u <= length; u += distance)
  {
    double at_y = 0, at_z = 0;
    if (curve(u, at_y, at_z))
    {
      const double squared = (at_y - y) * (at_y - y) + (at_z - z) * (at_z - z);
      nearest = squared < least ? u : nearest;
      least = std::min(least, squared);
    }
  }
  return nearest;
}

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

/// True for methods whose normal force is the sum of the pressures of the cells.
bool hasForceFromCells(const ContactModelConfig& config)
{
  return config.contact.method != NormalMethod::kik_piotrowski;
}
}  // namespace

ResultCheck::ResultCheck(const ContactModelConfig& config)
    : config_(config), undeflected_(config.rail_profile, config.track)
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
  checkLoads(state, result);
  for (const Side side : sides)
  {
    checkDeflection(state, result, side);
  }
  if (faults_.empty())
  {
    checkConditions(result);
  }
  return faults_;
}

void ResultCheck::checkNumbers(const WheelsetResult& result)
{
  double sum = result.y + result.z + result.yaw + result.roll;
  for (const RailResult& rail : result.rail)
  {
    const RailDeflection& d = rail.deflection;
    sum += d.lateral + d.vertical + d.roll + rail.lateral_force + rail.vertical_force + rail.moment;
  }
  for (const PatchResult& p : result.patches)
  {
    sum += p.pose.x + p.pose.y + p.pose.z + p.pose.angle + p.contact_angle + p.normal_force + p.approach + p.area +
           p.max_pressure + p.error_estimate + p.residual + p.half_space_ratio + p.pressure.sum();
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
  const double sum = grid.cellArea() * patch.pressure.sum();
  if (hasForceFromCells(config_) && std::abs(sum / patch.normal_force - 1) > rounding)
  {
    fault("normal force differs from the sum of the pressures", sum / patch.normal_force);
  }
}

/// Vertical forces on each rail, and equilibrium of vertical load of each wheel. seidel_printed finds the load by
/// secant steps on the approach, which end at an error of 1e-4.
void ResultCheck::checkLoads(const WheelsetState& state, const WheelsetResult& result)
{
  const double tolerance = config_.contact.method == NormalMethod::seidel_printed ? 1e-4 : 1e-7;
  for (const Side side : sides)
  {
    double vertical = 0;
    for (const PatchResult& patch : result.patches)
    {
      vertical += patch.side == side ? patch.normal_force * std::cos(patch.contact_angle) : 0;
    }
    const RailResult& rail = result.rail[static_cast<std::size_t>(side)];
    if (hasForceFromCells(config_) && std::abs(rail.vertical_force - vertical) > rounding * vertical)
    {
      fault("force on the rail differs from the sum over its patches", rail.vertical_force - vertical);
    }
    const double load = std::max(wheelLoad(config_, state, side), 0.0);
    if (config_.wheelset.solve_height_and_roll && std::abs(vertical - load) > tolerance * load)
    {
      fault("vertical force of a wheel differs from its load", vertical - load);
    }
  }
}

/// The deflection must equal the compliance table times forces and moment.
void ResultCheck::checkDeflection(const WheelsetState& state, const WheelsetResult& result, Side side)
{
  const RailBendingConfig& bending = config_.rail_bending;
  const auto k = static_cast<std::size_t>(side);
  const RailResult& rail = result.rail[k];
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
        bending.lateral_force == LateralForce::topic ? state.rail_lateral_force[k] : bending.lateral_force_value;
    if (bending.lateral_force != LateralForce::contact && std::abs(given - rail.lateral_force) > rounding * 1e4)
    {
      fault("lateral force on the rail differs from the given one", rail.lateral_force);
    }
    expected = deflectionInTrack(bending.table, {rail.lateral_force, rail.vertical_force, rail.moment},
                                 config_.track.rail_inclination);
  }
  // The iteration of rail deflection and force ends at 1e-6 of the deflection, with the roll multiplied by an arm of
  // 0.1 m. Relative to the lateral part alone the difference can be ten times larger.
  constexpr double arm = 0.1;  // [m]
  const double scale = std::hypot(found.lateral, found.vertical) + arm * std::abs(found.roll);
  const double off = std::hypot(expected.lateral - found.lateral, expected.vertical - found.vertical) +
                     arm * std::abs(expected.roll - found.roll);
  if (off > 1e-5 * scale + 1e-15)
  {
    fault("deflection differs from the compliance table", off / scale);
  }
}

void ResultCheck::checkConditions(const WheelsetResult& result)
{
  for (const PatchResult& patch : result.patches)
  {
    if (meetsConditionsInCells(patch.method))
    {
      violation_ = std::max(violation_, patchViolation(result, patch));
    }
  }
}

/// Displacement of both half-spaces under the pressure of a patch, with exact influence coefficients.
void ResultCheck::displace(const PatchResult& patch)
{
  const PatchGrid& grid = patch.grid;
  const auto influence = operators_.find(grid.nx, grid.ny, false, grid.dx / grid.dy);
  workspace_.reserve(*influence);
  std::vector<double> p(static_cast<std::size_t>(influence->fieldSize())), u(p.size());
  const auto at = [&](int i, int j)
  { return static_cast<std::size_t>(influence->rowOffset(i) + influence->columnOffset(j)); };
  for (int j = 0; j < grid.ny; ++j)
  {
    for (int i = 0; i < grid.nx; ++i)
    {
      p[at(i, j)] = patch.pressure(i, j);
    }
  }
  influence->multiply(p.data(), u.data(), workspace_);
  const double factor = grid.dy / (std::acos(-1.0) * contactModulus(config_.wheel_material, config_.rail_material));
  displacement_.resize(grid.nx, grid.ny);
  for (int j = 0; j < grid.ny; ++j)
  {
    for (int i = 0; i < grid.nx; ++i)
    {
      displacement_(i, j) = factor * u[at(i, j)];
    }
  }
}

/// Zero if no gap can be computed over the plane (flange tip on the crown of the rail, more than 30 mm away). If a
/// wheel has several patches, only cells with pressure are checked, because another patch may lie in the free cells of
/// the grid.
double ResultCheck::patchViolation(const WheelsetResult& result, const PatchResult& patch)
{
  const auto same_wheel = [&](const PatchResult& other) { return other.side == patch.side; };
  const bool alone = std::count_if(result.patches.begin(), result.patches.end(), same_wheel) == 1;
  const double sign = sideSign(patch.side);
  const PlacedRail rail = undeflected_.deflected(result.rail[static_cast<std::size_t>(patch.side)].deflection);
  const WheelsetPose pose = toSide(patch.side, {result.y, result.z, result.yaw, result.roll});
  const PlacedWheel wheel(*config_.wheel_profile, config_.wheelset, pose);
  ContactPlane plane{patch.pose.x, sign * patch.pose.y, patch.pose.z, sign * patch.pose.angle};
  plane.rail_u = nearestPlace(rail.profile().length(), plane.y, plane.z,
                              [&](double u, double& y, double& z)
                              {
                                const PlanePoint point = rail.at(u);
                                y = point.y;
                                z = point.z;
                                return true;
                              });
  plane.wheel_u = nearestPlace(wheel.profile().length(), plane.y, plane.z,
                               [&](double u, double& y, double& z)
                               {
                                 SpacePoint point{};
                                 const bool found = wheel.locus(wheel.profile().at(u), point);
                                 y = point.y;
                                 z = point.z;
                                 return found;
                               });
  displace(patch);
  Grid grid{patch.grid.nx, patch.grid.ny, patch.grid.dx, patch.grid.dy, patch.grid.y0, false};
  Eigen::ArrayXXd pressure = patch.pressure;
  if (patch.side == Side::right)
  {
    grid.y0 = -(grid.y0 + (grid.ny - 1) * grid.dy);
    pressure.rowwise().reverseInPlace();
    displacement_.rowwise().reverseInPlace();
  }
  if (!buildGap(wheel, rail, plane, grid, gap_, columns_))
  {
    return 0;
  }
  const Eigen::ArrayXXd w = displacement_ + gap_;
  const double inside = (pressure > 0).select(w.abs(), 0.0).maxCoeff();
  const double outside = alone ? (pressure > 0).select(0.0, (-w).max(0.0)).maxCoeff() : 0;
  return std::max(inside, outside) / std::max(-gap_.minCoeff(), 1e-15);
}
}  // namespace wheel_rail_contact::core::stability
