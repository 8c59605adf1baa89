// SPDX-License-Identifier: BSD-3-Clause
#include "core/profile/noise/noise.h"

#include <algorithm>
#include <array>

namespace wheel_rail_contact::core
{
namespace
{
constexpr std::size_t nowhere = static_cast<std::size_t>(-1);
constexpr std::size_t neighbours = 4;

/// Points of a curve with their neighbours at some distance.
class CurveWindows
{
 public:
  /// Neighbours are at least 0.25 mm apart: noise of points that are closer is often correlated. Rounding gives steps,
  /// and a measuring device filters. The four neighbours of a window are at most 12 mm apart: a curve is no cubic over
  /// more.
  static constexpr double least_spacing = 0.25e-3, longest = 12e-3;  ///< [m]

  /// @param points  in order along the curve
  explicit CurveWindows(const std::vector<SampledPoint>& points) : points_(points), length_{0}
  {
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      length_.push_back(length_.back() + distance(points[i - 1], points[i]));
    }
  }

  /// Distance of points across the curve from a cubic, and its standard deviation for noise of 1.
  struct Residual
  {
    double across;     ///< of the point that is farthest from the cubic [m], positive to the left of the curve
    double at_first;   ///< of the first point [m]
    double deviation;  ///< [-]
    bool flat;         ///< the curve is flatter than 45 degrees there
    double length;     ///< distance of the two nearest neighbours [m]
    double turn;       ///< angle between the chords of the neighbours on either side [rad]
  };
  /// Residual of the points `first` to `last` from the cubic through two neighbours before and two after them, which
  /// are none of the points `skip_first` to `skip_last`.
  /// @return nothing if the curve has no such neighbours
  std::optional<Residual> residual(std::size_t first, std::size_t last, std::size_t skip_first = nowhere,
                                   std::size_t skip_last = nowhere) const;

 private:
  const std::vector<SampledPoint>& points_;
  std::vector<double> length_;
};

/// Angle between two directions [rad].
double angleBetween(double y1, double z1, double y2, double z2)
{
  return std::abs(std::atan2(y1 * z2 - z1 * y2, y1 * y2 + z1 * z2));
}

std::optional<CurveWindows::Residual> CurveWindows::residual(std::size_t first, std::size_t last,
                                                             std::size_t skip_first, std::size_t skip_last) const
{
  // The nearest point at least the spacing before (step -1) or after a point; nowhere beyond the end of the curve.
  const auto next = [&](std::size_t point, std::ptrdiff_t step)
  {
    for (std::size_t i = point + static_cast<std::size_t>(step); i < length_.size();
         i += static_cast<std::size_t>(step))
    {
      if (std::abs(length_[point] - length_[i]) >= least_spacing && !(i >= skip_first && i <= skip_last))
      {
        return i;
      }
    }
    return nowhere;
  };
  const std::size_t left = next(first, -1), right = next(last, 1);
  if (left == nowhere || right == nowhere)
  {
    return std::nullopt;
  }
  const std::size_t far_left = next(left, -1), far_right = next(right, 1);
  if (far_left == nowhere || far_right == nowhere || length_[far_right] - length_[far_left] > longest)
  {
    return std::nullopt;
  }
  const std::array<std::size_t, neighbours> around{far_left, left, right, far_right};
  const SampledPoint &begin = points_[left], &end = points_[right];
  const double dy = end.y - begin.y, dz = end.z - begin.z, chord = std::hypot(dy, dz);
  const SampledPoint &first_of_all = points_[far_left], &last_of_all = points_[far_right];
  const double turn =
      angleBetween(begin.y - first_of_all.y, begin.z - first_of_all.z, last_of_all.y - end.y, last_of_all.z - end.z);
  Residual result{0, 0, 1, std::abs(dy) >= std::abs(dz), chord, turn};
  for (std::size_t i = first; i <= last; ++i)
  {
    double y = points_[i].y, z = points_[i].z, squares = 1;
    for (const std::size_t a : around)
    {
      double weight = 1;
      for (const std::size_t b : around)
      {
        weight *= a == b ? 1 : (length_[i] - length_[b]) / (length_[a] - length_[b]);
      }
      y -= weight * points_[a].y;
      z -= weight * points_[a].z;
      squares += weight * weight;
    }
    const double across = (dy * z - dz * y) / chord;
    result.at_first = i == first ? across : result.at_first;
    if (std::abs(across) > std::abs(result.across) || i == first)
    {
      result.across = across;
      result.deviation = std::sqrt(squares);
    }
  }
  return result;
}

constexpr std::size_t least_residuals = 11;
constexpr std::size_t block = 60;
/// Median of the absolute value of a normal variable of standard deviation 1.
constexpr double normal_median = 0.6745;

/// Residuals of the points for noise of 1, of the flat part or of the whole curve [m].
std::vector<double> residuals(const std::vector<SampledPoint>& points, bool only_flat)
{
  const CurveWindows windows(points);
  std::vector<double> result;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto residual = windows.residual(i, i);
    if (residual && (residual->flat || !only_flat))
    {
      result.push_back(std::abs(residual->across) / residual->deviation);
    }
  }
  return result;
}

