// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "profile_helpers.h"

namespace wheel_rail_contact::core
{
/// Point of the profile at `y` [m]. y must increase along the curve.
inline CurvePoint atY(const Profile& profile, double y)
{
  return profile.at(parameterAt(profile, y));
}

/// Distance of a point from the profile [m], positive above it.
inline double height(const Profile& profile, double y, double z)
{
  double u = 0.0;
  double nearest = 1.0;
  for (int i = 0; i <= 2000; ++i)
  {
    const CurvePoint p = profile.at(profile.length() * i / 2000);
    if (std::hypot(p.y - y, p.z - z) < nearest)
    {
      nearest = std::hypot(p.y - y, p.z - z);
      u = profile.length() * i / 2000;
    }
  }
  for (int step = 0; step < 50; ++step)
  {
    const CurvePoint p = profile.at(u);
    u -= ((p.y - y) * p.dy + (p.z - z) * p.dz) / (p.dy * p.dy + p.dz * p.dz);
  }
  const CurvePoint p = profile.at(u);
  return ((z - p.z) * p.dy - (y - p.y) * p.dz) / std::hypot(p.dy, p.dz);
}

/// d²z/dy² [1/m].
inline double secondDerivative(const CurvePoint& p)
{
  return (p.ddz * p.dy - p.dz * p.ddy) / (p.dy * p.dy * p.dy);
}

/// Derivative by central differences of fourth order.
template <typename Value>
double difference(const Profile& profile, double u, const Value& value)
{
  const double h = 5e-5;
  const auto pair = [&](double step) { return value(profile.at(u + step)) - value(profile.at(u - step)); };
  return (8.0 * pair(h) - pair(2.0 * h)) / (12.0 * h);
}

inline void expectDerivativesByDifferences(const Profile& profile)
{
  for (std::size_t k = 0; k + 1 < profile.discontinuities().size(); ++k)
  {
    for (const double share : {0.1, 0.37, 0.5, 0.83})
    {
      const double u =
          profile.discontinuities()[k] + share * (profile.discontinuities()[k + 1] - profile.discontinuities()[k]);
      SCOPED_TRACE(u);
      const CurvePoint here = profile.at(u);
      // Truncation error of the differences: h⁴ / 30 times the fifth (sixth) derivative. The largest derivatives are
      // 1e10 1/m⁴ (5e12 1/m⁵), in section C of S1002.
      EXPECT_NEAR(here.dy, difference(profile, u, [](const CurvePoint& p) { return p.y; }), 5e-9);
      EXPECT_NEAR(here.dz, difference(profile, u, [](const CurvePoint& p) { return p.z; }), 5e-9);
      EXPECT_NEAR(here.ddy, difference(profile, u, [](const CurvePoint& p) { return p.dy; }), 2e-6);
      EXPECT_NEAR(here.ddz, difference(profile, u, [](const CurvePoint& p) { return p.dz; }), 2e-6);
    }
  }
}
}  // namespace wheel_rail_contact::core
