// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

#include "core/profile/curve/measures.h"
#include "core/profile/files/steps.h"
#include "core/text/table_title.h"

namespace wheel_rail_contact::core
{
namespace
{
using Points = std::vector<SampledPoint>;

/// Least height of a whole rail, and depth of its head [m].
constexpr double whole_height = 0.120, head_depth = 0.040;
constexpr double foot_ratio = 1.3;  ///< least ratio of the widths of foot and head
/// Least depth of the groove between two heads below the lower one [m].
constexpr double least_groove = 0.010;
/// Least ratio of the widths of a head and of a lip or guard beside it.
constexpr double head_ratio = 1.3;
constexpr double chord = 1e-3;  ///< over which the slope at an end is taken, despite the noise of the points [m]

/// True if points are the outline of a rail with its foot.
bool isWholeRail(const Points& points)
{
  const auto [bottom, top] = std::minmax_element(points.begin(), points.end(), isLower);
  const auto width = [&points](double depth)
  {
    const auto [left, right] = widthAt(points, depth);
    return right - left;
  };
  const double height = top->z - bottom->z;
  return height > whole_height && width(height) > foot_ratio * width(head_depth);
}

/// Keeps the head of the whole outline of a rail: from the top down to where both sides are widest.
void cutToHead(Points& points)
{
  const auto bottom = std::min_element(points.begin(), points.end(), isLower);
  std::rotate(points.begin(), bottom, points.end());
  const auto highest = std::max_element(points.begin(), points.end(), isLower);
  const double least = highest->z - head_depth;
  const auto is_below = [least](const SampledPoint& p) { return p.z < least; };
  const auto last = std::find_if(highest, points.end(), is_below);
  const auto first = std::find_if(std::make_reverse_iterator(highest), points.rend(), is_below).base();
  const auto [left, right] = std::minmax_element(first, last, isFartherInward);
  points = Points(std::min(left, right), std::max(left, right) + 1);
}

/// The points between two grooves, from the gauge side to the field side, and the range of y of their upper part [m].
struct HeadPart
{
  Points points;
  double left, right;

  double width() const { return right - left; }
};

/// The heads of an outline, from the gauge side. One whose sides both fall by the depth of a groove stands alone.
std::vector<HeadPart> headsOf(Points points)
{
  if (points.back().y < points.front().y)
  {
    std::reverse(points.begin(), points.end());
  }
  std::vector<std::size_t> grooves{0};
  std::size_t top = 0, bottom = 0;  // since the last groove
  bool falls = false;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    top = points[i].z > points[top].z ? i : top;
    bottom = falls && points[i].z < points[bottom].z ? i : bottom;
    if (!falls && points[i].z < points[top].z - least_groove)
    {
      falls = true;
      bottom = i;
    }
    else if (falls && points[i].z > points[bottom].z + least_groove)
    {
      falls = false;
      grooves.push_back(bottom);
      top = i;
    }
  }
  grooves.push_back(points.size() - 1);
  std::vector<HeadPart> heads;
  for (std::size_t k = 0; k + 1 < grooves.size(); ++k)
  {
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(grooves[k]);
    HeadPart head{Points(begin, points.begin() + static_cast<std::ptrdiff_t>(grooves[k + 1]) + 1), 0, 0};
    std::tie(head.left, head.right) = widthAt(head.points, least_groove);
    if (!heads.empty() && head.left < heads.back().right)
    {
      return {{points, head.left, head.right}};  // not a groove: the points run back
    }
    heads.push_back(head);
  }
  return heads;
}

/// Removes from the end of a curve the floor of a groove, or the underside of a head: what is flat, deep below the top
/// and, of an underside, runs back to the middle.
void cutFlatEnd(double top, double middle, bool is_groove, Points& points)
{
  while (points.size() > 2 && points.back().z < top - gauge_depth)
  {
    const SampledPoint& end = points.back();
    const auto before = std::find_if(points.rbegin(), points.rend(),
                                     [&end](const SampledPoint& p) { return distance(p, end) >= chord; });
    const bool is_flat = before != points.rend() && std::abs(before->z - end.z) < std::abs(before->y - end.y);
    if (!is_flat || (!is_groove && std::abs(end.y - middle) > std::abs(before->y - middle)))
    {
      return;
    }
    points.pop_back();
  }
}
}  // namespace

std::pair<double, double> widthAt(const Points& points, double depth)
{
  const double least = std::max_element(points.begin(), points.end(), isLower)->z - depth;
  std::pair<double, double> range{INFINITY, -INFINITY};
  for (const SampledPoint& p : points)
  {
    if (p.z >= least)
    {
      range = {std::min(range.first, p.y), std::max(range.second, p.y)};
    }
  }
  return range;
}

std::string keepHead(const TextFile& file, Points& points)
{
  if (isWholeRail(points))
  {
    cutToHead(points);
  }
  const std::vector<HeadPart> heads = headsOf(points);
  const auto is_narrow = [&heads](const HeadPart& other) { return heads.back().width() < head_ratio * other.width(); };
  const auto other = std::find_if(heads.begin(), heads.end() - 1, is_narrow);
  const Points& last = heads.back().points;
  const double top = std::max_element(last.begin(), last.end(), isLower)->z;
  // A wheel has a tread that does not fall on the field side.
  const bool has_groove = heads.size() > 1 && last.back().z < top - gauge_depth;
  file.refuseIf(has_groove && other != heads.end() - 1, 0,
                "the outline has " + std::to_string(heads.size()) + " heads, from y = " + millimetres(other->left) +
                    " to " + millimetres(other->right) + " and from " + millimetres(heads.back().left) + " to " +
                    millimetres(heads.back().right) +
                    ": the one on the field side is not clearly the running rail. Give each as a file "
                    "(rail/profile/parts), or reverse y");
  points = has_groove ? last : points;
  const auto [left, right] = widthAt(points, least_groove);
  for (const bool at_groove : {has_groove, false})
  {
    std::reverse(points.begin(), points.end());
    cutFlatEnd(top, 0.5 * (left + right), at_groove, points);
  }
  return has_groove ? "omitted what lies beside the head, on the gauge side (rail/profile/parts adds it)" : "";
}
}  // namespace wheel_rail_contact::core
