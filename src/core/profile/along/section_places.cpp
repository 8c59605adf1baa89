// SPDX-License-Identifier: BSD-3-Clause
// Corresponding places of two sections of a rail.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/profile/along/section_blend.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double sample_distance = 2.5e-4;  ///< along the profile [m]
constexpr double valley_depth = 3e-3;       ///< of a valley between two heads, below both [m]
constexpr double place_depth = 0.014;       ///< below the top of a head [m]: where the gauge is measured
constexpr double least_depth = 1e-3;        ///< a shallower side has no place of its own [m]
constexpr double depth_step = 0.1;          ///< of the depths that are tried, as a part of the largest one [-]
/// Least sine of the angle of the flank at a place [-]: on the flat floor of a valley or a shelf, a depth does not
/// determine a place.
constexpr double steep = 0.7;
constexpr double flat = 0.25;          ///< sine of the angle at which a corner ends and the top begins [-]
constexpr double least_corner = 2e-3;  ///< length from a place on a side to the end of the corner [m]
constexpr double alike = 0.1;          ///< largest relative difference of these lengths of corners that correspond [-]

struct Sample
{
  double u, y, z;
};

std::vector<Sample> samplesOf(const Profile& profile)
{
  const auto count = static_cast<std::size_t>(std::max(2.0, profile.length() / sample_distance));
  std::vector<Sample> samples;
  for (std::size_t i = 0; i <= count; ++i)
  {
    const double u = profile.length() * static_cast<double>(i) / static_cast<double>(count);
    const CurvePoint p = profile.at(u);
    samples.push_back({u, p.y, p.z});
  }
  return samples;
}

/// Part of a section between two valleys or ends: indices of samples.
struct Head
{
  std::size_t begin, top, end;
};

/// Divides a section at its valleys.
std::vector<Head> headsOf(const std::vector<Sample>& samples)
{
  std::vector<Head> heads;
  Head head{0, 0, 0};
  std::size_t valley = 0;  // lowest sample since the top of the head
  for (std::size_t i = 1; i < samples.size(); ++i)
  {
    const double z = samples[i].z;
    if (samples[valley].z > z)
    {
      valley = i;
    }
    const bool rises = z > samples[valley].z + valley_depth;
    if (rises && samples[head.top].z > samples[valley].z + valley_depth)
    {
      head.end = valley;
      heads.push_back(head);
      head = {valley, i, i};
      valley = i;
    }
    else if (z > samples[head.top].z)
    {
      head.top = valley = i;
    }
  }
  head.end = samples.size() - 1;
  heads.push_back(head);
  return heads;
}

/// Common width of two heads [m]; negative: their distance.
double overlap(const std::vector<Sample>& a, const Head& one, const std::vector<Sample>& b, const Head& other)
{
  const auto range = [](const std::vector<Sample>& samples, const Head& head)
  {
    double least = samples[head.begin].y, most = least;
    for (std::size_t i = head.begin; i <= head.end; ++i)
    {
      if (samples[i].z > samples[head.top].z - place_depth)
      {
        least = std::min(least, samples[i].y);
        most = std::max(most, samples[i].y);
      }
    }
    return std::make_pair(least, most);
  };
  const auto [a_least, a_most] = range(a, one);
  const auto [b_least, b_most] = range(b, other);
  return std::min(a_most, b_most) - std::max(a_least, b_least);
}

/// One side of a head, from its top downwards.
class HeadSide
{
 public:
  HeadSide(const std::vector<Sample>& samples, std::size_t top, std::size_t end)
      : samples_(samples), top_(top), end_(end)
  {
  }

