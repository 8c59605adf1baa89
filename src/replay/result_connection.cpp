// SPDX-License-Identifier: BSD-3-Clause
#include "replay/result_connection.h"

#include <ros/message_traits.h>

#include <algorithm>
#include <iomanip>
#include <set>
#include <sstream>

#include <wheel_rail_contact/WheelsetContact.h>
#include "core/balance/rail_support.h"
#include "replay/replay_options.h"
#include "replay/replay_source.h"

namespace wheel_rail_contact
{
namespace
{
constexpr int points = 400;
constexpr int section_points = 150;       ///< of each outline of a rail that changes
constexpr std::size_t most_places = 200;  ///< at which a rail that changes is drawn

/// Places of the sections of a rail, and places between them if there are few; of too many, equally spaced ones [m].
std::vector<double> drawnPlaces(const core::RailSections& sections)
{
  std::set<double> of_sections;
  for (const core::RailSeries& part : sections.parts())
  {
    for (const core::RailSection& section : part)
    {
      if (sections.contains(section.x))
      {
        of_sections.insert(section.x);
      }
    }
  }
  const std::vector<double> all(of_sections.begin(), of_sections.end());
  const std::size_t pieces = std::max<std::size_t>(1, most_places / all.size());
  const std::size_t step = (all.size() - 1) / most_places + 1;
  std::vector<double> places;
  for (std::size_t i = 0; i + 1 < all.size(); i += step)
  {
    for (std::size_t k = 0; k < pieces; ++k)
    {
      const double share = static_cast<double>(k) / static_cast<double>(pieces);
      places.push_back(all[i] + share * (all[i + 1] - all[i]));
    }
  }
  places.push_back(all.back());
  return places;
}

void write(const core::PlanePoint& point, std::ostream& text)
{
  text.precision(7);
  text << point.y << ' ' << point.z << '\n';
}

template <typename Place>
std::string outline(const core::Profile& profile, const Place& place)
{
  std::ostringstream text;
  const core::ParameterRange part = profile.parts().front();
  for (int i = 0; i < points; ++i)
  {
    write(place(part.begin + (part.end - part.begin) * i / (points - 1)), text);
  }
  return text.str();
}

std::string railOutlineText(const core::ContactModelConfig& config, core::Side side)
{
  const core::PlacedRail rail = core::restingRail(config, side);
  return outline(rail.profile(), [&rail](double u) { return rail.at(u); });
}

std::string railSectionsText(const core::ContactModelConfig& config, core::Side side)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(6);
  for (const double x : drawnPlaces(*config.rail_sections[side]))
  {
    const core::PlacedRail rail = core::restingRail(config, side, x);
    for (const core::ParameterRange& part : rail.profile().parts())
    {
      text << "x " << x << '\n';
      for (int i = 0; i < section_points; ++i)
      {
        const core::PlanePoint p = rail.at(part.begin + (part.end - part.begin) * i / (section_points - 1));
        text << p.y << ' ' << p.z << '\n';
      }
    }
  }
  return text.str();
}

std::string railReferenceText(const core::ContactModelConfig& config, core::Side side)
{
  std::ostringstream text;
  write(core::restingRail(config, side).referencePoint(), text);
  return text.str();
}

std::string wheelOutlineText(const core::ContactModelConfig& config, core::Side side)
{
  const core::Profile& profile = *config.wheel_profile[side];
  const core::WheelsetConfig& wheelset = config.wheelset;
  return outline(profile,
                 [&](double u)
                 {
                   const core::CurvePoint p = profile.at(u);
                   return core::PlanePoint{wheelset.halfBase() + p.y, p.z - wheelset.rolling_radius[side], p.dy, p.dz};
                 });
}
}  // namespace

BagConnection resultConnection(const std::string& wheelset, const std::string& description,
                               const core::ContactModelConfig& model)
{
  BagConnection connection;
  connection.topic = resultTopic(wheelset);
  connection.header.set("topic", connection.topic)
      .set("type", ros::message_traits::datatype<WheelsetContact>())
      .set("md5sum", ros::message_traits::md5sum<WheelsetContact>())
      .set("message_definition", ros::message_traits::definition<WheelsetContact>())
      .set("callerid", wheelset + "/contact_node")
      .set(description_field, description);
  for (const core::Side side : core::sides)
  {
    const std::string name = nameOf(side) + std::string("_");
    if (model.rail_sections[side])
    {
      connection.header.set(name + "rail_sections", railSectionsText(model, side));
    }
    connection.header.set(name + "rail_outline", railOutlineText(model, side))
        .set(name + "rail_reference", railReferenceText(model, side))
        .set(name + "wheel_outline", wheelOutlineText(model, side));
  }
  return connection;
}
}  // namespace wheel_rail_contact
