// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "chart/gap_scene.h"
#include "core/normal/solvers/hertz.h"

namespace wheel_rail_contact::core::chart
{
namespace
{
constexpr double along = 0.5 / 0.46;  ///< coefficient of the gap along x for a wheel of 0.46 m [1/m]
constexpr double load = 100e3;        ///< [N]

/// Half the curvature of an arc [1/m]. The distance of the arc from its tangent is this value times the square of the
/// position.
constexpr double arc(double radius)
{
  return 0.5 / radius;
}

Gap paraboloid(double a, double b)
{
  return [=](double x, double y) { return a * x * x + b * y * y; };
}

/// Coefficient across the track for which the contact ellipse is `ratio` times as long as wide, by bisection.
double acrossForRatio(double ratio)
{
  double low = along, high = along * ratio * ratio;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = std::sqrt(low * high);
    const HertzContact contact = hertzForApproach({along, middle}, 1, 1);
    (contact.semi_axis_x < ratio * contact.semi_axis_y ? low : high) = middle;
  }
  return low;
}

/// Transition between two arcs of the rail head (300 mm on the crown, 80 mm beside it) under a conical tread.
double discontinuity(double x, double y)
{
  return along * x * x + arc(y < 0 ? 0.300 : 0.080) * y * y;
}

/// Two minima 8 mm apart, 10 µm below the saddle between them, loaded until their contacts merge.
double lobes(double x, double y)
{
  constexpr double depth = 10e-6, half = 4e-3;
  const double q = y / half, well = q * q - 1;
  return along * x * x + depth * well * well;
}

/// An arc of 13.0 mm in one of 13.2 mm; both end 12.5 mm from the middle.
double conformal(double x, double y)
{
  constexpr double inner = 0.0130, outer = 0.0132, end = 0.0125;
  const double t = std::min(std::abs(y), end), beyond = std::abs(y) - t;
  const double between = (inner - std::sqrt(inner * inner - t * t)) - (outer - std::sqrt(outer * outer - t * t));
  return along * x * x + between + beyond;
}
}  // namespace

std::vector<std::unique_ptr<Scene>> gapScenes()
{
  const auto solver_cache = std::make_shared<SolverCache>();
  const Box wide{0.050, -0.016, 0.016};
  std::vector<std::unique_ptr<Scene>> scenes;
  const auto add = [&](const char* name, const char* title, std::vector<GapPatch> patches)
  { scenes.push_back(std::make_unique<GapScene>(name, title, solver_cache, std::move(patches), load)); };

  add("hertz_1_1", "Hertz, ellipse 1:1", {{paraboloid(along, along), wide, 0, 1}});
  add("hertz_1_5", "Hertz, ellipse 1:5", {{paraboloid(along, acrossForRatio(5)), wide, 0, 1}});
  add("discontinuity", "Curvature discontinuity 300/80 mm", {{discontinuity, wide, 0, 1}});
  // One patch on the tread and one on a flange inclined by 35 degrees, whose first touch is at 20 µm.
  const Gap tread = paraboloid(along, arc(0.200)), flange = paraboloid(along, arc(0.020));
  const double later = 20e-6;
  add("two_patches", "Two patches",
      {{tread, wide, 0, 1},
       {[=](double x, double y) { return flange(x, y) + later; }, wide, later, std::cos(35 * std::acos(-1.0) / 180)}});
  add("lobes", "Merged lobes", {{lobes, wide, 0, 1}});
  add("conformal", "Nearly conformal arcs", {{conformal, wide, 0, 1}});
  return scenes;
}
}  // namespace wheel_rail_contact::core::chart