double medianOf(std::vector<double>::iterator begin, std::vector<double>::iterator end)
{
  const auto middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end);
  return *middle;
}

constexpr double least_ratio = 10;           ///< of the distance from the curve and the noise
constexpr double least_fit_distance = 5e-6;  ///< [m]
constexpr double sharpest = 100;             ///< curvature that a profile may have on one side of a point only [1/m]
constexpr double largest_turn = 0.3;         ///< of the curve around a group [rad]; at a kink it is larger
constexpr double smooth_share = 0.25;        ///< largest share of that distance in the residuals of the neighbours
constexpr std::size_t longest_group = 3;
constexpr double larger_group = 1.5;  ///< least ratio of the distances by which a larger group is preferred

/// True if the curve is smooth at the neighbours of a group when the group is left out.
bool isSmoothWithout(const CurveWindows& windows, std::size_t first, std::size_t last, std::size_t size, double most)
{
  const auto is_smooth = [&](std::size_t point)
  {
    const auto residual = windows.residual(point, point, first, last);
    return !residual || std::abs(residual->across) <= most;
  };
  return (first == 0 || is_smooth(first - 1)) && (last + 1 >= size || is_smooth(last + 1));
}

/// Distance of a group from the curve of its neighbours if it is an outlier; 0 if it is none [m].
double distanceOf(const CurveWindows& windows, std::size_t first, std::size_t last, std::size_t size, double noise)
{
  const auto residual = windows.residual(first, last);
  if (!residual)
  {
    return 0;
  }
  const double distance = std::abs(residual->across);
  // A cubic over a length is off by a 16th of its square times the change of curvature.
  const double least = std::max({least_fit_distance, least_ratio * noise * residual->deviation,
                                 sharpest * residual->length * residual->length / 16});
  return residual->turn < largest_turn && std::abs(residual->at_first) > least &&
                 isSmoothWithout(windows, first, last, size, smooth_share * distance)
             ? distance
             : 0;
}

struct Group
{
  std::size_t first = 0, size = 0;
  double distance = 0;  ///< from the curve of the neighbours [m]; 0: there is none
};

/// The group that is farthest from the curve of its neighbours. Others may seem to be off because of it.
Group farthestGroup(const std::vector<SampledPoint>& points, double noise)
{
  const CurveWindows windows(points);
  Group farthest;
  for (std::size_t size = 1; size <= longest_group; ++size)
  {
    for (std::size_t i = 0; i + size <= points.size(); ++i)
    {
      const double distance = distanceOf(windows, i, i + size - 1, points.size(), noise);
      if (distance > farthest.distance * (size > farthest.size ? larger_group : 1))
      {
        farthest = {i, size, distance};
      }
    }
  }
  return farthest;
}

