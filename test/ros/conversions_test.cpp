// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/conversions.h"

#include <Eigen/Geometry>

#include "../result_numbers.h"
#include "../usual_headers.h"

using namespace wheel_rail_contact;

namespace
{
core::PatchResult examplePatch(core::Side side)
{
  core::PatchResult patch;
  patch.side = side;
  patch.method = "seidel";
  patch.pose = {0.01, side == core::Side::left ? 0.75 : -0.75, -0.001, side == core::Side::left ? 0.03 : -0.03};
  patch.contact_angle = 0.03;
  patch.normal_force = 100e3;
  patch.approach = 8e-5;
  patch.area = 190e-6;
  patch.max_pressure = 980e6;
  patch.error_estimate = 0.004;
  patch.iterations = 17;
  patch.residual = 1e-7;
  patch.half_space_ratio = 0.07;
  patch.model_error = 0.013;
  patch.vertical_force = 99e3;
  patch.lateral_force = 3e3;
  patch.semi_axis_along = 6e-3;
  patch.semi_axis_across = 4e-3;
  patch.rolling_radius = 0.461;
  patch.wheel_s = -0.012;
  patch.wheel_angle = 0.002;
  patch.rail_s = -0.013;
  patch.slope_along = 0.007;
  patch.pose.pitch = -0.007;
  patch.curvature_along = 2.17;
  patch.curvature_across = 6.4;
  patch.normal_stiffness = 1.1e9;
  patch.wheel_stress.von_mises = {600e6, 1e-4, -2e-4, 3e-3};
  patch.wheel_stress.load_factor = 3.1;
  patch.rail_stress.shear = {310e6, -1e-4, 2e-4, 3.2e-3};
  patch.rail_stress.shakedown_limit = 4.7;
  patch.grid.nx = 4;
  patch.grid.ny = 3;
  patch.grid.dx = 0.002;
  patch.grid.dy = 0.001;
  patch.grid.x0 = -0.003;
  patch.grid.y0 = -0.0015;
  const Eigen::ArrayXd values = Eigen::ArrayXd::LinSpaced(12, 1e6, 12e6);
  patch.pressure = Eigen::Map<const Eigen::ArrayXXd>(values.data(), 4, 3);
  for (const double depth : {0.0, 1e-3})
  {
    core::StressLayer& layer = patch.rail_stress.field.emplace_back();
    layer.depth = depth;
    layer.components.fill((1 + depth) * patch.pressure);
    layer.components[4] *= -0.1;
  }
  return patch;
}

core::WheelsetResult exampleResult()
{
  core::WheelsetResult result;
  result.status = core::ContactStatus::lift_off;
  result.reason = "the right wheel carries no load";
  result.y = -0.002;
  result.z = 0.4597;
  result.yaw = 0.02;
  result.roll = -0.001;
  result.rail.left = {{1e-3, -2e-4, 3e-3}, {4e-4, 5e-5, -6e-4}, 3.5e3, 1e5, -200, {1e-3, 2e-3, 3e-3}};
  result.rail.right = {{-1e-3, 2e-4, -3e-3}, {-7e-4, 8e-5, 9e-4}, -3.5e3, 0, 30, {-1e-3, 5e-3, 0}};
  result.wheel = {core::WheelForces{1e5, 3.5e3}, core::WheelForces{4e4, -2e3}};
  result.rail_wrench = {{0, -1.5e3, 1.4e5}, {4e4, 20, -30}};
  result.implausible_force = true;
  result.derivatives.forces.setRandom(6, 10);
  result.derivatives.solution.setRandom(6, 8);
  result.patches = {examplePatch(core::Side::left), examplePatch(core::Side::right)};
  return result;
}

/// Numbers of a result, with their names.
std::vector<std::pair<std::string, double>> numbersOf(const core::WheelsetResult& result)
{
  std::vector<std::pair<std::string, double>> numbers;
  visitNumbers(result, [&](const char* name, double value) { numbers.emplace_back(name, value); });
  return numbers;
}
}  // namespace

TEST(Conversions, ConversionToAMessageAndBackPreservesTheResult)
{
  const core::WheelsetResult before = exampleResult();
  const core::WheelsetResult after = fromMessage(toMessage(before, 12.5, true));
  EXPECT_EQ(after.reason, before.reason);
  ASSERT_EQ(after.patches.size(), 2U);
  EXPECT_EQ(after.patches[1].method, before.patches[1].method);
  EXPECT_EQ(after.patches[1].pressure.rows(), before.patches[1].pressure.rows());
  const auto found = numbersOf(after), expected = numbersOf(before);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k)
  {
    const auto& [name, value] = expected[k];
    const bool is_float = name == "pressure" || name == "stress";
    const double rounding = is_float         ? std::numeric_limits<float>::epsilon() * std::abs(value)
                            : name == "pose" ? 1e-14
                                             : 0;
    EXPECT_EQ(found[k].first, name);
    EXPECT_NEAR(found[k].second, value, rounding) << name;
  }
}

TEST(Conversions, PlaceIsAddedToEveryPoseAndTheGridCanBeLeftOut)
{
  const WheelsetContact message = toMessage(exampleResult(), 100, false);
  EXPECT_EQ(message.wheelset.position.x, 100);
  EXPECT_NEAR(message.patches[0].pose.position.x, 100.01, 1e-12);
  EXPECT_EQ(message.patches[0].grid.nx, 0U);
  EXPECT_TRUE(message.patches[0].grid.pressure.empty());
  EXPECT_EQ(message.patches[0].max_pressure, 980e6);
  EXPECT_NO_THROW(fromMessage(message));
}

