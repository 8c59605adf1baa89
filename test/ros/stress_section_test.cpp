// SPDX-License-Identifier: BSD-3-Clause
#include "ros/markers/stress_section.h"

#include "result_scene.h"
#include "ros/markers/contact_scene.h"
#include "ros/markers/marker_tools.h"

using namespace wheel_rail_contact;
namespace
{
constexpr double deepest = 6e-3;                     // [m]
constexpr int rail_row = 12, wheel_row = 4;          // of the highest stresses
constexpr double rail_peak = 6e8, wheel_peak = 5e8;  // [Pa]

/// Field of a single compressive stress along the depth, whose von Mises stress is its amount: `highest` at the middle
/// depth in one row, and nothing elsewhere.
std::vector<core::StressLayer> makeField(const core::PatchGrid& grid, int row, double highest)
{
  std::vector<core::StressLayer> field(3);
  for (std::size_t k = 0; k < field.size(); ++k)
  {
    field[k].depth = 0.5 * static_cast<double>(k) * deepest;
    for (Eigen::ArrayXXd& component : field[k].components)
    {
      component = Eigen::ArrayXXd::Zero(grid.nx, grid.ny);
    }
  }
  field[1].components[2].row(row) = -highest;
  return field;
}

class StressSection : public ResultScene
{
 protected:
  StressSection()
  {
    addStress(result.patches[0]);
    result.patches[0].pose.angle = 0;
    options.patch.lift = 0;
    options.patch.zoom = 1;
  }

  static void addStress(core::PatchResult& patch)
  {
    const core::PatchGrid& grid = patch.grid;
    // The places are a third of a cell beside the centres of the row.
    patch.rail_stress.von_mises = {rail_peak, grid.x(rail_row) + grid.dx / 3, 1e-3, 0.5 * deepest};
    patch.wheel_stress.von_mises = {wheel_peak, grid.x(wheel_row) - grid.dx / 3, 0, 0.25 * deepest};
    patch.rail_stress.field = makeField(grid, rail_row, rail_peak);
    patch.wheel_stress.field = makeField(grid, wheel_row, wheel_peak);
  }

  MarkerArray draw() const { return sceneMarkers(output, &config.model, ContactTrail(), options); }
  Marker section() const { return findMarker(draw(), "stress", 0); }
  double highest() const { return highestStress(output, {core::Side::left, core::Side::right}); }

  SceneOptions options;
};

bool hasStressMarker(const MarkerArray& markers)
{
  return std::any_of(markers.markers.begin(), markers.markers.end(),
                     [](const Marker& marker) { return marker.ns.find("stress") == 0; });
}

/// Largest deviation of the colour of the points at a height from the colour of a stress.
double deviation(const Marker& marker, double z, double share)
{
  const std_msgs::ColorRGBA expected = colorOf(share);
  double largest = -1;
  for (std::size_t i = 0; i < marker.points.size(); ++i)
  {
    if (std::abs(marker.points[i].z - z) < 1e-9)
    {
      const std_msgs::ColorRGBA& color = marker.colors.at(i);
      largest = std::max({largest, std::abs(static_cast<double>(color.r - expected.r)),
                          std::abs(static_cast<double>(color.g - expected.g)),
                          std::abs(static_cast<double>(color.b - expected.b))});
    }
  }
  return largest < 0 ? INFINITY : largest;
}
}  // namespace

TEST_F(StressSection, ResultWithoutFieldHasNone)
{
  result.patches[0].rail_stress.field.clear();
  result.patches[0].wheel_stress.field.clear();
  options.scale = true;
  EXPECT_FALSE(hasStressMarker(draw()));
  EXPECT_EQ(highest(), 0);
  output.result = nullptr;
  EXPECT_FALSE(hasStressMarker(draw()));
  EXPECT_EQ(highest(), 0);
}

TEST_F(StressSection, FieldWithoutCellsHasNone)
{
  for (core::PatchStress* stress : {&result.patches[0].rail_stress, &result.patches[0].wheel_stress})
  {
    stress->field = makeField(core::PatchGrid(), 0, 0);
  }
  EXPECT_FALSE(hasStressMarker(draw()));
}

