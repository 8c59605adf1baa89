// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../usual_headers.h"
#include "config/node_config.h"
#include "ros/evaluation/contact_evaluator.h"
#include "ros/markers/marker_tools.h"

namespace wheel_rail_contact
{
inline NodeConfig exampleConfig()
{
  return readNodeConfig(parameterTree(YAML::Load("{wheel: {profile: S1002}, rail: {profile: UIC60_manchester}}")), "",
                        {"", nullptr});
}

/// Pointer of an output to a result that the test owns, and may change.
inline std::shared_ptr<const core::WheelsetResult> unowned(const core::WheelsetResult& result)
{
  return {std::shared_ptr<const core::WheelsetResult>(), &result};
}

/// A result with one patch on each side, with an elliptic pressure as in Hertzian contact. It is not a solution.
class ResultScene : public testing::Test
{
 protected:
  ResultScene()
  {
    result.status = core::ContactStatus::ok;
    result.z = 0.46;
    for (const core::Side side : {core::Side::left, core::Side::right})
    {
      result.patches.push_back(makePatch(side, 0.75));
    }
    output.header.frame_id = "track";
    output.header.stamp = ros::Time(10);
    output.state.x = result.x = 3;
    output.result = unowned(result);
  }

  static core::PatchResult makePatch(core::Side side, double distance)
  {
    const double sign = side == core::Side::left ? 1 : -1;
    core::PatchResult patch;
    patch.side = side;
    patch.pose = {0, sign * distance, -1e-4, sign * 0.03};
    patch.normal_force = 1e5;
    patch.area = 192e-6;
    patch.max_pressure = 982e6;
    patch.grid.nx = 20;
    patch.grid.ny = 10;
    patch.grid.dx = patch.grid.dy = 1e-3;
    patch.grid.x0 = -9.5e-3;
    patch.grid.y0 = -4.5e-3;
    patch.pressure.resize(20, 10);
    for (int i = 0; i < 20; ++i)
    {
      for (int j = 0; j < 10; ++j)
      {
        const double r = std::pow(patch.grid.x(i) / 8e-3, 2) + std::pow(patch.grid.y(j) / 4e-3, 2);
        patch.pressure(i, j) = patch.max_pressure * std::sqrt(std::max(0.0, 1 - r));
      }
    }
    return patch;
  }

  const NodeConfig config = exampleConfig();
  core::WheelsetResult result;
  ContactOutput output;
};

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

inline const Marker& findMarker(const MarkerArray& markers, const std::string& ns, int id)
{
  const auto found = std::find_if(markers.markers.begin(), markers.markers.end(),
                                  [&](const Marker& marker) { return marker.ns == ns && marker.id == id; });
  if (found == markers.markers.end())
  {
    throw std::out_of_range("no marker " + ns + " " + std::to_string(id));
  }
  return *found;
}

/// Smallest and largest coordinate of the points of a marker.
inline std::pair<double, double> range(const Marker& marker, double geometry_msgs::Point::*coordinate)
{
  const auto ends = std::minmax_element(marker.points.begin(), marker.points.end(),
                                        [&](const auto& a, const auto& b) { return a.*coordinate < b.*coordinate; });
  return {*ends.first.*coordinate, *ends.second.*coordinate};
}
}  // namespace wheel_rail_contact
