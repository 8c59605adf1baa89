// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OgreMaterial.h>
#include <OgreSharedPtr.h>
#include <rviz/default_plugin/markers/marker_base.h>
#include <visualization_msgs/MarkerArray.h>

#include <map>

#include "ros/markers/marker_tools.h"

namespace wheel_rail_contact
{
/// Draws markers in the scene of rviz, with the marker classes of rviz.
class MarkerDrawing
{
 public:
  /// `context` and `parent` must outlive the object.
  MarkerDrawing(rviz::DisplayContext* context, Ogre::SceneNode* parent) : context_(context), parent_(parent) {}

  /// Shows these markers, and removes all others that it has shown.
  void show(const visualization_msgs::MarkerArray& markers);

 private:
  void showOne(const visualization_msgs::Marker& marker);

  rviz::DisplayContext* context_;
  Ogre::SceneNode* parent_;
  std::map<MarkerKey, rviz::MarkerBasePtr> shown_;
};
}  // namespace wheel_rail_contact
