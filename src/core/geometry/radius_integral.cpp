// SPDX-License-Identifier: BSD-3-Clause
#include "core/geometry/radius_integral.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/option_check.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double round_off = 1e-9;  ///< of a difference of S, relative to the largest one of the wave
/// A point as near to an end of the wave is left out: there S differs from that of the end by rounding only [m].
constexpr double round_off_width = 1e-12;

double mean(const RadiusDifference& a, const RadiusDifference& b)
{
  return 0.5 * (a.value + b.value);
}

/// Part of the line from a to b on which its absolute value is at most `threshold`; of negative width if there is none.
DisplacementRange flatPart(const RadiusDifference& a, const RadiusDifference& b, double threshold)
{
  const double slope = (b.value - a.value) / (b.y - a.y);
  const double one = a.y + (-threshold - a.value) / slope, other = a.y + (threshold - a.value) / slope;
  if (std::isfinite(one) && std::isfinite(other))
  {
    return {std::max(a.y, std::min(one, other)), std::min(b.y, std::max(one, other))};
  }
  return std::abs(a.value) <= threshold ? DisplacementRange{a.y, b.y} : DisplacementRange{b.y, a.y};
}

/// Integral of dy / sqrt(E) over a line from a to b, with E = S(end) - S(y) = v² at both ends of the line.
///
/// E is a parabola. With k the slope of dr, (dr / sqrt(2 k), v) runs on a circle or, with -k, a hyperbola. The integral
/// is its angle over sqrt(k / 2); the tangent of half this angle is that of the chord.
double overLine(const RadiusDifference& a, const RadiusDifference& b, double v_a, double v_b)
{
  const double width = b.y - a.y;
  const double chord = width / (v_a + v_b);
  const double slope = 0.5 * (b.value - a.value) / width;
  const double root = std::sqrt(std::abs(slope));
  const double part = root * chord;
  if (part < 1e-6)  // both closed forms are then 1 within rounding
  {
    return 2 * chord;
  }
  return 2 / root * (slope > 0 ? std::atan(part) : std::atanh(std::min(part, 1.0)));
}

/// Least value of E between a and b, where E is that at a [m²].
double leastBetween(const RadiusDifference& a, const RadiusDifference& b, double energy_a)
{
  if (!(a.value > 0 && b.value < 0))
  {
    return energy_a;
  }
  return energy_a - 0.5 * a.value * a.value * (b.y - a.y) / (a.value - b.value);
}
}  // namespace

RadiusIntegral::RadiusIntegral(std::vector<RadiusDifference> curve) : curve_(std::move(curve))
{
  sum_.assign(curve_.size(), 0);
  for (std::size_t i = 1; i < curve_.size(); ++i)
  {
    const double width = curve_[i].y - curve_[i - 1].y;
    require(width >= 0, "y of the curve", curve_[i].y, "is below the one before");
    sum_[i] = sum_[i - 1] + width * mean(curve_[i - 1], curve_[i]);
  }
}

DisplacementRange RadiusIntegral::range() const
{
  return curve_.size() < 2 ? DisplacementRange{} : DisplacementRange{curve_.front().y, curve_.back().y};
}

bool RadiusIntegral::hasCentre() const
{
  bool below = false;
  for (const RadiusDifference& point : curve_)
  {
    if (below && point.value >= 0)
    {
      return true;
    }
    below = point.value < 0;
  }
  return false;
}

/// Index of the point after y; that of the last point at the end of the range.
std::size_t RadiusIntegral::segmentAt(double y) const
{
  const auto after = std::upper_bound(curve_.begin() + 1, curve_.end() - 1, y,
                                      [](double value, const RadiusDifference& point) { return value < point.y; });
  return static_cast<std::size_t>(after - curve_.begin());
}

/// Point of the lines at y, which the range contains.
RadiusDifference RadiusIntegral::pointAt(double y) const
{
  const std::size_t i = segmentAt(y);
  const RadiusDifference& a = curve_[i - 1];
  const RadiusDifference& b = curve_[i];
  return {y, b.y > a.y ? a.value + (y - a.y) / (b.y - a.y) * (b.value - a.value) : b.value};
}

double RadiusIntegral::at(double y) const
{
  const std::size_t i = segmentAt(y);
  return sum_[i - 1] + (y - curve_[i - 1].y) * mean(curve_[i - 1], pointAt(y));
}

DisplacementRange RadiusIntegral::widestFlat(double threshold) const
{
  DisplacementRange widest, present;
  for (std::size_t i = 1; i < curve_.size(); ++i)
  {
    if (!(curve_[i].y > curve_[i - 1].y))
    {
      continue;
    }
    const DisplacementRange part = flatPart(curve_[i - 1], curve_[i], threshold);
    if (part.width() >= 0)
    {
      const bool continues = i > 1 && part.begin == present.end;
      present = {continues ? present.begin : part.begin, part.end};
    }
    widest = present.width() > widest.width() ? present : widest;
  }
  return widest;
}

double RadiusIntegral::overWave(const DisplacementRange& wave) const
{
  std::vector<RadiusDifference> points{pointAt(wave.begin)};
  std::vector<double> energy{0};
  const double end = 0.5 * (at(wave.begin) + at(wave.end));
  for (std::size_t i = 0; i < curve_.size(); ++i)
  {
    if (curve_[i].y > wave.begin + round_off_width && curve_[i].y < wave.end - round_off_width)
    {
      points.push_back(curve_[i]);
      energy.push_back(end - sum_[i]);
    }
  }
  points.push_back(pointAt(wave.end));
  energy.push_back(0);
  const double tolerance = round_off * *std::max_element(energy.begin(), energy.end());
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const double least = std::min(energy[i], leastBetween(points[i - 1], points[i], energy[i - 1]));
    if (!(least >= -tolerance))
    {
      return infinity;
    }
    if (points[i].y > points[i - 1].y)
    {
      sum += overLine(points[i - 1], points[i], std::sqrt(std::max(energy[i - 1], 0.0)),
                      std::sqrt(std::max(energy[i], 0.0)));
    }
  }
  return sum;
}
}  // namespace wheel_rail_contact::core
