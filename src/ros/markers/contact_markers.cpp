// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/contact_markers.h"

#include "ros/markers/marker_tools.h"
#include "ros/markers/patch_markers.h"
#include "ros/markers/track_markers.h"

namespace wheel_rail_contact
{
using visualization_msgs::MarkerArray;

namespace
{
PatchStyle styleOf(const MarkerConfig& markers)
{
  PatchStyle style;
  style.zoom = markers.zoom;
  style.lift = markers.zoom_height;
  style.pressure_height = markers.pressure_height;
  style.max_pressure = markers.max_pressure;
  style.force_scale = markers.force_scale;
  return style;
}

void addPatch(const PatchPicture& picture, const PatchStyle& style, const std_msgs::Header& header,
              MarkerArray& markers)
{
  markers.markers.push_back(truePatch(picture, style, header));
  if (style.zoom > 0)
  {
    markers.markers.push_back(zoomedPatch(picture, fineSurface(picture, style), style, header));
    markers.markers.push_back(zoomLine(picture, style, header));
  }
  if (style.force_scale > 0 && picture.patch->normal_force > 0)
  {
    markers.markers.push_back(forceArrow(picture, style, header));
  }
  markers.markers.push_back(patchLabel(picture, style, header));
}
}  // namespace

MarkerArray contactMarkers(const ContactAnswer& answer, const NodeConfig& config)
{
  MarkerArray markers;
  const std_msgs::Header& header = answer.header;
  if (!answer.result)
  {
    markers.markers.push_back(makeText(header, "status", 0, {answer.x, 0, config.markers.zoom_height},
                                       PatchStyle().letter_height, answer.reason));
    return markers;
  }
  const core::WheelsetResult& result = *answer.result;
  const PatchStyle style = styleOf(config.markers);
  TrackStyle track;
  track.rail_length = config.markers.rail_length;
  addRails(config.model, track, header, answer.x, {result.rail[0].deflection, result.rail[1].deflection}, markers);
  addWheelset(config.model, track, header, answer.x, answer.pose, markers);
  for (const core::Side side : {core::Side::left, core::Side::right})
  {
    for (const PatchPicture& picture : arrangePatches(result, side, answer.x, style))
    {
      addPatch(picture, style, header, markers);
    }
  }
  return markers;
}
}  // namespace wheel_rail_contact