TEST_F(StressSection, RailIsBelowTheSurfaceAndTheWheelAboveItAtTheEndOfTheRail)
{
  options.patch.zoom = 3;
  const Marker marker = section();
  const core::PatchResult& patch = result.patches[0];
  const auto [lowest, top] = range(marker, &geometry_msgs::Point::z);
  EXPECT_NEAR(lowest, patch.pose.z - 3 * deepest, 1e-12);
  EXPECT_NEAR(top, patch.pose.z + 3 * deepest, 1e-12);
  const auto [right, left] = range(marker, &geometry_msgs::Point::y);
  EXPECT_NEAR(left - right, 3 * (patch.grid.ny - 1) * patch.grid.dy, 1e-12);
  EXPECT_NEAR(0.5 * (left + right), patch.pose.y, 1e-12) << "the grid is symmetric about the origin of the patch";
  const auto [rear, front] = range(marker, &geometry_msgs::Point::x);
  EXPECT_NEAR(front - rear, 0, 1e-12) << "a plane across the track";
  EXPECT_NEAR(front, output.x() - 0.5 * options.track.rail_length, 2 * options.patch.line_width);
}

TEST_F(StressSection, RowIsThatOfTheHigherStressInBothBodies)
{
  const double surface = result.patches[0].pose.z, middle = 0.5 * deepest;
  EXPECT_LT(deviation(section(), surface - middle, rail_peak / options.max_stress), 1e-6);
  EXPECT_LT(deviation(section(), surface + middle, 0), 1e-6) << "the stress of the wheel is in another row";
  EXPECT_LT(deviation(section(), surface, 0), 1e-6);
  EXPECT_EQ(highest(), rail_peak);

  result.patches[0].wheel_stress.von_mises.value = 7e8;
  EXPECT_LT(deviation(section(), surface + middle, wheel_peak / options.max_stress), 1e-6);
  EXPECT_LT(deviation(section(), surface - middle, 0), 1e-6);
  EXPECT_EQ(highest(), 7e8);
}

TEST_F(StressSection, PeakBeyondTheGridOrWithoutAFinitePlaceGivesTheFirstRow)
{
  result.patches[0].rail_stress.field = makeField(result.patches[0].grid, 0, rail_peak);
  for (const double x : {-1.0, std::numeric_limits<double>::quiet_NaN()})
  {
    result.patches[0].rail_stress.von_mises.x = x;
    EXPECT_LT(deviation(section(), result.patches[0].pose.z - 0.5 * deepest, rail_peak / options.max_stress), 1e-6);
  }
}

TEST_F(StressSection, StressAboveTheScaleHasItsOwnColour)
{
  options.max_stress = 0.9 * rail_peak;
  const Marker marker = section();
  const std_msgs::ColorRGBA above = scene_colors::above_scale;
  for (std::size_t i = 0; i < marker.points.size(); ++i)
  {
    const double depth = (result.patches[0].pose.z - marker.points[i].z) / options.patch.zoom;
    EXPECT_EQ(marker.colors[i].g == above.g, std::abs(depth - 0.5 * deepest) < 1e-9) << depth;
  }
}

TEST_F(StressSection, LiesAlongTheNormalOfAPatchThatIsNotLifted)
{
  core::PatchPose& pose = result.patches[0].pose;
  pose.angle = 1.2;
  const Marker marker = section();
  const double high = result.patches[0].grid.y(result.patches[0].grid.ny - 1);
  // The grid is symmetric: the highest point of the wheel's part is at the end of a column at the upper edge.
  EXPECT_NEAR(range(marker, &geometry_msgs::Point::z).second,
              pose.z + high * std::sin(pose.angle) + deepest * std::cos(pose.angle), 1e-12);
  EXPECT_NEAR(range(marker, &geometry_msgs::Point::y).first,
              pose.y - high * std::cos(pose.angle) - deepest * std::sin(pose.angle), 1e-12);
}

