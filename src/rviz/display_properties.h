// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rviz/properties/bool_property.h>
#include <rviz/properties/enum_property.h>
#include <rviz/properties/float_property.h>
#include <rviz/properties/int_property.h>
#include <rviz/properties/string_property.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "ros/markers/contact_scene.h"

namespace wheel_rail_contact
{
/// Properties of the display in the tree of rviz, and the options of the picture that follow from them.
class DisplayProperties
{
 public:
  /// The properties become children of `parent`, which owns them.
  explicit DisplayProperties(rviz::Property* parent);

  /// Calls `changed` after each change of a property other than that of parameters().
  void onChange(const std::function<void()>& changed);
  /// Calls `changed` after each change of parameters().
  void onParametersChange(const std::function<void()>& changed);

  /// Contents and style of the picture. The upper ends of the colour scales are not yet those of scale() and
  /// stressScale().
  SceneOptions options() const;
  /// Upper end of the colour scale of the pressure [Pa]; 0: it follows the pressures.
  double scale() const;
  /// Upper end of the colour scale of the von Mises stress [Pa]; 0: it follows the stresses.
  double stressScale() const;
  /// Distance of both contacts in a picture that follows them (ContactView) [m]; none: the picture follows the track.
  std::optional<double> contactSpacing() const;
  /// Number of points of the trail; 0: no trail.
  std::size_t trailLength() const;
  /// Height of the letters of the panel [pixels]; 0: no panel.
  int panelLetters() const;
  /// First line of the panel; empty: none.
  std::string panelTitle() const;
  /// Upper left corner of the panel [pixels].
  QPoint panelCorner() const;
  /// Namespace of the parameters of the node; empty: the namespace of the topic.
  std::string parameters() const;

 private:
  void makePatchProperties(rviz::Property* parent);
  void makeTrackProperties(rviz::Property* parent);
  void makeTextProperties(rviz::Property* parent);
  std::vector<core::Side> sides() const;
  PatchStyle patchStyle() const;
  TrackStyle trackStyle() const;

  rviz::StringProperty* parameters_;
  rviz::EnumProperty* side_;
  rviz::BoolProperty *follow_, *follow_contact_;
  rviz::FloatProperty *place_, *contact_spacing_, *line_width_;
  rviz::BoolProperty *patches_, *outlines_;
  rviz::FloatProperty *size_, *height_, *lift_, *max_pressure_;
  rviz::BoolProperty* stress_;
  rviz::FloatProperty* max_stress_;
  rviz::BoolProperty *forces_, *friction_;
  rviz::FloatProperty *force_length_, *arrow_width_;
  rviz::BoolProperty *wheels_, *wheel_cut_;
  rviz::FloatProperty *wheel_sweep_, *wheel_alpha_;
  rviz::BoolProperty *rails_, *rails_at_rest_;
  rviz::FloatProperty *rail_length_, *rail_alpha_, *deflection_scale_;
  rviz::BoolProperty* trail_;
  rviz::IntProperty* trail_length_;
  rviz::FloatProperty* trail_width_;
  rviz::BoolProperty* labels_;
  rviz::FloatProperty* letter_height_;
  rviz::BoolProperty* panel_;
  rviz::IntProperty *panel_letters_, *panel_left_, *panel_top_;
  rviz::StringProperty* panel_title_;
};
}  // namespace wheel_rail_contact