  /// Depth of the deepest place below the top [m].
  double depth() const { return samples_[top_].z - samples_[lowest()].z; }
  /// A place and the sine of the angle of the flank there [-].
  struct Place
  {
    double u, steepness;
  };
  /// First place at a depth below the top [m].
  Place placeAt(double depth) const
  {
    const double z = samples_[top_].z - depth;
    for (std::size_t i = top_; i != end_; i = next(i))
    {
      const Sample &above = samples_[i], &below = samples_[next(i)];
      if (above.z >= z && below.z <= z && above.z > below.z)
      {
        const double drop = above.z - below.z;
        return {above.u + (below.u - above.u) * (above.z - z) / drop, drop / std::hypot(below.y - above.y, drop)};
      }
    }
    return {samples_[lowest()].u, 0};
  }
  /// Parameter u of the place above `u` [m] where the side becomes flat: the end of the corner. Nothing if it does not.
  std::optional<double> cornerAbove(double u) const
  {
    const double length = samples_[1].u - samples_[0].u;
    auto i = static_cast<std::size_t>(std::lround(u / length));
    double before = 0;
    for (; i != top_ && i < samples_.size(); i = top_ < end_ ? i - 1 : i + 1)
    {
      const Sample &below = samples_[i], &above = samples_[top_ < end_ ? i - 1 : i + 1];
      const double here = (above.z - below.z) / std::hypot(above.y - below.y, above.z - below.z);
      if (here < flat)
      {
        // Both slopes are those in the middle of their pieces.
        const double middle = 0.5 * (below.u + above.u), step = above.u - below.u;
        return before > flat ? std::make_optional(middle - step * (flat - here) / (before - here)) : std::nullopt;
      }
      before = here;
    }
    return std::nullopt;
  }

 private:
  std::size_t next(std::size_t i) const { return top_ < end_ ? i + 1 : i - 1; }
  std::size_t lowest() const
  {
    std::size_t lowest = top_;
    for (std::size_t i = top_; i != end_; i = next(i))
    {
      lowest = samples_[next(i)].z < samples_[lowest].z ? next(i) : lowest;
    }
    return lowest;
  }

  const std::vector<Sample>& samples_;
  std::size_t top_, end_;
};

/// Places on a side of two heads that correspond: the deepest one with steep flanks, and the end of the corner above it
/// if both corners are alike. Empty if a side is too shallow.
std::vector<CorrespondingPlaces> placesOn(const HeadSide& a, const HeadSide& b)
{
  const double deepest = std::min({place_depth, a.depth(), b.depth()});
  CorrespondingPlaces place{0, 0};
  double steepest = -1;
  for (double depth = deepest; depth >= std::max(least_depth, 0.5 * depth_step * deepest) && steepest < steep;
       depth -= depth_step * deepest)
  {
    const HeadSide::Place on_a = a.placeAt(depth), on_b = b.placeAt(depth);
    if (const double here = std::min(on_a.steepness, on_b.steepness); here > steepest)
    {
      steepest = here;
      place = {on_a.u, on_b.u};
    }
  }
  if (steepest < 0)
  {
    return {};
  }
  std::vector<CorrespondingPlaces> places{place};
  const std::optional<double> corner_a = a.cornerAbove(place.a), corner_b = b.cornerAbove(place.b);
  if (corner_a && corner_b)
  {
    const double length_a = std::abs(*corner_a - place.a), length_b = std::abs(*corner_b - place.b);
    if (std::min(length_a, length_b) > least_corner &&
        std::abs(length_a - length_b) < alike * std::max(length_a, length_b))
    {
      places.push_back({*corner_a, *corner_b});
    }
  }
  return places;
}

/// Adds those of the places of a side that lie behind the last one on both sections.
void addPlaces(std::vector<CorrespondingPlaces> of_side, std::vector<CorrespondingPlaces>& places)
{
  std::sort(of_side.begin(), of_side.end(),
            [](const CorrespondingPlaces& one, const CorrespondingPlaces& other) { return one.a < other.a; });
  for (const CorrespondingPlaces& place : of_side)
  {
    if (places.empty() || (place.a > places.back().a && place.b > places.back().b))
    {
      places.push_back(place);
    }
  }
}
}  // namespace

std::vector<CorrespondingPlaces> correspondingPlaces(const Profile& a, const Profile& b)
{
  const std::vector<Sample> on_a = samplesOf(a), on_b = samplesOf(b);
  const std::vector<Head> heads_a = headsOf(on_a), heads_b = headsOf(on_b);
  std::vector<CorrespondingPlaces> places;
  std::size_t first_free = 0;
  for (const Head& one : heads_a)
  {
    double widest = 0;
    std::size_t match = heads_b.size();
    for (std::size_t k = first_free; k < heads_b.size(); ++k)
    {
      const double width = overlap(on_a, one, on_b, heads_b[k]);
      if (width > widest)
      {
        widest = width;
        match = k;
      }
    }
    if (match < heads_b.size())
    {
      const Head& other = heads_b[match];
      addPlaces(placesOn({on_a, one.top, one.begin}, {on_b, other.top, other.begin}), places);
      addPlaces(placesOn({on_a, one.top, one.end}, {on_b, other.top, other.end}), places);
      first_free = match + 1;
    }
  }
  return places;
}
}  // namespace wheel_rail_contact::core
