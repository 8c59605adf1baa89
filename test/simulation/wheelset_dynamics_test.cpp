// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/wheelset_dynamics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "examples/simulate_wheelset/closed_loop.h"

using namespace simulate_wheelset;

namespace
{
constexpr double wheel_radius = 0.46;

ContactPoint pointAt(bool is_left, const Eigen::Vector3d& position, double angle, double normal_force)
{
  ContactPoint point;
  point.is_left = is_left;
  point.position = position;
  point.angle = angle;
  point.normal_force = normal_force;
  point.semi_axis_along = 0.006;
  point.semi_axis_across = 0.004;
  point.rolling_radius = -position.z();
  return point;
}

/// The left wheel runs on its tread and its flange, the right one on its tread.
ContactReply flangeContact()
{
  ContactReply contact;
  contact.is_usable = true;
  contact.roll = 0.002;
  contact.points = {pointAt(true, {0.004, 0.71, -0.472}, 1.1, 60e3), pointAt(true, {0, 0.745, -0.46}, 0.05, 70e3),
                    pointAt(false, {0, -0.755, -0.459}, -0.02, 100e3)};
  return contact;
}

TEST(WheelsetDynamics, LoadHoldsAllForcesThatTheContactCalculationLeavesOut)
{
  const Parameters parameters;
  WheelsetDynamics dynamics(parameters, wheel_radius);
  const ContactReply contact = flangeContact();
  dynamics.advance(contact);
  // Sums over the contacts, from the patch frames: the lateral normal force, and the creep force and its moment.
  double normal_y = 0, creep_z = 0, moment_of_z = 0, moment_of_y = 0;
  for (std::size_t i = 0; i < contact.points.size(); ++i)
  {
    const ContactPoint& p = contact.points[i];
    const double across = dynamics.forces().creep[i].across;
    normal_y -= p.normal_force * std::sin(p.angle);
    creep_z += across * std::sin(p.angle);
    moment_of_z += p.position.y() * across * std::sin(p.angle);
    moment_of_y -= p.position.z() * across * std::cos(p.angle);
  }
  // At the flange, neither part of the moment is small.
  EXPECT_GT(std::abs(moment_of_z), 3e3);
  EXPECT_GT(std::abs(moment_of_y), 3e3);
  const ContactRequest request = dynamics.request(0, contact.roll);
  const SuspensionParameters& s = parameters.suspension;
  const double suspension = -2 * s.vertical_stiffness * s.half_spacing * s.half_spacing * contact.roll;
  EXPECT_NEAR(request.torque_x, suspension + wheel_radius * normal_y + moment_of_z + moment_of_y, 1e-6);
  EXPECT_NEAR(request.torque_x, suspension + wheel_radius * normal_y + dynamics.forces().creep_moment.x(), 1e-6);
  EXPECT_NEAR(request.force_z, -parameters.wheelset.axle_load + creep_z, 1e-6);
}

TEST(WheelsetDynamics, StartsWithTheSpinOfFreeRolling)
{
  const Parameters parameters;
  EXPECT_DOUBLE_EQ(WheelsetDynamics(parameters, 0.5).motion().spin, parameters.run.speed / 0.5);
}

/// Contact with a prescribed usability in each call; the height counts the calls.
class Prescribed : public ContactSource
{
 public:
  explicit Prescribed(std::vector<bool> usable) : usable_(std::move(usable)) {}

  double rollingRadius() const override { return 0.46; }
  ContactReply evaluate(const ContactRequest& /*request*/) override
  {
    ContactReply reply;
    reply.is_usable = usable_.at(calls_++);
    reply.status = "beyond the end of a profile";
    reply.z = static_cast<double>(calls_);
    return reply;
  }

 private:
  std::vector<bool> usable_;
  std::size_t calls_ = 0;
};

TEST(HeldContact, LastUsableContactIsHeldAndCounted)
{
  Prescribed source({true, false, false, true, false, false});
  HeldContact contact(source, 2);
  const std::vector<double> heights = {1, 1, 1, 4, 4, 4};
  const std::vector<bool> held = {false, true, true, false, true, true};
  for (std::size_t i = 0; i < heights.size(); ++i)
  {
    EXPECT_EQ(contact.evaluate({}).z, heights[i]);
    EXPECT_EQ(contact.isHeld(), held[i]);
  }
  EXPECT_EQ(contact.held(), 4);
}

TEST(HeldContact, TooManySuccessiveStepsStopWithTheReason)
{
  Prescribed source({true, false, false, false});
  HeldContact contact(source, 2);
  for (int i = 0; i < 3; ++i)
  {
    contact.evaluate({});
  }
  try
  {
    contact.evaluate({});
    FAIL() << "no exception";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_STREQ(
        error.what(),
        "no usable contact in 3 successive steps, at 0.000000 s, y = 0.000000 mm: beyond the end of a profile");
  }
}

TEST(HeldContact, FirstStepMustBeUsable)
{
  Prescribed source({false});
  HeldContact contact(source, 5);
  EXPECT_THROW(contact.evaluate({}), std::runtime_error);
}
}  // namespace
