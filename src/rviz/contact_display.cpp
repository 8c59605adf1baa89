// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/contact_display.h"

#include <rviz/default_plugin/marker_utils.h>

#include <exception>
#include <pluginlib/class_list_macros.hpp>

#include "ros/evaluation/contact_statistics.h"
#include "ros/markers/marker_tools.h"
#include "ros/markers/rail_motion.h"
#include "ros/markers/stress_section.h"
#include "ros/parameters/node_parameters.h"

namespace wheel_rail_contact
{
using rviz::StatusProperty;
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

ContactDisplay::ContactDisplay() : properties_(this)
{
  properties_.onChange([this] { changed_ = true; });
  properties_.onParametersChange([this] { reset(); });
}

ContactDisplay::~ContactDisplay() = default;

void ContactDisplay::onInitialize()
{
  MFDClass::onInitialize();
  drawing_ = std::make_unique<MarkerDrawing>(context_, scene_node_);
  panel_ = std::make_unique<ScreenPanel>();
}

void ContactDisplay::onDisable()
{
  MFDClass::onDisable();
  clear();
}

void ContactDisplay::reset()
{
  MFDClass::reset();
  clear();
  config_.reset();
  next_reading_ = ros::WallTime();
}

void ContactDisplay::clear()
{
  output_.reset();
  waiting_since_ = ros::WallTime();
  waited_ = -1;
  trail_.clear();
  view_.clear();
  scale_ = PressureScale(properties_.scale());
  stress_scale_ = PressureScale(properties_.stressScale());
  changed_ = false;
  if (drawing_)
  {
    drawing_->show({});
    panel_->hide();
  }
}

void ContactDisplay::processMessage(const WheelsetContact::ConstPtr& message)
{
  if (!config_ && ros::WallTime::now() >= next_reading_)
  {
    readParameters();
  }
  try
  {
    output_ = outputFromMessage(*message);
  }
  catch (const std::invalid_argument& error)
  {
    clear();
    setStatusStd(StatusProperty::Error, "Result", error.what());
    return;
  }
  extendTrail();
  reportResult();
  changed_ = true;
}

const core::ContactModelConfig* ContactDisplay::model() const
{
  return config_ ? &config_->model : nullptr;
}

void ContactDisplay::extendTrail()
{
  const std::size_t length = properties_.trailLength();
  if (length > 0)
  {
    trail_.add(*output_, restingRails(model(), output_->state.distance));
  }
  trail_.limit(length);
}

std::string ContactDisplay::parameterNamespace() const
{
  if (!properties_.parameters().empty())
  {
    return update_nh_.resolveName(properties_.parameters());
  }
  const std::string topic = update_nh_.resolveName(topic_property_->getTopicStd());
  return topic.substr(0, topic.rfind('/'));
}

void ContactDisplay::readParameters()
{
  try
  {
    const std::string name = parameterNamespace();
    config_ = readNodeParameters(ros::NodeHandle(name));
    setStatusStd(StatusProperty::Ok, "Parameters", "profiles and track read from " + name);
  }
  catch (const std::exception& error)
  {
    next_reading_ = ros::WallTime::now() + ros::WallDuration(2);
    setStatusStd(StatusProperty::Warn, "Parameters",
                 std::string("wheels and rails are not drawn, deflections are not magnified: ") + error.what());
  }
}

void ContactDisplay::reportResult()
{
  const bool usable = output_->result != nullptr;
  const std::string name = statusName(output_->status);
  setStatusStd(usable ? StatusProperty::Ok : StatusProperty::Warn, "Result",
               output_->reason.empty() ? name : name + ": " + output_->reason);
}

void ContactDisplay::update(float /*wall_dt*/, float /*ros_dt*/)
{
  if (changed_ && output_)
  {
    changed_ = false;
    draw();
  }
  else if (!output_)
  {
    showWaiting();
  }
}

void ContactDisplay::showWaiting()
{
  const ros::WallTime now = ros::WallTime::now();
  waiting_since_ = waiting_since_.isZero() ? now : waiting_since_;
  const int seconds = static_cast<int>((now - waiting_since_).toSec());
  if (std::exchange(waited_, seconds) != seconds)
  {
    const std::string given = topic_property_->getTopicStd();
    std::string error;
    const std::string topic = ros::names::validate(given, error) ? update_nh_.resolveName(given) : given;
    showPanel({{{"no result on " + topic + " for " + std::to_string(seconds) + " s", Tone::warning}}, {}, {}});
  }
}

visualization_msgs::MarkerArray ContactDisplay::markers(const SceneOptions& options)
{
  const std::optional<double> spacing = properties_.contactSpacing();
  return spacing ? view_.markers(*output_, model(), trail_, options, *spacing)
                 : sceneMarkers(*output_, model(), trail_, options);
}

PanelContents ContactDisplay::panelContents(const SceneOptions& options) const
{
  PanelContents contents;
  contents.lines = resultLines(*output_, options.track.sides);
  contents.scales.push_back(
      {trail_.points().empty() ? "pressure [MPa]" : "pressure [MPa]; dots: earlier contact points",
       options.patch.max_pressure, highestPressure(*output_, options.track.sides)});
  if (const double highest = highestStress(*output_, options.track.sides); options.stress && highest > 0)
  {
    contents.scales.push_back({"von Mises stress [MPa]; crosses: highest", options.max_stress, highest});
  }
  const auto explain = [&contents](bool is_drawn, const std_msgs::ColorRGBA& color, const char* text)
  {
    if (is_drawn)
    {
      contents.legend.push_back({color, text});
    }
  };
  explain(options.forces, scene_colors::force, "normal force");
  explain(options.friction && output_->result && output_->result->speed != 0, scene_colors::friction,
          "friction on the rail");
  explain(model() && options.wheels, scene_colors::wheel_section, "wheel section");
  explain(model() && options.rails_at_rest, scene_colors::rail_at_rest, "rail at rest");
  return contents;
}

SceneOptions ContactDisplay::sceneOptions()
{
  for (const auto& [scale, fixed] :
       {std::pair(&scale_, properties_.scale()), std::pair(&stress_scale_, properties_.stressScale())})
  {
    if (scale->fixed() != fixed)
    {
      *scale = PressureScale(fixed);
    }
  }
  SceneOptions options = properties_.options();
  const ros::Time& stamp = output_->header.stamp;
  options.patch.max_pressure = scale_.update(stamp, highestPressure(*output_, options.track.sides));
  options.max_stress = stress_scale_.update(stamp, highestStress(*output_, options.track.sides));
  return options;
}

void ContactDisplay::draw()
{
  const SceneOptions options = sceneOptions();
  drawing_->show(markers(options));
  showPanel(panelContents(options));
}

void ContactDisplay::showPanel(PanelContents contents)
{
  if (const std::string title = properties_.panelTitle(); !title.empty())
  {
    contents.lines.insert(contents.lines.begin(), {title, contents.lines.front().tone});
  }
  const int letters = properties_.panelLetters();
  letters > 0 ? panel_->show(panelPicture(contents, letters), properties_.panelCorner()) : panel_->hide();
  context_->queueRender();
}
}  // namespace wheel_rail_contact

PLUGINLIB_EXPORT_CLASS(wheel_rail_contact::ContactDisplay, rviz::Display)
