// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "core/constants.h"
#include "core/option_check.h"
#include "core/profile/curve/monotone_cubic.h"
#include "core/text/formatted.h"
#include "core/text/text_table.h"
#include "core/text/words.h"
#include "wheel_rail_contact/core/track.h"

namespace wheel_rail_contact::core
{
namespace
{
using RimPoints = std::vector<OutOfRound::Point>;

constexpr double whole_turn = 2 * pi;  ///< [rad]
constexpr std::size_t fewest_points = 8;

/// Value of a closed curve at an angle [rad].
double valueAt(const RimPoints& points, double angle)
{
  const long count = static_cast<long>(points.size());
  const double begin = points.front().angle, place = angle - whole_turn * std::floor((angle - begin) / whole_turn);
  const auto next = std::upper_bound(points.begin(), points.end(), place,
                                     [](double value, const OutOfRound::Point& point) { return value < point.angle; });
  OutOfRound::Point p[4];
  double width[3], rise[3], c[4];
  for (long k = 0; k < 4; ++k)
  {
    const long i = next - points.begin() + k - 2;
    p[k] = points[static_cast<std::size_t>((i + count) % count)];
    p[k].angle += i < 0 ? -whole_turn : i >= count ? whole_turn : 0;
    if (k > 0)
    {
      width[k - 1] = p[k].angle - p[k - 1].angle;
      rise[k - 1] = (p[k].deviation - p[k - 1].deviation) / width[k - 1];
    }
  }
  setCubic(p[1].deviation, p[2].deviation, monotoneSlope(rise[0], rise[1], width[0], width[1]),
           monotoneSlope(rise[1], rise[2], width[1], width[2]), width[1], c);
  const double t = place - p[1].angle;
  return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
}

/// Column of a table by its name, and the value of its unit.
std::pair<std::size_t, double> columnOf(const TextFile& file, const TextTable& table, const char* name,
                                        const char* kind)
{
  const std::vector<TableTitle>& titles = table.titles();
  const auto found = std::find_if(titles.begin(), titles.end(),
                                  [&](const TableTitle& title) { return lowerCase(title.name) == name; });
  const NamedUnit* unit = found != titles.end() ? unitNamed(found->unit, kind) : nullptr;
  file.refuseIf(unit == nullptr, table.titleLine(), "column '", name,
                "' is missing or has no valid unit: titles must be such as angle_deg,deviation_um");
  return {static_cast<std::size_t>(found - titles.begin()), unit->value};
}

/// Refuses rows that are not one closed turn. Removes a last row that repeats the first one.
void closeTurn(const TextFile& file, RimPoints& points)
{
  constexpr double widest = 3, repeats = 0.1;  // over the mean distance of the rows
  constexpr double rounding = 2e-6;            // [m]
  file.refuseIf(points.size() < fewest_points, 0, "has ", points.size(), " rows, must have at least ", fewest_points);
  const double span = points.back().angle - points.front().angle, mean = span / static_cast<double>(points.size() - 1);
  const double jump = points.front().deviation - points.back().deviation;
  double gap = whole_turn - span, step = 0;
  const bool is_repeated = gap < repeats * mean;
  file.refuseIf(gap < -repeats * mean, 0, formatted("the angles span %.4g deg, must be one turn", span / degree));
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    gap = std::max(gap, points[i].angle - points[i - 1].angle);
    step = std::max(step, std::abs(points[i].deviation - points[i - 1].deviation));
  }
  file.refuseIf(gap > widest * mean, 0, formatted("the turn has a gap of %.4g deg, must have none", gap / degree));
  file.refuseIf(
      std::abs(jump) > (is_repeated ? 0 : widest * step) + rounding, 0,
      formatted("the deviation jumps by %.4g mm from the last row to the first one, must be periodic", 1e3 * jump));
  points.resize(points.size() - (is_repeated ? 1 : 0));
}
}  // namespace

double OutOfRound::at(double angle, double radius) const
{
  double sum = table.empty() ? 0 : valueAt(table, angle);
  for (const Harmonic& wave : harmonics)
  {
    sum += wave.amplitude * std::sin(wave.order * angle + wave.phase);
  }
  for (const Flat& flat : flats)
  {
    const double cosine = std::cos(angle - flat.angle);
    sum += cosine > 0 ? std::min((radius - flat.depth) / cosine - radius, 0.0) : 0;
  }
  return sum;
}

void validate(const OutOfRound& wheel, double radius, const std::string& option)
{
  const double largest = 0.005 / 0.46 * radius;
  const std::string rule = formatted("must be within ±%.4g m: 5 mm on a radius of 0.46 m", largest);
  const auto check = [&](const char* name, double value, bool valid)
  {
    requireWithin(option + name, value, largest, rule.c_str());
    refuseIf(!valid, option, name, ": angles must be finite, and increase within one turn; depths must be above 0");
  };
  double sum = 0;
  for (const OutOfRound::Harmonic& wave : wheel.harmonics)
  {
    require(wave.order >= 1 && wave.order <= 100, option + "/harmonics/order", wave.order, "must be from 1 to 100");
    check("/harmonics/amplitude", wave.amplitude, std::isfinite(wave.phase));
    check("/harmonics: sum of amplitudes", sum += std::abs(wave.amplitude), true);
  }
  for (const OutOfRound::Flat& flat : wheel.flats)
  {
    check("/flats/depth", flat.depth, flat.depth > 0 && std::isfinite(flat.angle));
  }
  double last = wheel.table.empty() ? 0 : wheel.table.back().angle - whole_turn;
  for (const OutOfRound::Point& point : wheel.table)
  {
    check(": deviation", point.deviation, point.angle > last && std::isfinite(point.angle));
    last = point.angle;
  }
  refuseIf(!wheel.table.empty() && wheel.table.size() < fewest_points, option, ": too few points of the table");
}

RimPoints readOutOfRound(const std::string& path)
{
  TextFile file(path);
  TextTable table(file,
                  [](const std::vector<TableTitle>& titles) { return !titles.empty() && titles[0].name == "angle"; });
  const auto [angle, radian] = columnOf(file, table, "angle", "angle");
  const auto [deviation, metre] = columnOf(file, table, "deviation", "length");
  RimPoints points;
  for (std::vector<std::string> fields; table.next(fields);)
  {
    points.push_back(
        {radian * file.numberIn(fields[angle], "angle"), metre * file.numberIn(fields[deviation], "deviation")});
    file.refuseIf(points.size() > 1 && !(points.back().angle > points.end()[-2].angle), "angle must increase");
  }
  closeTurn(file, points);
  return points;
}
}  // namespace wheel_rail_contact::core