TEST_F(StressSection, IsBesideTheMagnifiedPatchesTowardsTheTrackCentreIfTheyAreLifted)
{
  options.patch.lift = 0.1;
  options.patch.zoom = 15;
  result.patches.push_back(makePatch(core::Side::left, 0.74));
  for (core::PatchResult& patch : result.patches)
  {
    addStress(patch);
  }
  const MarkerArray markers = draw();
  const auto across = [&](const char* ns, int id)
  { return range(findMarker(markers, ns, id), &geometry_msgs::Point::y); };
  EXPECT_LT(across("stress", 1).second, across("stress", 0).first) << "sections of one wheel do not overlap";
  EXPECT_LT(across("stress", 0).second, across("zoom", 1).first);
  EXPECT_GT(across("stress", 16).first, across("zoom", 16).second) << "to the left on the right rail";
  const auto along = range(findMarker(markers, "stress", 0), &geometry_msgs::Point::x);
  EXPECT_NEAR(along.first, output.x(), 1e-12);
  EXPECT_NEAR(along.second, output.x(), 1e-12);
  EXPECT_NEAR(range(findMarker(markers, "stress", 0), &geometry_msgs::Point::z).second,
              result.patches[0].pose.z + options.patch.lift + 15 * deepest, 1e-12)
      << "the surface is at the height of the magnified patch";
}

TEST_F(StressSection, CrossesAreAtTheHighestStresses)
{
  options.patch.zoom = 2;
  const Marker lines = findMarker(draw(), "stress_lines", 0);
  const core::PatchPose& pose = result.patches[0].pose;
  ASSERT_EQ(lines.points.size(), 10U) << "the surface, and two lines for each body";
  const auto expectMiddle = [&](std::size_t first, double y, double z)
  {
    EXPECT_NEAR(0.5 * (lines.points[first].y + lines.points[first + 1].y), pose.y + y, 1e-12);
    EXPECT_NEAR(0.5 * (lines.points[first].z + lines.points[first + 1].z), pose.z + z, 1e-12);
  };
  expectMiddle(0, 0, 0);
  for (const std::size_t line : {0U, 2U})
  {
    expectMiddle(2 + line, 2e-3, -2 * 0.5 * deepest);
    expectMiddle(6 + line, 0, 2 * 0.25 * deepest);
  }
}

TEST_F(StressSection, TextGivesTheHighestStressesAndTheirDepths)
{
  const MarkerArray markers = draw();
  const Marker &rail = findMarker(markers, "stress_label", 0), &wheel = findMarker(markers, "stress_label", 1);
  EXPECT_EQ(rail.text, "rail 600 MPa\n3.0 mm deep");
  EXPECT_EQ(wheel.text, "wheel 500 MPa\n1.5 mm deep");
  EXPECT_LT(rail.pose.position.z, result.patches[0].pose.z - deepest) << "below the section of the rail";
  EXPECT_GT(wheel.pose.position.z, result.patches[0].pose.z + deepest) << "above that of the wheel";
  options.labels = false;
  EXPECT_THROW(findMarker(draw(), "stress_label", 0), std::out_of_range);
  EXPECT_NO_THROW(section());
}

TEST_F(StressSection, HasAColourScaleOfItsOwn)
{
  options.scale = true;
  EXPECT_EQ(findMarker(draw(), "stress_scale", 5).text, "1000 MPa");
  EXPECT_EQ(findMarker(draw(), "stress_scale", 7).text, "von Mises stress");
  EXPECT_EQ(findMarker(draw(), "scale", 7).text, "pressure");
  EXPECT_THROW(findMarker(draw(), "stress_scale", 6), std::out_of_range) << "nothing is above the scale";
  options.max_stress = 0.9 * rail_peak;
  EXPECT_EQ(findMarker(draw(), "stress_scale", 6).text, "above scale: 600 MPa");
  const auto [stress_right, stress_left] = range(findMarker(draw(), "stress_scale", 0), &geometry_msgs::Point::y);
  EXPECT_GT(stress_right, range(findMarker(draw(), "scale", 0), &geometry_msgs::Point::y).second);
  EXPECT_GT(stress_left, stress_right);
}

TEST_F(StressSection, CanBeSwitchedOff)
{
  options.scale = true;
  options.stress = false;
  EXPECT_FALSE(hasStressMarker(draw()));
  options.stress = true;
  options.patch.zoom = 0;
  EXPECT_FALSE(hasStressMarker(draw())) << "the section has the magnification of the patch";
}

TEST_F(StressSection, FieldIsNotCopiedForAPictureInTrueSize)
{
  EXPECT_EQ(drawnResult(output, &config.model, 1).get(), &result);
  EXPECT_NE(drawnResult(output, &config.model, 10).get(), &result);
}
