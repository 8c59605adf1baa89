// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "examples/simulate_wheelset/contact_source.h"
#include "examples/simulate_wheelset/parameters.h"
#include "usual_headers.h"

namespace simulate_wheelset
{
/// Contacts over the lateral displacement without yaw, from 0 to `last` [m], in steps of 0.05 mm. The profiles are
/// mirror images, and so are the contacts at negative displacements.
class Sweep
{
 public:
  Sweep(ContactSource& contact, double last)
  {
    ContactRequest request;
    request.state.force_z = -Parameters().wheelset.axle_load;
    double& y = request.state.y;
    for (; y <= last; y += step)
    {
      const ContactReply reply = contact.evaluate(request);
      if (!isUsable(reply.status))
      {
        ADD_FAILURE() << "no contact at y = " << y << ": " << reply.reason;
        return;
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
    return 2 * pi() * std::sqrt(half_base * r0 * (1 + r0 * slope) / conicity);
  }

  /// Smallest displacement with a contact steeper than `angle` [m].
  double steepFrom(double angle) const
  {
    const auto place = std::find_if(angle_.begin(), angle_.end(), [&](double value) { return value > angle; });
    return step * static_cast<double>(place - angle_.begin());
  }

 private:
  static constexpr double step = 5e-5;       ///< [m]
  static constexpr double r0 = 0.46;         ///< rolling radius [m]
  static constexpr double half_base = 0.75;  ///< of the running circles, with the default wheelset [m]

  static double pi() { return std::acos(-1.0); }

  void add(const ContactReply& reply)
  {
    wheel_rail_contact::core::Sides<double> force, moment;
    double angle = 0;
    for (const auto& patch : reply.patches)
    {
      force[patch.side] += patch.normal_force;
      moment[patch.side] += patch.normal_force * patch.rolling_radius;
      angle = std::max(angle, patch.pose.angle);
    }
    difference_.push_back(moment.left / force.left - moment.right / force.right);
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
      const double sine = std::sin(0.5 * pi() * (i + 0.5) / parts);
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
}  // namespace simulate_wheelset
