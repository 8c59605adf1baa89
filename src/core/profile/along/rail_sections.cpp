// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/profile.h"

#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/option_check.h"
#include "core/profile/along/section_blend.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Largest height of the crown over the origin of a running rail [m]. Wear is less.
constexpr double origin_tolerance = 0.005;
constexpr double crown_spacing = 1e-4;  ///< of the places at which the crown is searched for [m]

/// @throw std::invalid_argument "PART, section N REASON", unless `rule` is true. Index of the section: from 0.
void requireSection(bool rule, const std::string& part, std::size_t section, const std::string& reason)
{
  refuseIf(!rule, part + ", section " + std::to_string(section + 1) + " " + reason);
}

/// True if the places that a section has increase along its profile.
bool areOnProfile(const RailSection& section)
{
  double before = 0;
  for (const double place : section.places)
  {
    if (std::isfinite(place) && !(place >= before && place <= section.profile->length()))
    {
      return false;
    }
    before = std::isfinite(place) ? place : before;
  }
  return true;
}

void check(const RailSeries& series, const std::string& part)
{
  refuseIf(series.empty(), part + " has no sections");
  for (std::size_t i = 0; i < series.size(); ++i)
  {
    const RailSection& section = series[i];
    requireSection(section.profile && section.profile->parts().size() == 1, part, i, "must have a profile of one part");
    requireSection(std::isfinite(section.x) && (i == 0 || section.x > series[i - 1].x), part, i,
                   "must have a finite x above that of the section before");
    requireSection(section.places.size() == series.front().places.size(), part, i,
                   "must have as many places as the first one");
    requireSection(areOnProfile(section), part, i, "must have increasing places on its profile");
  }
}

/// True if the origin of a section is on its crown.
bool hasOriginOnCrown(const Profile& profile)
{
  for (double u = 0; u < profile.length(); u += crown_spacing)
  {
    const CurvePoint p = profile.at(u);
    if (std::abs(p.y) <= crown_spacing && std::abs(p.z) <= origin_tolerance)
    {
      return true;
    }
  }
  return false;
}

std::vector<CorrespondingPlaces> placesOf(const RailSection& a, const RailSection& b)
{
  if (a.places.empty())
  {
    return correspondingPlaces(*a.profile, *b.profile);
  }
  std::vector<CorrespondingPlaces> places;
  for (std::size_t k = 0; k < a.places.size(); ++k)
  {
    if (std::isfinite(a.places[k]) && std::isfinite(b.places[k]))
    {
      places.push_back({a.places[k], b.places[k]});
    }
  }
  return places;
}

/// Curves between a section and the next one; null if both are the same profile.
std::shared_ptr<const SectionBlend> blendOf(const RailSeries& series, std::size_t index, const std::string& part)
{
  const RailSection &a = series[index], &b = series[index + 1];
  if (a.profile == b.profile)
  {
    return nullptr;
  }
  try
  {
    return std::make_shared<const SectionBlend>(*a.profile, *b.profile, placesOf(a, b));
  }
  catch (const std::invalid_argument& error)
  {
    throw std::invalid_argument(part + ", sections " + std::to_string(index + 1) + " and " + std::to_string(index + 2) +
                                " " + error.what());
  }
}
}  // namespace

RailSections::RailSections(std::vector<RailSeries> parts, Placement placement)
    : parts_(std::move(parts)), placement_(placement)
{
  refuseIf(parts_.empty(), "a rail needs at least one part");
  for (std::size_t k = 0; k < parts_.size(); ++k)
  {
    const RailSeries& series = parts_[k];
    const std::string part = "part " + std::to_string(k + 1) + " of a rail";
    check(series, part);
    blends_.emplace_back();
    // Of profiles that follow each other repeatedly.
    std::map<std::pair<const Profile*, const Profile*>, std::shared_ptr<const SectionBlend>> known;
    for (std::size_t i = 0; i + 1 < series.size(); ++i)
    {
      std::shared_ptr<const SectionBlend>& blend = known[{series[i].profile.get(), series[i + 1].profile.get()}];
      blend = blend && series[i].places.empty() ? blend : blendOf(series, i, part);
      blends_.back().push_back(blend);
    }
  }
  checkPlacement();
}

/// The first section, and with Placement::gauge each one, places the rail and its reference point by its crown.
void RailSections::checkPlacement() const
{
  const RailSeries& running = parts_.front();
  const bool by_gauge = placement_ == Placement::gauge;
  refuseIf(
      by_gauge && running.size() > 1 && parts_.size() > 1,
      "further parts of a rail whose sections change must be placed by coordinates: the gauge places each section");
  for (std::size_t i = 0; i < (by_gauge ? running.size() : 1); ++i)
  {
    requireSection(hasOriginOnCrown(*running[i].profile), "the running rail", i,
                   "must have its origin on its crown, within 5 mm in height");
  }
}

bool RailSections::contains(double x) const
{
  const RailSeries& running = parts_.front();
  return running.size() == 1 ? std::isfinite(x) : x >= running.front().x && x <= running.back().x;
}
}  // namespace wheel_rail_contact::core
