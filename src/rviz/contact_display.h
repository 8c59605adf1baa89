// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OgreMaterial.h>
#include <OgreSharedPtr.h>
#include <rviz/default_plugin/markers/marker_base.h>
#include <rviz/message_filter_display.h>
#include <visualization_msgs/MarkerArray.h>
#include <wheel_rail_contact/WheelsetContact.h>

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "config/node_config.h"
#include "ros/markers/contact_trail.h"
#include "ros/markers/contact_view.h"
#include "ros/markers/marker_tools.h"
#include "ros/markers/pressure_scale.h"
#include "rviz/display_properties.h"
#include "rviz/screen_panel.h"

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

/// rviz display of the messages WheelsetContact (doc/rviz.md).
class ContactDisplay : public rviz::MessageFilterDisplay<WheelsetContact>
{
 public:
  ContactDisplay();
  ~ContactDisplay() override;

  void reset() override;
  void update(float wall_dt, float ros_dt) override;

 protected:
  void onInitialize() override;
  void onDisable() override;
  void processMessage(const WheelsetContact::ConstPtr& message) override;

 private:
  void clear();
  void extendTrail();
  void readParameters();
  /// Null while the parameters of the node are unknown.
  const core::ContactModelConfig* model() const;
  std::string parameterNamespace() const;
  void reportResult();
  void draw();
  void showPanel(PanelContents contents);
  void showWaiting();
  /// Contents and style of the picture, with the upper ends of the colour scales.
  SceneOptions sceneOptions();
  visualization_msgs::MarkerArray markers(const SceneOptions& options);
  /// The screen panel for a picture.
  PanelContents panelContents(const SceneOptions& options) const;

  DisplayProperties properties_;
  std::unique_ptr<MarkerDrawing> drawing_;
  std::unique_ptr<ScreenPanel> panel_;
  std::optional<NodeConfig> config_;  ///< parameters of the contact node; without them wheels and rails are not drawn
  ros::WallTime next_reading_;        ///< earliest time of the next attempt to read the parameters
  std::optional<ContactOutput> output_;
  ContactTrail trail_;
  PressureScale scale_{0}, stress_scale_{0};  ///< of the pressure, and of the von Mises stress
  ContactView view_;
  ros::WallTime waiting_since_;  ///< zero: not waiting for the first result
  int waited_ = -1;              ///< seconds in the panel
  bool changed_ = false;         ///< result or properties have changed since the last drawing
};
}  // namespace wheel_rail_contact
