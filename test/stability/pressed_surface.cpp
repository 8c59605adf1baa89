// SPDX-License-Identifier: BSD-3-Clause
#include "pressed_surface.h"

namespace wheel_rail_contact::core::stability
{
namespace
{
const double pi = std::acos(-1.0);

/// Parameter of the point of a curve that is nearest to (y, z) [m]: the nearest of samples 0.25 mm apart, refined by
/// golden sections. `curve(u, point)` returns false where there is no point.
template <typename Curve>
double nearestPlace(double length, double y, double z, const Curve& curve)
{
  constexpr double step = 2.5e-4;
  constexpr int sections = 40;
  const auto distance = [&](double u)
  {
    PlanePoint point{};
    return curve(u, point) ? std::hypot(point.y - y, point.z - z) : 1.0;
  };
  double nearest = 0;
  for (double u = 0; u <= length; u += step)
  {
    nearest = distance(u) < distance(nearest) ? u : nearest;
  }
  const double share = 0.5 * (std::sqrt(5.0) - 1);
  double begin = std::max(nearest - step, 0.0), end = std::min(nearest + step, length);
  for (int i = 0; i < sections; ++i)
  {
    const double one = end - share * (end - begin), other = begin + share * (end - begin);
    (distance(one) < distance(other) ? end : begin) = distance(one) < distance(other) ? other : one;
  }
  return 0.5 * (begin + end);
}

double railPlace(const PlacedRail& rail, double y, double z)
{
  return nearestPlace(rail.profile().length(), y, z,
                      [&](double u, PlanePoint& point)
                      {
                        point = rail.at(u);
                        return true;
                      });
}

double wheelPlace(const PlacedWheel& wheel, double y, double z)
{
  return nearestPlace(wheel.profile().length(), y, z,
                      [&](double u, PlanePoint& point)
                      {
                        SpacePoint locus{};
                        const bool found = wheel.locus(wheel.profile().at(u), locus);
                        point.y = locus.y;
                        point.z = locus.z;
                        return found;
                      });
}

/// The surface of one patch, without gap.
PressedSurface surfaceOf(const PatchResult& patch, const PlacedWheel& wheel, const PlacedRail& rail)
{
  const PatchGrid& grid = patch.grid;
  const double y = sideSign(patch.side) * patch.pose.y;
  PressedSurface surface;
  surface.grid = {grid.nx, grid.ny, grid.dx, grid.dy, grid.y0, false};
  surface.origin = {patch.pose.x + grid.x0 - surface.grid.x(0), railPlace(rail, y, patch.pose.z),
                    wheelPlace(wheel, y, patch.pose.z)};
  surface.pressure = patch.pressure;
  if (patch.side == Side::right)
  {
    surface.grid.y0 = -(grid.y0 + (grid.ny - 1) * grid.dy);
    surface.pressure.rowwise().reverseInPlace();
  }
  surface.parts = {{&patch, 0, grid.ny}};
  return surface;
}

/// True if `next` continues the grid of `surface`: two contacts of one grid are patches of their own.
bool continues(const PressedSurface& surface, const PressedSurface& next, const Profile& rail)
{
  const auto same = [](double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(a); };
  const Grid &one = surface.grid, &other = next.grid;
  const double between = arcLength(rail, surface.origin.rail_u, next.origin.rail_u);
  return one.nx == other.nx && same(one.dx, other.dx) && same(one.dy, other.dy) &&
         std::abs(surface.origin.x - next.origin.x) < 1e-6 * one.dx &&
         std::abs(between + other.y0 - one.y(one.ny)) < 0.1 * one.dy;
}

void append(const PressedSurface& next, PressedSurface& surface)
{
  const Eigen::ArrayXXd before = surface.pressure;
  surface.pressure.resize(before.rows(), before.cols() + next.pressure.cols());
  surface.pressure << before, next.pressure;
  surface.parts.push_back({next.parts[0].patch, surface.grid.ny, next.grid.ny});
  surface.grid.ny += next.grid.ny;
}
}  // namespace

std::vector<PressedSurface> surfacesUnder(const std::vector<PatchResult>& patches, Side side, const PlacedWheel& wheel,
                                          const PlacedRail& rail)
{
  std::vector<PressedSurface> surfaces;
  for (const PatchResult& patch : patches)
  {
    if (patch.side != side)
    {
      continue;
    }
    PressedSurface surface = surfaceOf(patch, wheel, rail);
    if (!surfaces.empty() && continues(surfaces.back(), surface, rail.profile()))
    {
      append(surface, surfaces.back());
    }
    else
    {
      surfaces.push_back(std::move(surface));
    }
  }
  Eigen::ArrayXXd slope;
  for (PressedSurface& surface : surfaces)
  {
    if (!buildSurfaceGap(wheel, rail, surface.origin, surface.grid, surface.gap, slope, surface.columns))
    {
      throw std::runtime_error("a body has no point on the grid of a patch");
    }
  }
  return surfaces;
}

double distanceFromRail(const PatchResult& patch, const PlacedRail& rail)
{
  const double y = sideSign(patch.side) * patch.pose.y;
  const PlanePoint nearest = rail.at(railPlace(rail, y, patch.pose.z));
  return std::hypot(nearest.y - y, nearest.z - patch.pose.z);
}

/// Displacement by the pressure times `share` in each column, times the same share.
Eigen::ArrayXXd SurfaceDisplacement::product(const PressedSurface& surface, const Eigen::ArrayXd& share)
{
  const Grid& grid = surface.grid;
  const auto influence = operators_.find(grid.nx, grid.ny, false, grid.dx / grid.dy);
  workspace_.reserve(*influence);
  std::vector<double> p(static_cast<std::size_t>(influence->fieldSize())), u(p.size());
  const auto at = [&](int i, int j)
  { return static_cast<std::size_t>(influence->rowOffset(i) + influence->columnOffset(j)); };
  for (int j = 0; j < grid.ny; ++j)
  {
    for (int i = 0; i < grid.nx; ++i)
    {
      p[at(i, j)] = share[j] * surface.pressure(i, j);
    }
  }
  influence->multiply(p.data(), u.data(), workspace_);
  Eigen::ArrayXXd displacement(grid.nx, grid.ny);
  for (int j = 0; j < grid.ny; ++j)
  {
    for (int i = 0; i < grid.nx; ++i)
    {
      displacement(i, j) = share[j] * grid.dy / (pi * modulus_) * u[at(i, j)];
    }
  }
  return displacement;
}

void SurfaceDisplacement::addOther(const PressedSurface& surface, const PressedSurface& other,
                                   Eigen::ArrayXXd& displacement) const
{
  for (Eigen::Index l = 0; l < other.pressure.cols(); ++l)
  {
    const SurfaceColumn& there = other.columns[static_cast<std::size_t>(l)];
    for (Eigen::Index k = 0; k < other.pressure.rows(); ++k)
    {
      if (!(other.pressure(k, l) > 0))
      {
        continue;
      }
      const double factor = other.pressure(k, l) * other.grid.cellArea() / (pi * modulus_);
      const double x = other.origin.x + other.grid.x(static_cast<int>(k));
      for (Eigen::Index j = 0; j < displacement.cols(); ++j)
      {
        const SurfaceColumn& here = surface.columns[static_cast<std::size_t>(j)];
        const double projected = factor * (here.cosine * there.cosine + here.sine * there.sine);
        const double across = std::hypot(here.y - there.y, here.z - there.z);
        for (Eigen::Index i = 0; i < displacement.rows(); ++i)
        {
          displacement(i, j) +=
              projected / std::hypot(surface.origin.x + surface.grid.x(static_cast<int>(i)) - x, across);
        }
      }
    }
  }
}

Eigen::ArrayXXd SurfaceDisplacement::at(const PressedSurface& surface, const std::vector<PressedSurface>& all)
{
  Eigen::ArrayXd cosine(surface.grid.ny), sine(surface.grid.ny);
  for (int j = 0; j < surface.grid.ny; ++j)
  {
    cosine[j] = surface.columns[static_cast<std::size_t>(j)].cosine;
    sine[j] = surface.columns[static_cast<std::size_t>(j)].sine;
  }
  Eigen::ArrayXXd displacement = product(surface, cosine) + product(surface, sine);
  for (const PressedSurface& other : all)
  {
    if (&other != &surface)
    {
      addOther(surface, other, displacement);
    }
  }
  return displacement;
}
}  // namespace wheel_rail_contact::core::stability
