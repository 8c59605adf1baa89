// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/geometry/radius_integral.h"
#include "core/option_check.h"
#include "core/pi.h"
#include "core/track/bracketed_root.h"
#include "wheel_rail_contact/core/contact_geometry.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double centre_tolerance = 1e-14;  ///< [m]
/// Largest |dr| per amplitude that counts as none [-]. The conicity is then at most pi² / 16 times as large: that of a
/// constant |dr| which changes its sign in the centre.
constexpr double least_difference = 5e-4;

/// The waves of one amplitude on a curve. A wave is described by its centre: the middle between its turning points.
class WaveSearch
{
 public:
  WaveSearch(const std::vector<RadiusDifference>& curve, double amplitude)
      : curve_(curve),
        integral_(curve),
        amplitude_(amplitude),
        flat_(integral_.widestFlat(least_difference * amplitude))
  {
  }

  EquivalentConicity find() const
  {
    const bool flat = flat_.width() >= 2 * amplitude_;
    if (!flat && !integral_.hasCentre())
    {
      return failed(ConicityStatus::no_centre);
    }
    if (integral_.range().width() < 2 * amplitude_)
    {
      return failed(ConicityStatus::out_of_range);
    }
    std::vector<EquivalentConicity> waves = restoredWaves();
    if (flat)
    {
      waves.push_back({0, 0.5 * (flat_.begin + flat_.end), ConicityStatus::ok});
    }
    if (waves.size() == 1)
    {
      return waves.front();
    }
    return failed(!waves.empty()        ? ConicityStatus::several_waves
                  : isBeyond(centres()) ? ConicityStatus::out_of_range
                                        : ConicityStatus::no_wave);
  }

 private:
  static EquivalentConicity failed(ConicityStatus status)
  {
    EquivalentConicity result;
    result.status = status;
    return result;
  }

  DisplacementRange around(double centre) const { return {centre - amplitude_, centre + amplitude_}; }

  /// Difference of S at both ends of a wave with this centre [m²]; zero for a wave, negative left of it.
  double imbalance(double centre) const
  {
    return integral_.at(centre + amplitude_) - integral_.at(centre - amplitude_);
  }

  /// Centres at which an end of the wave is at a point of the curve, increasing. The imbalance is a parabola between
  /// them.
  std::vector<double> centres() const
  {
    const DisplacementRange range = integral_.range();
    const double first = range.begin + amplitude_, last = range.end - amplitude_;
    std::vector<double> found{first, last};
    for (const RadiusDifference& point : curve_)
    {
      for (const double centre : {point.y - amplitude_, point.y + amplitude_})
      {
        if (centre > first && centre < last)
        {
          found.push_back(centre);
        }
      }
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  /// Waves that the radius difference restores. Those in the flat range are not among them.
  std::vector<EquivalentConicity> restoredWaves() const
  {
    std::vector<EquivalentConicity> waves;
    const std::vector<double> places = centres();
    double before = imbalance(places.front());
    for (std::size_t i = 1; i < places.size(); ++i)
    {
      const double after = imbalance(places[i]);
      if (before < 0 && after >= 0)
      {
        const auto of_centre = [this](double centre) { return imbalance(centre); };
        const double centre = bracketedRoot(of_centre, places[i - 1], before, places[i], after, centre_tolerance);
        const double integral = integral_.overWave(around(centre));
        if (std::isfinite(integral) && !flat_.contains(around(centre)))
        {
          waves.push_back({pi * pi / (integral * integral), centre, ConicityStatus::ok});
        }
      }
      before = after;
    }
    return waves;
  }

  /// True if a wave lies partly beyond the range: the imbalance has no change of its sign towards an end.
  bool isBeyond(const std::vector<double>& places) const
  {
    return imbalance(places.front()) > 0 || imbalance(places.back()) < 0;
  }

  const std::vector<RadiusDifference>& curve_;
  RadiusIntegral integral_;
  double amplitude_;
  DisplacementRange flat_;  ///< widest range without a radius difference
};
}  // namespace

const char* toString(ConicityStatus status)
{
  switch (status)
  {
    case ConicityStatus::no_centre:
      return "the rolling radius difference has no zero at which it grows with y";
    case ConicityStatus::out_of_range:
      return "the wave leaves the computed range of y";
    case ConicityStatus::no_wave:
      return "no periodic wave has this amplitude";
    case ConicityStatus::several_waves:
      return "several waves have this amplitude";
    case ConicityStatus::ok:
      break;
  }
  return "ok";
}

EquivalentConicity equivalentConicity(const std::vector<RadiusDifference>& curve, double amplitude)
{
  requirePositive("amplitude", amplitude);
  return WaveSearch(curve, amplitude).find();
}

double kinematicWavelength(double conicity, double base, double radius)
{
  return 2 * pi * std::sqrt(base * radius / (2 * conicity));
}
}  // namespace wheel_rail_contact::core
