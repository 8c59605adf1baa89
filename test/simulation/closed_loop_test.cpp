// SPDX-License-Identifier: BSD-3-Clause
// Physics of the closed loop with the core library: S1002 on 60E1, 100 kN on each wheel.
#include "examples/simulate_wheelset/closed_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "examples/simulate_wheelset/in_process_contact.h"
#include "examples/simulate_wheelset/wheelset_dynamics.h"
#include "wheel_rail_contact/core/track_line.h"

namespace simulate_wheelset
{
namespace
{
const double pi = std::acos(-1.0);
constexpr double r0 = 0.46;         ///< rolling radius [m]
constexpr double half_base = 0.75;  ///< of the running circles, with the default wheelset [m]

std::unique_ptr<ContactSource> standardContact()
{
  return std::make_unique<InProcessContact>(readContactParameters(""));
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

/// Contacts over the lateral displacement without yaw, from 0 to `last` [m], in steps of 0.05 mm. The profiles are
/// mirror images, and so are the contacts at negative displacements.
class Sweep
{
 public:
  explicit Sweep(double last)
  {
    const auto contact = standardContact();
    ContactRequest request;
    request.force_z = -Parameters().wheelset.axle_load;
    for (request.y = 0; request.y <= last; request.y += step)
    {
      const ContactReply reply = contact->evaluate(request);
      if (!reply.is_usable)
      {
        break;
      }
      add(reply);
    }
  }

  /// Wavelength of the kinematic motion of an amplitude A.
  ///
  /// A wheelset that rolls without creepage obeys y' + r0 roll' = yaw and yaw' = -dr / (2 b r0), with the rolling
  /// radius difference dr = r_left - r_right and derivatives along the track. Klingel (1883) neglects the roll, which
  /// lengthens the wave by 1 % on the tread. With the equivalent conicity c and the slope s of the roll over y the
  /// wavelength is L = 2 pi sqrt(b r0 (1 + r0 s) / c). Both are those of harmonic linearisation: c = 1 / (2 pi A) times
  /// the integral over one period of dr(A sin t) sin t dt, and s = 1 / (pi A) times that of roll(A sin t) sin t dt.
  double kinematicWavelength(double amplitude) const
  {
    const double conicity = 0.5 * harmonic(difference_, amplitude) / amplitude;
    const double slope = harmonic(roll_, amplitude) / amplitude;
    return 2 * pi * std::sqrt(half_base * r0 * (1 + r0 * slope) / conicity);
  }

  /// Smallest displacement with a contact steeper than `angle` [m].
  double steepFrom(double angle) const
  {
    const auto place = std::find_if(angle_.begin(), angle_.end(), [&](double value) { return value > angle; });
    return step * static_cast<double>(place - angle_.begin());
  }

 private:
  static constexpr double step = 5e-5;  ///< [m]

  void add(const ContactReply& reply)
  {
    std::array<double, 2> force{}, moment{};
    double angle = 0;
    for (const ContactPoint& point : reply.points)
    {
      const std::size_t side = point.is_left ? 0 : 1;
      force[side] += point.normal_force;
      moment[side] += point.normal_force * point.rolling_radius;
      angle = std::max(angle, point.angle);
    }
    difference_.push_back(moment[0] / force[0] - moment[1] / force[1]);
    roll_.push_back(reply.roll);
    angle_.push_back(angle);
  }

  /// Amplitude of the first harmonic of an odd function of y, for y = amplitude sin t.
  static double harmonic(const std::vector<double>& values, double amplitude)
  {
    const int parts = 400;  // of a quarter of the period; the other three are equal
    double sum = 0;
    for (int i = 0; i < parts; ++i)
    {
      const double sine = std::sin(0.5 * pi * (i + 0.5) / parts);
      const double place = std::min(amplitude * sine / step, static_cast<double>(values.size()) - 1.001);
      const auto k = static_cast<std::size_t>(place);
      sum += (values[k] + (place - static_cast<double>(k)) * (values[k + 1] - values[k])) * sine;
    }
    return 2 * sum / parts;
  }

  std::vector<double> difference_;  ///< of the rolling radii [m]
  std::vector<double> roll_;        ///< [rad]
  std::vector<double> angle_;       ///< largest contact angle [rad]
};

TEST(ClosedLoop, FreeWheelsetAtLowSpeedFollowsKlingel)
{
  Parameters parameters = freeWheelset(2, 0.003);
  parameters.run.step = 2e-3;
  parameters.run.duration = 14;
  WheelsetDynamics dynamics(parameters);
  const auto contact = standardContact();
  const Sweep sweep(0.0032);
  // Half waves between zero crossings, with the amplitude of their extreme. The amplitude falls by a fifth per wave.
  std::vector<double> crossings, amplitudes;
  double extreme = 0, last = 0, roll = 0;
  for (int i = 0; i < 7000; ++i)
  {
    const Motion motion = dynamics.motion();
    const ContactReply reply = contact->evaluate(dynamics.request(i * 2'000'000LL, roll));
    ASSERT_TRUE(reply.is_usable) << reply.status;
    roll = reply.roll;
    dynamics.advance(reply);
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
    EXPECT_NEAR(2 * (crossings[i] - crossings[i - 1]) / kinematic, 1, 0.02) << amplitudes[i];
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
  above.run.yaw = 0.0075;
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
  const Sweep sweep(0.0068);
  const double amplitude = growing.waves.largestY();
  EXPECT_GT(amplitude, sweep.steepFrom(0.2));
  EXPECT_LT(amplitude, sweep.steepFrom(0.25 * pi));

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
  auto config = readContactParameters("");
  std::vector<wheel_rail_contact::core::LineStation> stations;
  const double size = 0.004, length = 30;  // a smooth step to the left, in both rails [m]
  for (int i = -10; i <= 200; ++i)
  {
    const double x = i, share = std::clamp(x / length, 0.0, 1.0);
    const double y = size * share * share * (3 - 2 * share);
    stations.push_back({x, 0, {{{y, 0, 0}, {-y, 0, 0}}}});  // outward: the right rail moves inward
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
