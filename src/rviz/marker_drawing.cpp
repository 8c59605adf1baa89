// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/marker_drawing.h"

#include <rviz/default_plugin/marker_utils.h>

namespace wheel_rail_contact
{
using visualization_msgs::Marker;

void MarkerDrawing::show(const visualization_msgs::MarkerArray& markers)
{
  for (const Marker& marker : markers.markers)
  {
    showOne(marker);
  }
  const MarkerKeys kept = keysOf(markers);
  for (auto entry = shown_.begin(); entry != shown_.end();)
  {
    entry = kept.count(entry->first) > 0 ? std::next(entry) : shown_.erase(entry);
  }
}

void MarkerDrawing::showOne(const Marker& marker)
{
  rviz::MarkerBasePtr& drawn = shown_[{marker.ns, marker.id}];
  if (!drawn)
  {
    drawn.reset(rviz::createMarker(marker.type, nullptr, context_, parent_));
  }
  drawn->setMessage(marker);
}
}  // namespace wheel_rail_contact
