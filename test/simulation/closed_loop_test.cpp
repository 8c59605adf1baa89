// SPDX-License-Identifier: BSD-3-Clause
// Physics of the closed loop with the core library: S1002 on 60E1, 100 kN on each wheel.
#include "examples/simulate_wheelset/closed_loop.h"

#include "examples/simulate_wheelset/contact_ways.h"
#include "examples/simulate_wheelset/wheelset_dynamics.h"
#include "simulation/sweep.h"
#include "wheel_rail_contact/core/track.h"

namespace simulate_wheelset
{
namespace
{
std::unique_ptr<ContactSource> standardContact()
{
  return std::make_unique<InProcessContact>(readContact(""));
}

/// A wheelset without suspension.
Parameters freeWheelset(double speed, double y)
{
  Parameters p;
  p.suspension.longitudinal_stiffness = p.suspension.lateral_stiffness = p.suspension.vertical_stiffness = 0;
  p.run.speed = speed;
  p.run.y = y;
  return p;
}

TEST(ClosedLoop, FreeWheelsetAtLowSpeedFollowsKlingel)
{
  Parameters parameters = freeWheelset(2, 0.003);
  parameters.run.step = 2e-3;
  parameters.run.duration = 14;
  const auto contact = standardContact();
  WheelsetDynamics dynamics(parameters);
  HeldContact held(*contact, 0);
  const Sweep sweep(*standardContact(), 0.0032);
  // Half waves between zero crossings, with the amplitude of their extreme. The amplitude falls by a fifth per wave.
  std::vector<double> crossings, amplitudes;
  double extreme = 0, last = 0;
  for (int i = 0; i < 7000; ++i)
  {
    const Motion motion = dynamics.motion();
    ASSERT_TRUE(isUsable(dynamics.advance(held).status));
    if (i > 0 && (motion.y > 0) != (last > 0))
    {
      const double time = parameters.run.step * (i - motion.y / (motion.y - last));
      crossings.push_back(parameters.run.speed * time);
      amplitudes.push_back(extreme);
      extreme = 0;
    }
    extreme = std::max(extreme, std::abs(motion.y));
    last = motion.y;
  }
  ASSERT_GE(crossings.size(), 6U);
  for (std::size_t i = 1; i < crossings.size(); ++i)
  {
    const double kinematic = sweep.kinematicWavelength(amplitudes[i]);
    // The amplitude falls by 9 % in a half wave, and with it the wavelength by 0.8 %: which amplitude within the half
    // wave counts is open within this.
    EXPECT_NEAR(2 * (crossings[i] - crossings[i - 1]) / kinematic, 1, 0.01) << amplitudes[i];
  }
}

/// On a suspension so soft that waves of every amplitude on the tread grow at 40 m/s.
Parameters softlyGuided(double y, double duration)
{
  Parameters parameters;
  parameters.suspension.longitudinal_stiffness = parameters.suspension.lateral_stiffness = 0.05e6;
  parameters.run.speed = 40;
  parameters.run.y = y;
  parameters.run.duration = duration;
  return parameters;
}

TEST(ClosedLoop, SoftGuidanceEndsInOneLimitCycleFromBothSides)
{
  const RunSummary growing = runClosedLoop(softlyGuided(0.0015, 5), *standardContact(), nullptr);
  Parameters above = softlyGuided(0, 2);
  above.run.yaw = 0.0065;
  const RunSummary falling = runClosedLoop(above, *standardContact(), nullptr);
  for (const RunSummary* run : {&growing, &falling})
  {
    EXPECT_EQ(run->held, 0);
    EXPECT_GT(run->saturated, 0);
    ASSERT_GE(run->waves.count(), 3);
  }
  // In 120 m a wave that is not yet settled would still change by more.
  EXPECT_NEAR(falling.waves.largestY() / growing.waves.largestY(), 1, 0.01);
  EXPECT_NEAR(falling.waves.wavelength() / growing.waves.wavelength(), 1, 0.01);

  // Amplitude: waves grow until the gauge corner carries load (the left contact turns steeper than the tread), and the
  // flange, which is steeper than 45 degrees, ends the growth.
  const Sweep sweep(*standardContact(), 0.0068);
  const double amplitude = growing.waves.largestY();
  EXPECT_GT(amplitude, sweep.steepFrom(0.2));
  EXPECT_LT(amplitude, sweep.steepFrom(std::atan(1.0)));

  // Wavelength: harmonic balance of m y'' + d1 y' + K1 y = V d1 psi and I psi'' + d2 psi' + K2 psi = -(V d2 / l^2) y.
  // Here l is the kinematic wavelength over 2 pi, and the dampings d1, d2 of the creep forces may have any size, as the
  // saturation leaves it. A steady wave of frequency w has (K1 - m w^2) d2 + (K2 - I w^2) d1 = 0: both brackets differ
  // in sign. Then w^2 = (V / l)^2 + (K1 - m w^2) (K2 - I w^2) / (d1 d2) is below (V / l)^2, and the wave longer than
  // the kinematic one of its amplitude. It is shorter than that of the tread, as the gauge corner raises the conicity.
  EXPECT_GT(growing.waves.wavelength(), sweep.kinematicWavelength(amplitude));
  EXPECT_LT(growing.waves.wavelength(), sweep.kinematicWavelength(0.002));

  // Energy: the work of the drag becomes heat in the contacts. The step of 1 ms adds 3 %, one of 0.25 ms 1 %.
  const double work = growing.waves.drag() * 40;
  EXPECT_GT(work, 100);
  EXPECT_NEAR(growing.waves.frictionPower() / work, 1, 0.05);
}

TEST(ClosedLoop, FrictionTakesTheWorkOfTheDragInTheLimitCycle)
{
  Parameters parameters;
  parameters.run.y = 0.0058;
  parameters.run.duration = 1.1;
  parameters.run.step = 0.25e-3;
  const RunSummary run = runClosedLoop(parameters, *standardContact(), nullptr);
  ASSERT_GE(run.waves.count(), 1);
  EXPECT_GT(run.waves.drag(), 20);
  EXPECT_NEAR(run.waves.frictionPower() / (run.waves.drag() * parameters.run.speed), 1, 0.02);
}

TEST(ClosedLoop, StiffGuidanceDampsTheWave)
{
  Parameters parameters;
  parameters.suspension.longitudinal_stiffness = 5e6;
  parameters.suspension.lateral_stiffness = 2e6;
  parameters.run.duration = 1.5;
  const RunSummary run = runClosedLoop(parameters, *standardContact(), nullptr);
  EXPECT_LT(run.waves.largestY(), 0.1 * parameters.run.y);
  EXPECT_EQ(run.saturated, 0);
}

TEST(ClosedLoop, WheelsetFollowsAMisalignedTrack)
{
  auto config = readContact("");
  std::vector<wheel_rail_contact::core::LineStation> stations;
  const double size = 0.004, length = 30;  // a smooth step to the left, in both rails [m]
  for (int i = -10; i <= 200; ++i)
  {
    const double x = i, share = std::clamp(x / length, 0.0, 1.0);
    const double y = size * share * share * (3 - 2 * share);
    stations.push_back({x, 0, {{y, 0, 0}, {-y, 0, 0}}});  // outward: the right rail moves inward
  }
  config.track.line = std::make_shared<const wheel_rail_contact::core::TrackLine>("step", stations);
  InProcessContact contact(config);
  Parameters parameters = freeWheelset(10, 0);
  parameters.run.duration = 12;
  parameters.run.step = 4e-3;
  RunSummary run = runClosedLoop(parameters, contact, nullptr);
  EXPECT_EQ(run.held, 0);
  // The wheelset oscillates about the displaced track: its largest displacement is beyond the track, below twice of it.
  EXPECT_GT(run.waves.largestY(), size);
  EXPECT_LT(run.waves.largestY(), 2 * size);
}
}  // namespace
}  // namespace simulate_wheelset
