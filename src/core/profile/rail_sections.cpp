// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/rail_sections.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/profile/section_blend.h"

namespace wheel_rail_contact::core
{
namespace
{
void check(const RailSeries& series)
{
  for (std::size_t i = 0; i < series.size(); ++i)
  {
    const std::string name = "section " + std::to_string(i + 1) + " of a rail";
    if (series[i].profile == nullptr || series[i].profile->parts().size() != 1)
    {
      throw std::invalid_argument(name + " must have a profile of one part");
    }
    if (!std::isfinite(series[i].x) || (i > 0 && !(series[i].x > series[i - 1].x)))
    {
      throw std::invalid_argument(name + ": x must increase");
    }
    if (series[i].places.size() != series.front().places.size())
    {
      throw std::invalid_argument(name + " must have as many places as the first one");
    }
  }
  if (series.empty())
  {
    throw std::invalid_argument("a part of a rail has no sections");
  }
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
}  // namespace

RailSections::RailSections(std::vector<RailSeries> parts, Placement placement)
    : parts_(std::move(parts)), placement_(placement)
{
  if (parts_.empty())
  {
    throw std::invalid_argument("a rail needs at least one part");
  }
  for (const RailSeries& series : parts_)
  {
    check(series);
    blends_.emplace_back();
    for (std::size_t i = 1; i < series.size(); ++i)
    {
      const RailSection &a = series[i - 1], &b = series[i];
      blends_.back().push_back(a.profile == b.profile
                                   ? nullptr
                                   : std::make_shared<const SectionBlend>(*a.profile, *b.profile, placesOf(a, b)));
    }
  }
}

bool RailSections::contains(double x) const
{
  const RailSeries& running = parts_.front();
  return running.size() == 1 ? std::isfinite(x) : x >= running.front().x && x <= running.back().x;
}
}  // namespace wheel_rail_contact::core
