// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/stress_section.h"

#include "config/text.h"
#include "ros/markers/marker_tools.h"

namespace wheel_rail_contact
{
using Eigen::Vector3d;
using visualization_msgs::Marker;

namespace
{
constexpr double lines_lift = 2e-4;  ///< of lines behind the section (-x), so that it does not hide them [m]
constexpr double cross_size = 6;     ///< length of the lines of a cross / their width, unless the section is small [-]
constexpr double label_distance = 1.8;  ///< between a section and the middle of its text / height of the letters [-]

/// A body beneath a patch.
struct Body
{
  const core::PatchStress& stress;
  const char* name;
  double up;  ///< z of the patch frame per depth [-]
};

std::array<Body, 2> bodiesOf(const core::PatchResult& patch)
{
  return {Body{patch.rail_stress, "rail", -1}, Body{patch.wheel_stress, "wheel", 1}};
}

bool hasField(const core::PatchStress& stress)
{
  return !stress.field.empty() && stress.field.front().components.front().size() > 0;
}

/// Row of the cells nearest to the highest von Mises stress; the first one if a number of the message is not finite.
int rowOf(const core::PatchResult& patch)
{
  const core::StressPeak &rail = patch.rail_stress.von_mises, &wheel = patch.wheel_stress.von_mises;
  const double x = wheel.value > rail.value ? wheel.x : rail.x;
  int nearest = 0;
  for (int row = 1; row < patch.grid.nx; ++row)
  {
    if (std::abs(patch.grid.x(row) - x) < std::abs(patch.grid.x(nearest) - x))
    {
      nearest = row;
    }
  }
  return nearest;
}

double middleOf(const core::PatchGrid& grid)
{
  return 0.5 * (grid.y(0) + grid.y(grid.ny - 1));
}

/// Distance by which sections are beside the magnified patches of a side: the width of all of them, and a space [m].
double widthOf(const std::vector<PatchPicture>& pictures, const PatchStyle& patch)
{
  double left = -HUGE_VAL, right = HUGE_VAL;
  for (const PatchPicture& picture : pictures)
  {
    const double half = 0.5 * patch.zoom * picture.patch->grid.ny * picture.patch->grid.dy;
    left = std::max(left, picture.zoom_place.y() + half);
    right = std::min(right, picture.zoom_place.y() - half);
  }
  return left - right + patch.letter_height;
}

/// Section of a patch.
struct Section
{
  const core::PatchResult& patch;
  int id;
  double zoom;                 ///< magnification [-]
  Eigen::Isometry3d to_track;  ///< transform from the patch frame, with magnified lengths, to the track frame
};

/// Sections of the patches that have a field.
std::vector<Section> arrange(const std::vector<PatchPicture>& pictures, const PatchStyle& patch, double rear)
{
  std::vector<Section> sections;
  for (const PatchPicture& picture : pictures)
  {
    Vector3d place = picture.zoom_place;
    if (patch.lift > 0)
    {
      place.y() -= core::sideSign(picture.patch->side) * widthOf(pictures, patch);
    }
    else
    {
      // One behind another: in true size they may overlap.
      place.x() = rear - static_cast<double>(1 + sections.size()) * patch.line_width;
    }
    if (hasField(picture.patch->rail_stress) || hasField(picture.patch->wheel_stress))
    {
      sections.push_back({*picture.patch, picture.id, patch.zoom,
                          Eigen::Translation3d(place) * Eigen::Isometry3d(picture.zoom_turn) *
                              Eigen::Translation3d(0, -patch.zoom * middleOf(picture.patch->grid), 0)});
    }
  }
  return sections;
}

/// Layer of a section: a row of points with their colours.
struct DrawnLayer
{
  std::vector<Vector3d> points;  ///< track frame [m]
  std::vector<std_msgs::ColorRGBA> colors;
};

DrawnLayer drawnLayer(const core::StressLayer& layer, double up, const Section& section, double max_stress)
{
  const core::PatchGrid& grid = section.patch.grid;
  const int row = rowOf(section.patch);
  DrawnLayer drawn;
  for (int j = 0; j < grid.ny; ++j)
  {
    drawn.points.push_back(section.to_track * (section.zoom * Vector3d(0, grid.y(j), up * layer.depth)));
    drawn.colors.push_back(pressureColor(vonMises(layer.at(row, j)), max_stress));
  }
  return drawn;
}

void addBody(const Body& body, const Section& section, double max_stress, Marker& marker)
{
  DrawnLayer a = drawnLayer(body.stress.field.front(), body.up, section, max_stress);
  for (std::size_t k = 1; k < body.stress.field.size(); ++k)
  {
    DrawnLayer b = drawnLayer(body.stress.field[k], body.up, section, max_stress);
    for (std::size_t j = 0; j + 1 < a.points.size(); ++j)
    {
      addQuadrilateral({a.points[j], a.points[j + 1], b.points[j + 1], b.points[j]},
                       {a.colors[j], a.colors[j + 1], b.colors[j + 1], b.colors[j]}, marker);
    }
    a = std::move(b);
  }
}

Marker sectionMarker(const Section& section, double max_stress)
{
  Marker marker = makeMarker("stress", section.id, Marker::TRIANGLE_LIST, makeColor(1, 1, 1));
  for (const Body& body : bodiesOf(section.patch))
  {
    if (hasField(body.stress))
    {
      addBody(body, section, max_stress, marker);
    }
  }
  return marker;
}

Marker linesMarker(const Section& section, double line_width)
{
  Marker marker = makeMarker("stress_lines", section.id, Marker::LINE_LIST, scene_colors::text);
  marker.scale.x = line_width;
  const auto add = [&](const Vector3d& from, const Vector3d& to)
  {
    for (const Vector3d& point : {from, to})
    {
      marker.points.push_back(toPoint(section.to_track * point - lines_lift * Vector3d::UnitX()));
    }
  };
  const core::PatchGrid& grid = section.patch.grid;
  add(section.zoom * Vector3d(0, grid.y(0), 0), section.zoom * Vector3d(0, grid.y(grid.ny - 1), 0));
  for (const Body& body : bodiesOf(section.patch))
  {
    const core::StressPeak& peak = body.stress.von_mises;
    const Vector3d place = section.zoom * Vector3d(0, peak.y, body.up * peak.depth);
    for (const Vector3d& direction : {Vector3d(Vector3d::UnitY()), Vector3d(Vector3d::UnitZ())})
    {
      const Vector3d half = 0.5 * std::min(cross_size * line_width, section.zoom * peak.depth) * direction;
      add(place - half, place + half);
    }
  }
  return marker;
}

/// Highest stress of a body, beyond the deep end of its section.
Marker labelMarker(const Body& body, const Section& section, double letter_height)
{
  const double deepest = body.stress.field.back().depth;
  const Vector3d end = section.to_track * (section.zoom * Vector3d(0, middleOf(section.patch.grid), body.up * deepest));
  // In front of the sections, seen along the track: the next one may be wider than the space between them.
  const Vector3d shift(-0.5 * letter_height, 0, label_distance * letter_height * body.up);
  const core::StressPeak& peak = body.stress.von_mises;
  return makeText("stress_label", 2 * section.id + (body.up > 0 ? 1 : 0), end + shift, letter_height,
                  formatted("%s %.0f MPa\n%.1f mm deep", body.name, peak.value / 1e6, 1e3 * peak.depth),
                  scene_colors::text);
}

double highestOf(const core::PatchStress& stress, int row)
{
  double highest = stress.von_mises.value;
  for (const core::StressLayer& layer : stress.field)
  {
    for (Eigen::Index column = 0; column < layer.components.front().cols(); ++column)
    {
      highest = std::max(highest, vonMises(layer.at(row, column)));
    }
  }
  return highest;
}
}  // namespace

void addStressSections(const std::vector<PatchPicture>& pictures, const PatchStyle& patch, const StressStyle& style,
                       visualization_msgs::MarkerArray& markers)
{
  for (const Section& section : arrange(pictures, patch, style.rear))
  {
    markers.markers.push_back(sectionMarker(section, style.max_stress));
    markers.markers.push_back(linesMarker(section, patch.line_width));
    for (const Body& body : bodiesOf(section.patch))
    {
      if (style.labels && hasField(body.stress))
      {
        markers.markers.push_back(labelMarker(body, section, patch.letter_height));
      }
    }
  }
}

double highestStress(const ContactOutput& output, const std::vector<core::Side>& sides)
{
  const auto highest = [](const core::PatchResult& patch)
  {
    const bool has_field = hasField(patch.rail_stress) || hasField(patch.wheel_stress);
    const int row = has_field ? rowOf(patch) : 0;
    return has_field ? std::max(highestOf(patch.rail_stress, row), highestOf(patch.wheel_stress, row)) : 0;
  };
  return highestOf(output, sides, highest);
}
}  // namespace wheel_rail_contact
