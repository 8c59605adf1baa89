// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "core/profile/profile_simpack.h"

namespace wheel_rail_contact::core
{
namespace
{
using FilePoints = std::vector<FilePoint>;

/// 1: omits points too close to the preceding one.
void thinOut(double least, FilePoints& points)
{
  FilePoints kept;
  for (const FilePoint& p : points)
  {
    if (kept.empty() || std::hypot(p.point.y - kept.back().point.y, p.point.z - kept.back().point.z) >= least)
    {
      kept.push_back(p);
    }
  }
  points = kept;
}

/// 2 and 3: shift, then rotation about x, from y towards z.
void shiftAndRotate(const SimpackSettings& settings, FilePoints& points)
{
  const double angle = settings.at("rotate") / settings.at("units.ang.f");
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  for (FilePoint& p : points)
  {
    const double y = p.point.y + settings.at("shift.y");
    const double z = p.point.z + settings.at("shift.z");
    p.point.y = c * y - s * z;
    p.point.z = s * y + c * z;
  }
}

/// 4: omits points outside the bounds. A lower bound above the upper bound switches the bounds off.
void cutToBounds(const SimpackSettings& settings, FilePoints& points)
{
  const auto outside = [&settings](double value, const std::string& axis)
  {
    const double least = settings.at("bound." + axis + ".min");
    const double most = settings.at("bound." + axis + ".max");
    return least <= most && (value < least || value > most);
  };
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](const FilePoint& p) { return outside(p.point.y, "y") || outside(p.point.z, "z"); }),
               points.end());
}

/// 5 and 6: mirror, then reversal of the order.
void mirrorAndInvert(const SimpackSettings& settings, FilePoints& points)
{
  for (FilePoint& p : points)
  {
    p.point.y *= settings.at("mirror.y") == 1.0 ? -1.0 : 1.0;
    p.point.z *= settings.at("mirror.z") == 1.0 ? -1.0 : 1.0;
  }
  if (settings.at("inversion") == 1.0)
  {
    std::reverse(points.begin(), points.end());
  }
}
}  // namespace

void applySimpackEdits(const SimpackSettings& settings, std::vector<FilePoint>& points)
{
  thinOut(settings.at("point.dist.min"), points);
  shiftAndRotate(settings, points);
  cutToBounds(settings, points);
  mirrorAndInvert(settings, points);
}
}  // namespace wheel_rail_contact::core