constexpr double least_gap = 2e-3;  ///< shortest distance at which points can be missing [m]
constexpr double gap_factor = 5;    ///< least ratio of such a distance to the median distance
constexpr double sure_gap =
    4e-3;  ///< distance over which points are always missing: arcs of profiles are 10 mm long [m]
constexpr double straight = 1e-3;  ///< angle below which three points are on a line [rad]

/// Angle between two neighbouring segments of a polygon [rad].
double turnAt(const std::vector<SampledPoint>& points, std::size_t i)
{
  const SampledPoint &a = points[i - 1], &b = points[i], &c = points[i + 1];
  return angleBetween(b.y - a.y, b.z - a.z, c.y - b.y, c.z - b.z);
}

bool isSteep(const std::vector<SampledPoint>& points, std::size_t i)
{
  return std::abs(points[i + 1].z - points[i].z) > std::abs(points[i + 1].y - points[i].y);
}

/// True if the curve between points i and i + 1 continues straight lines before and after it.
bool isStraight(const std::vector<SampledPoint>& points, std::size_t i)
{
  const bool before = i == 0 || turnAt(points, i) < straight;
  const bool after = i + 2 == points.size() || turnAt(points, i + 1) < straight;
  return before && after;
}
}  // namespace

std::optional<NoiseEstimate> estimatedNoise(const std::vector<SampledPoint>& points)
{
  std::vector<double> found = residuals(points, true);
  found = found.size() >= least_residuals ? found : residuals(points, false);
  if (found.size() < least_residuals)
  {
    return std::nullopt;
  }
  const std::size_t blocks = std::max<std::size_t>(1, found.size() / block);
  double largest = 0;
  for (std::size_t k = 0; k < blocks; ++k)
  {
    const auto at = [&](std::size_t part)
    { return found.begin() + static_cast<std::ptrdiff_t>(part * found.size() / blocks); };
    largest = std::max(largest, medianOf(at(k), at(k + 1)));
  }
  const double typical = medianOf(found.begin(), found.end());
  return NoiseEstimate{typical / normal_median, std::max(typical, largest) / normal_median};
}

Outliers omitOutliers(double noise, std::size_t most, std::vector<SampledPoint>& points)
{
  Outliers found;
  while (found.count <= most)
  {
    const Group group = farthestGroup(points, noise);
    if (group.distance == 0)
    {
      return found;
    }
    found.line = group.distance > found.largest ? points[group.first].line : found.line;
    found.largest = std::max(found.largest, group.distance);
    found.count += group.size;
    const auto first = points.begin() + static_cast<std::ptrdiff_t>(group.first);
    points.erase(first, first + static_cast<std::ptrdiff_t>(group.size));
  }
  return found;
}

void addInterpolationError(double noise, std::vector<ProfileSection>& sections)
{
  for (ProfileSection& section : sections)
  {
    section.error.position = noise;
    section.error.curvature = 6 * noise / (section.length * section.length);
  }
}

void markMissing(const std::vector<SampledPoint>& points, bool exact, std::vector<ProfileSection>& sections)
{
  const std::vector<double> length = polygonLength(points);
  std::vector<double> distance;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    distance.push_back(length[i + 1] - length[i]);
  }
  std::vector<double> sorted = distance;
  const double least = std::min(sure_gap, std::max(least_gap, gap_factor * medianOf(sorted.begin(), sorted.end())));
  double begin = 0;
  std::size_t i = 0;
  for (ProfileSection& section : sections)
  {
    const double middle = begin + 0.5 * section.length;
    begin += section.length;
    while (i + 2 < points.size() && length[i + 1] < middle)
    {
      ++i;
    }
    const bool is_line = (exact || isSteep(points, i)) && isStraight(points, i);
    section.error.missing = distance[i] > least && !is_line;
  }
}
}  // namespace wheel_rail_contact::core
