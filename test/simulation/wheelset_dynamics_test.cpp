// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/wheelset_dynamics.h"

#include "../usual_headers.h"
#include "examples/simulate_wheelset/closed_loop.h"

using namespace simulate_wheelset;
using wheel_rail_contact::core::ContactStatus;

namespace
{
/// Rails that give a prescribed reply, whatever the request.
class Rails : public ContactSource
{
 public:
  Rails() { reply.status = ContactStatus::ok; }
  ContactReply evaluate(const ContactRequest& /*request*/) override { return reply; }

  ContactReply reply;
};

TEST(WheelsetDynamics, LoadHasNoForceOfTheRails)
{
  Parameters parameters;
  parameters.wheelset.gyroscopic = 0;
  Rails rails;
  rails.reply.roll = 0.002;
  rails.reply.rail_wrench.force = {-100, 5e3, 200e3};
  rails.reply.rail_wrench.moment = {8e3, 30, 2e3};
  HeldContact held(rails, 0);
  WheelsetDynamics dynamics(parameters);
  dynamics.advance(held);
  const wheel_rail_contact::core::WheelsetState request = dynamics.request().state;
  const SuspensionParameters& s = parameters.suspension;
  EXPECT_NEAR(request.torque_x, -2 * s.vertical_stiffness * s.half_spacing * s.half_spacing * 0.002, 1e-9);
  EXPECT_EQ(request.force_z, -parameters.wheelset.axle_load);
  // The forces of the rails move the wheelset.
  const double step = parameters.run.step, spring = 2 * s.lateral_stiffness * parameters.run.y;
  EXPECT_NEAR(request.motion.lateral_velocity, step * (5e3 - spring) / parameters.wheelset.mass, 1e-12);
  EXPECT_NEAR(request.motion.yaw_rate, step * 2e3 / parameters.wheelset.yaw_inertia, 1e-12);
}

TEST(WheelsetDynamics, AGyroscopicWheelsetConservesItsAngularMomentum)
{
  // Without moments about z, I_z yaw' + I_y W roll is constant.
  Parameters parameters;
  parameters.suspension.longitudinal_stiffness = parameters.suspension.vertical_stiffness = 0;
  Rails rails;
  rails.reply.rotation = 87;
  HeldContact held(rails, 0);
  WheelsetDynamics dynamics(parameters);
  dynamics.advance(held);
  const double roll = 1e-3;
  for (int i = 1; i <= 4; ++i)
  {
    rails.reply.roll = std::min(1.0, i / 2.0) * roll;
    dynamics.advance(held);
  }
  const double spin_momentum = parameters.wheelset.spin_inertia * 87;
  EXPECT_NEAR(dynamics.motion().yaw_rate, -spin_momentum * roll / parameters.wheelset.yaw_inertia, 1e-9);
  // The turn of the axle to the right raises the right wheel: the moment on the axle is negative.
  EXPECT_NEAR(dynamics.request().state.torque_x, spin_momentum * dynamics.motion().yaw_rate, 1e-9);
}

TEST(WheelsetDynamics, LoadHasTheInertiaOnALine)
{
  Parameters parameters;
  parameters.suspension.vertical_stiffness = 0;
  const double rise = 3, turn = 2, step = parameters.run.step;  // [m/s^2], [rad/s^2]
  for (const double is_on : {1.0, 0.0})
  {
    parameters.wheelset.line_inertia = is_on;
    Rails rails;
    HeldContact held(rails, 0);
    WheelsetDynamics dynamics(parameters);
    for (int i = 0; i < 4; ++i)
    {
      const double half_square = 0.5 * i * i * step * step;
      rails.reply.rail.left.given.vertical = half_square * (rise + 0.75 * turn);
      rails.reply.rail.right.given.vertical = half_square * (rise - 0.75 * turn);
      dynamics.advance(held);
    }
    const WheelsetParameters& w = parameters.wheelset;
    EXPECT_NEAR(dynamics.request().state.force_z, -w.axle_load - is_on * w.mass * rise, 1e-3);
    EXPECT_NEAR(dynamics.request().state.torque_x, -is_on * w.yaw_inertia * turn, 1e-3);
  }
}

/// Contact with a prescribed usability in each call; the height counts the calls.
class Prescribed : public ContactSource
{
 public:
  explicit Prescribed(std::vector<bool> usable) : usable_(std::move(usable)) {}

  ContactReply evaluate(const ContactRequest& /*request*/) override
  {
    ContactReply reply;
    reply.status = usable_.at(calls_++) ? ContactStatus::ok : ContactStatus::off_profile;
    reply.reason = "beyond the end of a profile";
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
    EXPECT_STREQ(error.what(),
                 "no usable contact in 3 successive steps, at 0.000000 s, y = 0.000000 mm: OFF_PROFILE: beyond the end "
                 "of a profile");
  }
}

TEST(HeldContact, FirstStepMustBeUsable)
{
  Prescribed source({false});
  HeldContact contact(source, 5);
  EXPECT_THROW(contact.evaluate({}), std::runtime_error);
}
}  // namespace