TEST(Conversions, PressureIsStoredWithXAsTheFastestIndex)
{
  const core::PatchResult patch = examplePatch(core::Side::left);
  const PressureGrid message = toMessage(patch.grid, patch.pressure);
  EXPECT_EQ(message.nx, 4U);
  EXPECT_EQ(message.ny, 3U);
  EXPECT_DOUBLE_EQ(message.x0, -0.003);
  EXPECT_DOUBLE_EQ(message.y0, -0.0015);
  for (std::size_t iy = 0; iy < 3; ++iy)
  {
    for (std::size_t ix = 0; ix < 4; ++ix)
    {
      EXPECT_EQ(message.pressure[iy * 4 + ix],
                static_cast<float>(patch.pressure(static_cast<int>(ix), static_cast<int>(iy))));
    }
  }
}

TEST(Conversions, PatchNormalIsTheThirdAxisOfItsPose)
{
  const auto pose = toMessage(core::PatchPose{0, 0.75, 0, 0.1}, 0);
  const Eigen::Quaterniond q(pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z);
  EXPECT_TRUE((q * Eigen::Vector3d::UnitZ()).isApprox(Eigen::Vector3d(0, -std::sin(0.1), std::cos(0.1)), 1e-15));
}

TEST(Conversions, GridsAndStressFieldsOfTheWrongSizeAreRefused)
{
  const core::PatchResult patch = examplePatch(core::Side::left);
  EXPECT_THROW(toMessage(patch.grid, Eigen::ArrayXXd::Zero(3, 4)), std::invalid_argument);

  const ContactPatch good = toMessage(examplePatch(core::Side::left), 0, true);
  core::PatchGrid grid;
  Eigen::ArrayXXd pressure;
  PressureGrid bad = good.grid;
  bad.pressure.pop_back();
  EXPECT_THROW(fromMessage(bad, grid, pressure), std::invalid_argument);
  bad = good.grid;
  bad.nx = bad.ny = 1U << 16U;  // the product overflows to 0 in 32 bits
  bad.pressure.clear();
  EXPECT_THROW(fromMessage(bad, grid, pressure), std::invalid_argument);
  ContactPatch short_field = good;
  short_field.rail_stress.stress.pop_back();
  EXPECT_THROW(fromMessage(short_field, 0), std::invalid_argument);
}

TEST(Conversions, StressFieldIsStoredInTheDocumentedOrder)
{
  const core::PatchResult patch = examplePatch(core::Side::left);
  const PatchStress message = toMessage(patch, 0, true).rail_stress;
  ASSERT_EQ(message.stress.size(), 2U * 6U * 12U);
  EXPECT_EQ(message.stress[((1 * 6 + 4) * 3 + 2) * 4 + 1],
            static_cast<float>(patch.rail_stress.field[1].components[4](1, 2)));
  EXPECT_TRUE(toMessage(patch, 0, false).rail_stress.stress.empty());
}

TEST(Conversions, DerivativesAreStoredRowByRow)
{
  core::WheelsetResult result;
  EXPECT_TRUE(toMessage(result, 0, true).derivatives.forces.empty());
  result.derivatives.forces.setRandom(6, 4);
  WheelsetContact message = toMessage(result, 0, false);
  ASSERT_EQ(message.derivatives.forces.size(), 24U);
  EXPECT_TRUE(message.derivatives.solution.empty());
  EXPECT_EQ(message.derivatives.forces[1 * 4 + 3], result.derivatives.forces(1, 3));
  message.derivatives.forces.pop_back();
  EXPECT_THROW(fromMessage(message), std::invalid_argument);
  message.derivatives.forces.resize(66);
  EXPECT_THROW(fromMessage(message), std::invalid_argument);
}

TEST(Conversions, UnknownConstantsAreRefused)
{
  ContactPatch patch = toMessage(examplePatch(core::Side::right), 0, true);
  patch.side = 7;
  EXPECT_THROW(fromMessage(patch, 0), std::invalid_argument);
  patch = toMessage(examplePatch(core::Side::right), 0, true);
  patch.method = "magic";
  EXPECT_THROW(fromMessage(patch, 0), std::invalid_argument);
  EXPECT_THROW(statusFromMessage(200), std::invalid_argument);
  EXPECT_EQ(statusFromMessage(WheelsetContact::NO_TRANSFORM), core::ContactStatus::invalid_input);
}

TEST(Conversions, EveryStatusHasItsConstant)
{
  EXPECT_EQ(toMessage(core::ContactStatus::ok), WheelsetContact::OK);
  EXPECT_EQ(toMessage(core::ContactStatus::lift_off), WheelsetContact::LIFT_OFF);
  EXPECT_EQ(toMessage(core::ContactStatus::off_profile), WheelsetContact::OFF_PROFILE);
  EXPECT_EQ(toMessage(core::ContactStatus::not_converged), WheelsetContact::NOT_CONVERGED);
  EXPECT_EQ(toMessage(core::ContactStatus::invalid_input), WheelsetContact::INVALID_INPUT);
  EXPECT_EQ(toMessage(core::ContactStatus::outside_line), WheelsetContact::OUTSIDE_LINE);
  EXPECT_EQ(toMessage(core::ContactStatus::too_deep), WheelsetContact::TOO_DEEP);
  EXPECT_STREQ(nameOf(core::ContactStatus::too_deep), "TOO_DEEP");
}
