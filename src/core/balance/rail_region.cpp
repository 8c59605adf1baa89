// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/rail_region.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/balance/tuning.h"
#include "core/constants.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Range of the overlap along the track [m].
struct Extent
{
  double least = infinity, most = -infinity;
};

/// Half-length of the overlap of a wheel circle that is `depth` too low, by the height [m].
double halfLength(const PlacedWheel& wheel, const PlacedRail& rail, const InitialContact& contact, double depth)
{
  const CurvePoint point = wheel.profile().at(contact.wheel_u);
  const double radius = wheel.sections().radius - point.z, cosine = 1 / std::hypot(1, contact.slope);
  const double relative =
      rail.changes() ? cosine * wheel.touchAlong(rail.along(contact.rail_u), point, 0).radius : radius;
  return std::sqrt(2 * std::max(depth, 0.0) * relative);
}

/// Range of an overlap whose middle line is the contact locus and whose half-length falls towards its ends as that of
/// an ellipse. At its deepest place it is `depth` deep [m].
void addExtent(const PlacedWheel& wheel, const PlacedRail& rail, const OverlapInterval& interval, double depth,
               Extent& extent)
{
  const double shift = interval.contact.wheel_u - interval.contact.rail_u;
  Extent locus;
  for (const double u : {interval.contact.wheel_u, interval.u_begin + shift, interval.u_end + shift})
  {
    SpacePoint point{};
    const CurvePoint on_wheel = wheel.profile().at(u);
    if (wheel.locus(on_wheel, point))
    {
      const double x = rail.changes() ? wheel.touchAlong(rail.along(u - shift), on_wheel, point.x).x : point.x;
      locus.least = std::min(locus.least, x);
      locus.most = std::max(locus.most, x);
    }
  }
  const double spread = locus.most - locus.least;
  const double half =
      tuning::overlap_margin * spread + std::hypot(0.5 * spread, halfLength(wheel, rail, interval.contact, depth));
  const double middle = 0.5 * (locus.least + locus.most);
  extent.least = std::min(extent.least, middle - half);
  extent.most = std::max(extent.most, middle + half);
}

/// First and last index of the lines of a pressure that are not empty.
template <typename Lines>
std::pair<Eigen::Index, Eigen::Index> loadedLines(Eigen::Index count, const Lines& is_loaded)
{
  Eigen::Index first = 0, last = count - 1;
  while (first < last && !is_loaded(first))
  {
    ++first;
  }
  while (last > first && !is_loaded(last))
  {
    --last;
  }
  return {first, last};
}
}  // namespace

RailRegion overlapOf(const PlacedWheel& wheel, const PlacedRail& rail, const OverlapInterval* begin,
                     const OverlapInterval* end, double lower)
{
  Extent extent;
  std::for_each(begin, end,
                [&](const OverlapInterval& interval)
                { addExtent(wheel, rail, interval, lower - interval.contact.separation, extent); });
  const double u_begin = begin->u_begin, u_end = (end - 1)->u_end;
  const double along = tuning::overlap_margin * (extent.most - extent.least);
  const double across = tuning::overlap_margin * (u_end - u_begin);
  return {extent.least - along, extent.most + along, u_begin - across, u_end + across};
}

bool findContact(const RailSearch& search, const PlacedWheel& wheel, const PlacedRail& rail,
                 const OverlapInterval& interval, double lower, RailRegion& part)
{
  if (!interval.has_one_minimum)
  {
    return false;
  }
  const double separation = interval.contact.separation, depth = lower - separation;
  const double share =
      contactShare(halfLength(wheel, rail, interval.contact, depth), 0.5 * (interval.u_end - interval.u_begin));
  const double widened = tuning::contact_margin * tuning::contact_margin;
  OverlapInterval contact = interval;
  search.moveEnds(separation + std::min(widened * (1 - share), 1.0) * depth, contact);
  Extent extent;
  addExtent(wheel, rail, contact, std::min(widened * share, 1.0) * depth, extent);
  part = {extent.least, extent.most, contact.u_begin, contact.u_end};
  return true;
}

RailRegion loadedPart(const PatchPressure& patch, const SurfaceOrigin& origin,
                      const std::vector<SurfaceColumn>& columns, double margin)
{
  const Grid& grid = patch.grid;
  const Eigen::ArrayXXd& p = patch.pressure;
  if (!(p > 0).any())
  {
    return {infinity, -infinity, infinity, -infinity};
  }
  const auto [first, last] = loadedLines(p.cols(), [&p](Eigen::Index j) { return (p.col(j) > 0).any(); });
  const auto [low, high] = loadedLines(p.rows(), [&p](Eigen::Index i) { return (p.row(i) > 0).any(); });
  const double x_most = grid.x(static_cast<int>(high)) + margin * grid.dx;
  const double x_least = grid.symmetric ? -x_most : grid.x(static_cast<int>(low)) - margin * grid.dx;
  return {origin.x + x_least, origin.x + x_most, columns[static_cast<std::size_t>(first)].rail_u - margin * grid.dy,
          columns[static_cast<std::size_t>(last)].rail_u + margin * grid.dy};
}
}  // namespace wheel_rail_contact::core
