// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../../usual_headers.h"
#include "core/track/contact_search.h"

namespace wheel_rail_contact::core
{
/// Separation of wheel and rail by brute force, at stations 10 um apart. Both outlines are sampled every 10 um of their
/// profiles and connected by chords. On radii above 10 mm the error of the chords is less than 2 nm.
class DenseSeparation
{
 public:
  static constexpr double spacing = 1e-5;  ///< [m]

  /// Computes the separation at `places` stations from y = `y_first` [m], side axes.
  DenseSeparation(const PlacedWheel& wheel, const PlacedRail& rail, double y_first = 0.64, std::size_t places = 20000)
      : y_first_(y_first), wheel_(places, infinity()), rail_(places, -infinity())
  {
    trace(rail.profile().length(), rail_, 1,
          [&](double u, SpacePoint& point)
          {
            const PlanePoint at = rail.at(u);
            point = {0, at.y, at.z};
            return true;
          });
    trace(wheel.profile().length(), wheel_, -1,
          [&](double u, SpacePoint& point) { return wheel.locus(wheel.profile().at(u), point); });
  }

  std::size_t size() const { return wheel_.size(); }
  /// y of station k, side axes [m].
  double y(std::size_t k) const { return y_first_ + static_cast<double>(k) * spacing; }
  /// Separation at station k [m]; infinite where one of the bodies is missing.
  double at(std::size_t k) const { return wheel_[k] - rail_[k]; }
  /// Separation at the station nearest to y = `place` [m].
  double near(double place) const { return at(static_cast<std::size_t>(std::lround((place - y_first_) / spacing))); }
  double railHeight(std::size_t k) const { return rail_[k]; }
  /// Station of the smallest separation.
  std::size_t lowest() const
  {
    std::size_t best = 0;
    for (std::size_t k = 0; k < size(); ++k)
    {
      best = at(k) < at(best) ? k : best;
    }
    return best;
  }

 private:
  static double infinity() { return std::numeric_limits<double>::infinity(); }

  /// Adds a curve to an upper (`side` = 1) or lower (`side` = -1) envelope.
  template <typename Curve>
  void trace(double length, std::vector<double>& outline, double side, Curve curve)
  {
    SpacePoint before{};
    bool has_before = false;
    for (double u = 0; u <= length; u += spacing)
    {
      SpacePoint here{};
      const bool exists = curve(u, here);
      if (exists && has_before)
      {
        writeChord(before, here, side, outline);
      }
      before = here;
      has_before = exists;
    }
  }

  void writeChord(const SpacePoint& a, const SpacePoint& b, double side, std::vector<double>& outline)
  {
    const double low = std::min(a.y, b.y);
    const double high = std::max(a.y, b.y);
    for (auto k = static_cast<std::size_t>(std::ceil((low - y_first_) / spacing)); k < size() && y(k) <= high; ++k)
    {
      const double z = a.z + (y(k) - a.y) / (b.y - a.y) * (b.z - a.z);
      outline[k] = side * (z - outline[k]) > 0 ? z : outline[k];
    }
  }

  double y_first_;
  std::vector<double> wheel_, rail_;
};

/// Largest curvature of the separation [1/m]: on the flank, at a section boundary of S1002.
constexpr double sharpest = 3200;

/// Largest error of a minimum by brute force [m]. The nearest station is up to 5 um beside the minimum and therefore up
/// to 3200 1/m / 2 * (5 um)² = 0.04 um too high. Chords add 0.002 um / cos(70 degrees) on the flank.
constexpr double dense_error = 0.05e-6;

/// Nearest position of a search that must have one.
template <typename Search>
InitialContact nearestOf(Search&& search)
{
  InitialContact contact;
  return search.nearest(contact) ? contact : throw std::runtime_error("no contact");
}

inline std::vector<OverlapInterval> intervalsOf(const ContactSearch& search, double separation)
{
  std::vector<OverlapInterval> found;
  search.overlapIntervals(separation, found);
  return found;
}
}  // namespace wheel_rail_contact::core
