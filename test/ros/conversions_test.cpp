// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/conversions.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>

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
  result.patches = {examplePatch(core::Side::left), examplePatch(core::Side::right)};
  return result;
}

void expectEqual(const core::RailDeflection& a, const core::RailDeflection& b)
{
  EXPECT_EQ(a.lateral, b.lateral);
  EXPECT_EQ(a.vertical, b.vertical);
  EXPECT_EQ(a.roll, b.roll);
}

void expectEqual(const core::PatchResult& a, const core::PatchResult& b)
{
  using Patch = core::PatchResult;
  EXPECT_EQ(a.side, b.side);
  EXPECT_EQ(a.method, b.method);
  EXPECT_NEAR(a.pose.x, b.pose.x, 1e-14);
  EXPECT_EQ(a.pose.y, b.pose.y);
  EXPECT_EQ(a.pose.z, b.pose.z);
  EXPECT_NEAR(a.pose.angle, b.pose.angle, 1e-15);
  EXPECT_NEAR(a.pose.pitch, b.pose.pitch, 1e-15);
  EXPECT_EQ(a.iterations, b.iterations);
  for (const auto number :
       {&Patch::contact_angle,    &Patch::normal_force,   &Patch::approach,        &Patch::area,
        &Patch::max_pressure,     &Patch::error_estimate, &Patch::residual,        &Patch::half_space_ratio,
        &Patch::model_error,      &Patch::vertical_force, &Patch::lateral_force,   &Patch::semi_axis_along,
        &Patch::semi_axis_across, &Patch::rolling_radius, &Patch::wheel_s,         &Patch::wheel_angle,
        &Patch::rail_s,           &Patch::slope_along,    &Patch::curvature_along, &Patch::curvature_across,
        &Patch::normal_stiffness})
  {
    EXPECT_EQ(a.*number, b.*number);
  }
  EXPECT_EQ(a.grid.nx, b.grid.nx);
  EXPECT_EQ(a.grid.ny, b.grid.ny);
  EXPECT_EQ(a.grid.dx, b.grid.dx);
  EXPECT_EQ(a.grid.dy, b.grid.dy);
  EXPECT_EQ(a.grid.y0, b.grid.y0);
  EXPECT_EQ(a.wheel_stress.von_mises.value, b.wheel_stress.von_mises.value);
  EXPECT_EQ(a.wheel_stress.von_mises.y, b.wheel_stress.von_mises.y);
  EXPECT_EQ(a.wheel_stress.load_factor, b.wheel_stress.load_factor);
  EXPECT_EQ(a.rail_stress.shear.x, b.rail_stress.shear.x);
  EXPECT_EQ(a.rail_stress.shear.depth, b.rail_stress.shear.depth);
  EXPECT_EQ(a.rail_stress.shakedown_limit, b.rail_stress.shakedown_limit);
  ASSERT_EQ(a.rail_stress.field.size(), b.rail_stress.field.size());
  for (std::size_t k = 0; k < a.rail_stress.field.size(); ++k)
  {
    EXPECT_EQ(a.rail_stress.field[k].depth, b.rail_stress.field[k].depth);
    for (std::size_t c = 0; c < 6; ++c)
    {
      EXPECT_TRUE(a.rail_stress.field[k].components[c].isApprox(b.rail_stress.field[k].components[c],
                                                                std::numeric_limits<float>::epsilon()));
    }
  }
  EXPECT_TRUE(a.pressure.isApprox(b.pressure, std::numeric_limits<float>::epsilon()));
}
}  // namespace

TEST(Conversions, ConversionToAMessageAndBackPreservesTheResult)
{
  const core::WheelsetResult before = exampleResult();
  const core::WheelsetResult after = fromMessage(toMessage(before, 12.5, true));
  EXPECT_EQ(after.status, before.status);
  EXPECT_EQ(after.reason, before.reason);
  EXPECT_EQ(after.y, before.y);
  EXPECT_EQ(after.z, before.z);
  EXPECT_NEAR(after.yaw, before.yaw, 1e-15);
  EXPECT_NEAR(after.roll, before.roll, 1e-15);
  for (const core::Side side : core::sides)
  {
    expectEqual(after.rail[side].deflection, before.rail[side].deflection);
    expectEqual(after.rail[side].given, before.rail[side].given);
    EXPECT_EQ(after.rail[side].lateral_force, before.rail[side].lateral_force);
    EXPECT_EQ(after.rail[side].vertical_force, before.rail[side].vertical_force);
    EXPECT_EQ(after.rail[side].moment, before.rail[side].moment);
    EXPECT_EQ(after.wheel[side].vertical, before.wheel[side].vertical);
    EXPECT_EQ(after.wheel[side].lateral, before.wheel[side].lateral);
  }
  EXPECT_EQ(after.rail_wrench.force, before.rail_wrench.force);
  EXPECT_EQ(after.rail_wrench.moment, before.rail_wrench.moment);
  EXPECT_EQ(after.implausible_force, before.implausible_force);
  ASSERT_EQ(after.patches.size(), 2U);
  expectEqual(after.patches[0], before.patches[0]);
  expectEqual(after.patches[1], before.patches[1]);
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
