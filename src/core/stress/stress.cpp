// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/stress.h"

#include <algorithm>
#include <cmath>

#include "core/constants.h"
#include "core/option_check.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr int fewest_depths = 4, most_depths = 64;  ///< of StressConfig::depths

/// Invariants of a stress.
struct Invariants
{
  double mean = 0;  ///< [Pa]
  double j2 = 0;    ///< second invariant of the deviator [Pa²]
  double j3 = 0;    ///< its third invariant, the determinant [Pa³]
};

Invariants invariantsOf(const Stress& s)
{
  const double mean = (s.xx + s.yy + s.zz) / 3;
  const double x = s.xx - mean, y = s.yy - mean, z = s.zz - mean;
  const double yz = s.yz * s.yz, xz = s.xz * s.xz, xy = s.xy * s.xy;
  return {mean, (x * x + y * y + z * z) / 2 + yz + xz + xy,
          x * (y * z - yz) - s.xy * (s.xy * z - s.yz * s.xz) + s.xz * (s.xy * s.yz - y * s.xz)};
}

/// Lode angle, a third of the angle whose cosine is the normalized third invariant: in [0, pi/3] [rad].
double lodeAngle(const Invariants& i)
{
  const double radius = std::sqrt(i.j2 / 3);
  return i.j2 > 0 ? std::acos(std::clamp(i.j3 / (2 * radius * radius * radius), -1.0, 1.0)) / 3 : 0;
}
}  // namespace

double vonMises(const Stress& stress)
{
  return std::sqrt(3 * invariantsOf(stress).j2);
}

std::array<double, 3> principalStresses(const Stress& stress)
{
  const Invariants i = invariantsOf(stress);
  const double radius = 2 * std::sqrt(i.j2 / 3), angle = lodeAngle(i);
  return {i.mean + radius * std::cos(angle), i.mean + radius * std::cos(angle - 2 * pi / 3),
          i.mean + radius * std::cos(angle + 2 * pi / 3)};
}

double maxShear(const Stress& stress)
{
  const Invariants i = invariantsOf(stress);
  return std::sqrt(i.j2) * std::sin(lodeAngle(i) + pi / 3);
}

Strain strainOf(const Stress& s, const Material& material)
{
  validate(material, "material");
  const double nu = material.poisson, normal = 1 / material.young, shear = (1 + nu) / material.young;
  return {normal * (s.xx - nu * (s.yy + s.zz)),
          normal * (s.yy - nu * (s.xx + s.zz)),
          normal * (s.zz - nu * (s.xx + s.yy)),
          shear * s.yz,
          shear * s.xz,
          shear * s.xy};
}

Stress StressLayer::at(Eigen::Index row, Eigen::Index column) const
{
  return {components[0](row, column), components[1](row, column), components[2](row, column),
          components[3](row, column), components[4](row, column), components[5](row, column)};
}

void validate(const StressConfig& stress)
{
  require(stress.depths == 0 || (stress.depths >= fewest_depths && stress.depths <= most_depths), "stress/depths",
          stress.depths, "must be 0, or from 4 to 64");
  require(!stress.field || stress.depths > 0, "stress/depths", stress.depths, "must be above 0 with stress/field");
}
}  // namespace wheel_rail_contact::core
