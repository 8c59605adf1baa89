// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/display_properties.h"

#include "core/constants.h"

namespace wheel_rail_contact
{
using rviz::BoolProperty;
using rviz::FloatProperty;
using rviz::IntProperty;
using rviz::Property;

namespace
{
constexpr int both_sides = 2;

template <typename Number, typename Value>
Number* make(const char* name, Value value, Value least, Value most, const char* description, Property* parent)
{
  auto* property = new Number(name, value, description, parent);
  property->setMin(least);
  property->setMax(most);
  return property;
}

constexpr auto make_float = make<FloatProperty, float>;
constexpr auto make_int = make<IntProperty, int>;

void connectBelow(Property* property, const std::function<void()>& changed)
{
  QObject::connect(property, &Property::changed, changed);
  for (int i = 0; i < property->numChildren(); ++i)
  {
    connectBelow(property->childAt(i), changed);
  }
}
}  // namespace

DisplayProperties::DisplayProperties(Property* parent)
{
  parameters_ = new rviz::StringProperty(
      "Parameters", "",
      "Namespace of the parameters of the contact node, which give the profiles; empty: the namespace of the topic",
      parent);
  side_ = new rviz::EnumProperty("Side", "both", "Side of the track that is drawn", parent);
  side_->addOption("left", static_cast<int>(core::Side::left));
  side_->addOption("right", static_cast<int>(core::Side::right));
  side_->addOption("both", both_sides);
  follow_ =
      new BoolProperty("Follow Wheelset", false, "Draw the wheelset at Place, which keeps it in the view", parent);
  place_ = make_float("Place", 0, -1e6F, 1e6F, "Place in the picture along the track [m]", follow_);
  follow_contact_ = new BoolProperty("Follow Contact", false,
                                     "Draw the contact of each side at a fixed place, with its normal upward, so that "
                                     "the view follows it to the flange; both sides: side by side",
                                     parent);
  contact_spacing_ = make_float("Spacing", 0.2F, 0, 10,
                                "Distance between the contacts of both sides in the picture [m]", follow_contact_);
  line_width_ = make_float("Line Width", 0.002F, 1e-6F, 1, "Width of all lines [m]", parent);
  makePatchProperties(parent);
  makeTrackProperties(parent);
  makeTextProperties(parent);
}

void DisplayProperties::makePatchProperties(Property* parent)
{
  patches_ = new BoolProperty("Pressure", true, "Pressure of each patch as height and colour", parent);
  size_ = make_float("Size", 15, 1, 1000, "Magnification of a patch in its plane; 1: true size", patches_);
  height_ = make_float("Height", 0.1F, 0, 10, "Height of the upper end of the colour scale [m]", patches_);
  lift_ = make_float("Lift", 0.12F, 0, 10,
                     "Height of a magnified patch above its true position [m]; 0: at its true position", patches_);
  max_pressure_ = make_float("Scale", 0, 0, 1e6F,
                             "Upper end of the colour scale [MPa], pressures above it are magenta; 0: it follows the "
                             "pressures, doubled or halved",
                             patches_);
  stress_ =
      new BoolProperty("Stress", true,
                       "Von Mises stress in rail and wheel on a section beneath each patch, as large as the patch; "
                       "beside it if it is lifted, otherwise at the rear end of the rail; only for results "
                       "with a stress field",
                       parent);
  max_stress_ = make_float("Scale", 0, 0, 1e6F,
                           "Upper end of the colour scale [MPa], stresses above it are magenta; 0: it follows the "
                           "stresses, doubled or halved",
                           stress_);
  outlines_ = new BoolProperty("Outline", true, "Edge of each contact", parent);
  forces_ = new BoolProperty("Forces", true, "Normal force of the wheel on the rail, from each patch", parent);
  force_length_ = make_float("Length", 2.5F, 0, 1e6F, "Length of the arrows, also of the friction [mm/kN]", forces_);
  arrow_width_ = make_float("Width", 0.014F, 1e-6F, 1, "Diameter of the shafts of the arrows [m]", forces_);
  friction_ = new BoolProperty(
      "Friction", true,
      "Friction of the wheel on the rail, from each patch in its tangent plane; only with creep forces", parent);
}

void DisplayProperties::makeTrackProperties(Property* parent)
{
  wheels_ = new BoolProperty("Wheelset", true, "Wheels, swept from their profile, and the axle", parent);
  wheel_sweep_ = make_float("Sweep", 17, 0.1F, 180, "Half the drawn angle about the axle [degree]", wheels_);
  wheel_cut_ = new BoolProperty("Cut", false,
                                "Draw only the part ahead of the contact, with the section at the contact", wheels_);
  wheel_alpha_ = make_float("Alpha", 0.5F, 0, 1, "Opacity of the wheels", wheels_);
  rails_ = new BoolProperty("Rails", true, "Deflected rails, swept from their profile", parent);
  rail_length_ = make_float("Length", 0.4F, 0.001F, 100, "Drawn length of the rails [m]", rails_);
  rail_alpha_ = make_float("Alpha", 1, 0, 1, "Opacity of the rails", rails_);
  deflection_scale_ =
      make_float("Deflection Scale", 1, 0, 1e4F,
                 "Magnification of the deflection of the rails; given displacements are drawn in their true size, "
                 "patches and trail stay on the drawn rail, the wheels stay at their position",
                 rails_);
  rails_at_rest_ = new BoolProperty("Rails At Rest", true, "Section of the undeflected rails, as a line", parent);
  trail_ = new BoolProperty("Trail", true, "Earlier contact points on the rail, coloured by pressure", parent);
  trail_length_ = make_int("Points", 200, 1, 10000, "Number of points", trail_);
  trail_width_ = make_float("Width", 0.002F, 1e-6F, 1, "Diameter of the points [m]", trail_);
}

void DisplayProperties::makeTextProperties(Property* parent)
{
  labels_ = new BoolProperty("Labels", true,
                             "Highest pressure and area, above each patch; highest stress and depth, below its section",
                             parent);
  letter_height_ = make_float("Letters", 0.04F, 1e-4F, 1, "Height of the letters [m]", labels_);
  panel_ = new BoolProperty("Panel", true, "Colour scale, and the values of each patch", parent);
  panel_letters_ = make_int("Letters", 15, 4, 100, "Height of the letters [pixels]", panel_);
  panel_title_ = new rviz::StringProperty("Title", "", "First line of the panel; empty: none", panel_);
  panel_left_ = make_int("Left", 0, 0, 10000, "Left edge of the panel in the picture [pixels]", panel_);
  panel_top_ = make_int("Top", 0, 0, 10000, "Upper edge of the panel in the picture [pixels]", panel_);
}

void DisplayProperties::onChange(const std::function<void()>& changed)
{
  for (Property* property :
       std::initializer_list<Property*>{side_, follow_, follow_contact_, line_width_, patches_, stress_, outlines_,
                                        forces_, friction_, wheels_, rails_, rails_at_rest_, trail_, labels_, panel_})
  {
    connectBelow(property, changed);
  }
}

void DisplayProperties::onParametersChange(const std::function<void()>& changed)
{
  connectBelow(parameters_, changed);
}

std::vector<core::Side> DisplayProperties::sides() const
{
  const int side = side_->getOptionInt();
  return side == both_sides ? std::vector<core::Side>{core::Side::left, core::Side::right}
                            : std::vector<core::Side>{static_cast<core::Side>(side)};
}

PatchStyle DisplayProperties::patchStyle() const
{
  PatchStyle style;
  style.zoom = size_->getFloat();
  style.lift = lift_->getFloat();
  style.pressure_height = height_->getFloat();
  style.points = 64;
  style.force_scale = force_length_->getFloat() * 1e-6;
  style.arrow_width = arrow_width_->getFloat();
  style.letter_height = letter_height_->getFloat();
  style.line_width = line_width_->getFloat();
  return style;
}

TrackStyle DisplayProperties::trackStyle() const
{
  TrackStyle style;
  style.sides = sides();
  style.rail_length = rail_length_->getFloat();
  style.wheel_sweep = wheel_sweep_->getFloat() * core::degree;
  style.wheel_cut = wheel_cut_->getBool();
  style.wheel_alpha = wheel_alpha_->getFloat();
  style.rail_alpha = rail_alpha_->getFloat();
  style.profile_line_width = line_width_->getFloat();
  style.line_width = line_width_->getFloat();
  return style;
}

SceneOptions DisplayProperties::options() const
{
  SceneOptions options;
  options.patch = patchStyle();
  options.track = trackStyle();
  options.patches = patches_->getBool();
  options.stress = stress_->getBool();
  options.outlines = outlines_->getBool();
  options.forces = forces_->getBool();
  options.friction = friction_->getBool();
  options.labels = labels_->getBool();
  options.wheels = wheels_->getBool();
  options.rails = rails_->getBool();
  options.rails_at_rest = rails_at_rest_->getBool();
  options.deflection_scale = deflection_scale_->getFloat();
  options.trail_width = trail_width_->getFloat();
  options.drawn_x = follow_->getBool() ? std::optional<double>(place_->getFloat()) : std::nullopt;
  return options;
}

double DisplayProperties::scale() const
{
  return max_pressure_->getFloat() * 1e6;
}

double DisplayProperties::stressScale() const
{
  return max_stress_->getFloat() * 1e6;
}

std::optional<double> DisplayProperties::contactSpacing() const
{
  return follow_contact_->getBool() ? std::optional<double>(contact_spacing_->getFloat()) : std::nullopt;
}

std::size_t DisplayProperties::trailLength() const
{
  return trail_->getBool() ? static_cast<std::size_t>(trail_length_->getInt()) : 0;
}

int DisplayProperties::panelLetters() const
{
  return panel_->getBool() ? panel_letters_->getInt() : 0;
}

std::string DisplayProperties::panelTitle() const
{
  return panel_title_->getStdString();
}

QPoint DisplayProperties::panelCorner() const
{
  return {panel_left_->getInt(), panel_top_->getInt()};
}

std::string DisplayProperties::parameters() const
{
  return parameters_->getStdString();
}
}  // namespace wheel_rail_contact
