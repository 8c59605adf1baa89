// SPDX-License-Identifier: BSD-3-Clause
// Corresponding places of two sections of a rail.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/profile/section_blend.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double sample_distance = 2.5e-4;  ///< along the profile [m]
constexpr double valley_depth = 3e-3;       ///< of a valley between two heads, below both [m]
constexpr double place_depth = 0.014;       ///< below the top of a head [m]: where the gauge is measured
constexpr double least_depth = 1e-3;        ///< a shallower side has no place of its own [m]

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
  /// Parameter u of the first place at a depth below the top [m].
  double placeAt(double depth) const
  {
    const double z = samples_[top_].z - depth;
    for (std::size_t i = top_; i != end_; i = next(i))
    {
      const Sample &above = samples_[i], &below = samples_[next(i)];
      if (above.z >= z && below.z <= z && above.z > below.z)
      {
        return above.u + (below.u - above.u) * (above.z - z) / (above.z - below.z);
      }
    }
    return samples_[lowest()].u;
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

/// Adds the place on a side of two heads that correspond, unless a side is too shallow.
void addPlace(const HeadSide& a, const HeadSide& b, std::vector<CorrespondingPlaces>& places)
{
  const double depth = std::min({place_depth, a.depth(), b.depth()});
  if (depth >= least_depth)
  {
    const CorrespondingPlaces place{a.placeAt(depth), b.placeAt(depth)};
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
    std::size_t partner = heads_b.size();
    for (std::size_t k = first_free; k < heads_b.size(); ++k)
    {
      const double width = overlap(on_a, one, on_b, heads_b[k]);
      if (width > widest)
      {
        widest = width;
        partner = k;
      }
    }
    if (partner < heads_b.size())
    {
      const Head& other = heads_b[partner];
      addPlace({on_a, one.top, one.begin}, {on_b, other.top, other.begin}, places);
      addPlace({on_a, one.top, one.end}, {on_b, other.top, other.end}, places);
      first_free = partner + 1;
    }
  }
  if (places.empty())
  {
    places.push_back({on_a[heads_a.front().top].u, on_b[heads_b.front().top].u});
  }
  return places;
}
}  // namespace wheel_rail_contact::core
