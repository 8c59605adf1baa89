// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../../usual_headers.h"
#include "core/profile/along/section_blend.h"
#include "wheel_rail_contact/core/profile.h"

/// Rail sections of straight lines and arcs, and their exact curves.
namespace wheel_rail_contact::core::section_scenes
{
constexpr double corner = 0.013;      ///< radius of both upper corners of a head [m]
constexpr double head_depth = 0.030;  ///< depth of the sides of a head below its top [m]

/// Size and place of a head with a flat top, vertical sides and round corners, in the profile frame [m].
struct Head
{
  double y = 0;         ///< middle
  double top = 0;       ///< z of the top
  double half = 0.036;  ///< half width
  double radius = corner;
};

/// Adds the sections of a head from the gauge side to the field side.
/// @param first, last  lengths of its straight sides below the corners [m]
inline void addHead(const Head& head, double first, double last, std::vector<ProfileSection>& sections)
{
  const double r = head.radius, low = head.top - r, flat = head.half - r, quarter = 0.5 * M_PI * r;
  sections.push_back({LineSection{head.y - head.half, low - first, 0, 1}, first});
  sections.push_back({ArcSection{head.y - flat, low, r, M_PI, -1}, quarter});
  sections.push_back({LineSection{head.y - flat, head.top, 1, 0}, 2 * flat});
  sections.push_back({ArcSection{head.y + flat, low, r, 0.5 * M_PI, -1}, quarter});
  sections.push_back({LineSection{head.y + head.half, low, 0, -1}, last});
}

/// Profile of one head.
inline Profile profileOf(const Head& head)
{
  std::vector<ProfileSection> sections;
  addHead(head, head_depth - head.radius, head_depth - head.radius, sections);
  return {"head", sections};
}

/// Profile of two heads with their tops at the same height, and a groove between them.
/// @param depth  of the flat groove below the tops, more than the corner radius [m]
inline Profile groovedProfile(const Head& one, const Head& two, double depth)
{
  std::vector<ProfileSection> sections;
  addHead(one, head_depth - one.radius, depth - one.radius, sections);
  const double begin = one.y + one.half, end = two.y - two.half;
  sections.push_back({LineSection{begin, one.top - depth, 1, 0}, end - begin});
  addHead(two, depth - two.radius, head_depth - two.radius, sections);
  return {"grooved", sections};
}

/// Profile of several parts.
class ProfileOfParts : public Profile
{
 public:
  explicit ProfileOfParts(const std::vector<std::vector<ProfileSection>>& parts) : Profile("parts")
  {
    for (const std::vector<ProfileSection>& sections : parts)
    {
      beginPart();
      for (const ProfileSection& section : sections)
      {
        add(section);
      }
    }
    makeBuckets();
    findOrigins();
  }
};

inline std::shared_ptr<const Profile> shared(const Profile& profile)
{
  return std::make_shared<const Profile>(profile);
}

/// Curve of a blend as a profile.
inline Profile curveOf(const SectionBlend& blend, double share)
{
  std::vector<ProfileSection> sections;
  for (std::size_t i = 0; i < blend.size(); ++i)
  {
    sections.push_back({blend.at(i, share), blend.length()});
  }
  return {"blend", sections};
}

/// Curve between two sections at corresponding places found from their shape.
inline Profile between(const Profile& a, const Profile& b, double share)
{
  return curveOf({a, b, correspondingPlaces(a, b)}, share);
}

/// Largest distance of points of `curve` from `exact`, across it [m].
inline double distanceFrom(const Profile& exact, const Profile& curve)
{
  constexpr int count = 2000;
  double largest = 0;
  for (int i = 0; i <= count; ++i)
  {
    const CurvePoint p = curve.at(curve.length() * i / count);
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= count; ++k)
    {
      const CurvePoint q = exact.at(exact.length() * k / count);
      const double y = p.y - q.y, z = p.z - q.z, along = y * q.dy + z * q.dz;
      const double near = exact.length() / count;  // beyond half a step, another point is nearer
      least = std::abs(along) < near ? std::min(least, std::abs(y * q.dz - z * q.dy)) : least;
    }
    largest = std::max(largest, least);
  }
  return largest;
}
}  // namespace wheel_rail_contact::core::section_scenes
