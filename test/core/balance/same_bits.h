// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wheelset_scene.h"

/// Comparison of results without a tolerance: with equal results, and with the mirror image, in which left and right
/// are exchanged. Both sides use the same arithmetic.
namespace wheel_rail_contact::core
{
inline Side otherSide(Side side)
{
  return side == Side::left ? Side::right : Side::left;
}

inline WheelsetState mirrored(WheelsetState state)
{
  state.y = -state.y;
  state.yaw = -state.yaw;
  state.roll = -state.roll;
  state.torque_x = -state.torque_x;
  std::swap(state.rail_lateral_force.left, state.rail_lateral_force.right);
  std::swap(state.rail_displacement.left, state.rail_displacement.right);
  return state;
}

inline ContactModelConfig mirrored(ContactModelConfig config)
{
  std::swap(config.wheel_profile.left, config.wheel_profile.right);
  std::swap(config.rail_profile.left, config.rail_profile.right);
  std::swap(config.rail_sections.left, config.rail_sections.right);
  std::swap(config.wheel_material.left, config.wheel_material.right);
  std::swap(config.rail_material.left, config.rail_material.right);
  std::swap(config.track.rail_inclination.left, config.track.rail_inclination.right);
  std::swap(config.wheelset.rolling_radius.left, config.wheelset.rolling_radius.right);
  std::swap(config.rail_bending.table.left, config.rail_bending.table.right);
  return config;
}

/// Expects the numbers that a patch and its mirror image share to be equal in every bit.
inline void expectSameNumbers(const PatchResult& a, const PatchResult& b)
{
  EXPECT_EQ(a.pose.z, b.pose.z);
  for (const auto number : {&PatchResult::contact_angle, &PatchResult::normal_force, &PatchResult::approach,
                            &PatchResult::area, &PatchResult::max_pressure, &PatchResult::error_estimate})
  {
    EXPECT_EQ(a.*number, b.*number);
  }
  ASSERT_EQ(a.pressure.rows(), b.pressure.rows());
  ASSERT_EQ(a.pressure.cols(), b.pressure.cols());
}

/// Expects two patches to be equal in every bit.
inline void expectSameBits(const PatchResult& a, const PatchResult& b)
{
  EXPECT_EQ(a.side, b.side);
  EXPECT_EQ(a.pose.y, b.pose.y);
  EXPECT_EQ(a.pose.angle, b.pose.angle);
  ASSERT_NO_FATAL_FAILURE(expectSameNumbers(a, b));
  EXPECT_TRUE((a.pressure == b.pressure).all());
}

/// Expects two results to be equal in every bit.
inline void expectSameBits(const WheelsetResult& a, const WheelsetResult& b)
{
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.z, b.z);
  EXPECT_EQ(a.roll, b.roll);
  ASSERT_EQ(a.patches.size(), b.patches.size());
  for (std::size_t k = 0; k < a.patches.size(); ++k)
  {
    expectSameBits(a.patches[k], b.patches[k]);
  }
}

/// Equal bits.
inline void expectMirrorImage(const PatchResult& patch, const PatchResult& image)
{
  EXPECT_EQ(patch.pose.x, image.pose.x);
  EXPECT_EQ(patch.pose.y, -image.pose.y);
  EXPECT_EQ(patch.pose.angle, -image.pose.angle);
  EXPECT_EQ(patch.iterations, image.iterations);
  EXPECT_EQ(patch.residual, image.residual);
  ASSERT_NO_FATAL_FAILURE(expectSameNumbers(patch, image));
  EXPECT_TRUE((patch.pressure == image.pressure.rowwise().reverse()).all());
}

/// Equal bits.
inline void expectMirrorImage(const WheelsetResult& result, const WheelsetResult& image)
{
  EXPECT_EQ(result.status, image.status);
  EXPECT_EQ(result.z, image.z);
  EXPECT_EQ(result.roll, -image.roll);
  for (const Side side : sides)
  {
    const RailResult& rail = result.rail[side];
    const RailResult& other_rail = image.rail[otherSide(side)];
    EXPECT_EQ(rail.lateral_force, other_rail.lateral_force);
    EXPECT_EQ(rail.vertical_force, other_rail.vertical_force);
    EXPECT_EQ(rail.moment, other_rail.moment);
    EXPECT_EQ(rail.deflection.lateral, other_rail.deflection.lateral);
    EXPECT_EQ(rail.deflection.vertical, other_rail.deflection.vertical);
    EXPECT_EQ(rail.deflection.roll, other_rail.deflection.roll);
    const auto patches = patchesOf(result, side);
    const auto images = patchesOf(image, otherSide(side));
    ASSERT_EQ(patches.size(), images.size());
    for (std::size_t k = 0; k < patches.size(); ++k)
    {
      expectMirrorImage(*patches[k], *images[k]);
    }
  }
}

/// Expects the mirror image of a scene to have mirrored results of mirrored states, every second one from a cold start.
/// @return number of usable results
template <typename RandomState>
int expectMirroredResults(const ContactModelConfig& config, int count, RandomState random_state)
{
  WheelsetContact contact(config), mirror(mirrored(config));
  int usable = 0;
  for (int i = 0; i < count; ++i)
  {
    const WheelsetState state = random_state();
    if (i % 2 == 0)
    {
      contact.reset();
      mirror.reset();
    }
    SCOPED_TRACE("y " + std::to_string(state.y) + " yaw " + std::to_string(state.yaw));
    const WheelsetResult& result = contact.evaluate(state);
    expectMirrorImage(result, mirror.evaluate(mirrored(state)));
    usable += isUsable(result.status) ? 1 : 0;
  }
  return usable;
}
}  // namespace wheel_rail_contact::core
