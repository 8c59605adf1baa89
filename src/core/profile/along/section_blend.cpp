// SPDX-License-Identifier: BSD-3-Clause
#include "core/profile/along/section_blend.h"

#include <algorithm>
#include <cmath>

#include "core/option_check.h"
#include "core/profile/curve/monotone_cubic.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double longest_section = 5e-4;  ///< of a blend [m]
constexpr double least_length = 0.010;    ///< of a blend [m]

/// Map of a common parameter to those of both sections, through corresponding places.
class ParameterMap
{
 public:
  explicit ParameterMap(const std::vector<CorrespondingPlaces>& places) : places_(places), common_{0.0}
  {
    for (std::size_t i = 1; i < places.size(); ++i)
    {
      const double a = places[i].a - places[i - 1].a, b = places[i].b - places[i - 1].b;
      refuseIf(!(a > 0 && b > 0), "have corresponding places that are not in the same order");
      common_.push_back(common_.back() + 0.5 * (a + b));
    }
  }

  const std::vector<double>& common() const { return common_; }

  /// Parameters of both sections, and their derivatives, at the common parameter `s` [m].
  void at(double s, CorrespondingPlaces& u, CorrespondingPlaces& slope) const
  {
    if (s <= 0 || s >= common_.back())
    {
      const CorrespondingPlaces& end = s <= 0 ? places_.front() : places_.back();
      const double beyond = s <= 0 ? s : s - common_.back();
      u = {end.a + beyond, end.b + beyond};
      slope = {1, 1};
      return;
    }
    const auto after = std::upper_bound(common_.begin(), common_.end() - 1, s);
    const auto i = static_cast<std::size_t>(after - common_.begin());
    cubic(
        i, s, [this](std::size_t k) { return places_[k].a; }, u.a, slope.a);
    cubic(
        i, s, [this](std::size_t k) { return places_[k].b; }, u.b, slope.b);
  }

 private:
  template <typename Value>
  void cubic(std::size_t i, double s, const Value& value, double& u, double& slope) const
  {
    const double t = s - common_[i - 1];
    double c[4];
    setCubic(value(i - 1), value(i), slopeAt(i - 1, value), slopeAt(i, value), common_[i] - common_[i - 1], c);
    u = c[0] + t * (c[1] + t * (c[2] + t * c[3]));
    slope = c[1] + t * (2 * c[2] + t * 3 * c[3]);
  }

  template <typename Value>
  double slopeAt(std::size_t i, const Value& value) const
  {
    const auto chord = [&](std::size_t k) { return (value(k) - value(k - 1)) / (common_[k] - common_[k - 1]); };
    const double beyond = 1;  // outside, lengths are kept
    const double before = i > 0 ? chord(i) : beyond, after = i + 1 < common_.size() ? chord(i + 1) : beyond;
    const double width_before = i > 0 ? common_[i] - common_[i - 1] : common_[i + 1] - common_[i];
    const double width_after = i + 1 < common_.size() ? common_[i + 1] - common_[i] : width_before;
    return monotoneSlope(before, after, width_before, width_after);
  }

  const std::vector<CorrespondingPlaces>& places_;
  std::vector<double> common_;  ///< common parameter of each place [m]
};

/// Point of a section and its derivative with respect to the common parameter.
struct Knot
{
  Knot(const Profile& profile, double u, double slope)
  {
    const CurvePoint p = profile.at(std::clamp(u, 0.0, profile.length()));
    y = p.y;
    z = p.z;
    dy = slope * p.dy;
    dz = slope * p.dz;
  }

  double y, z, dy, dz;
};

CubicSection between(const Knot& begin, const Knot& end, double length)
{
  CubicSection section{};
  setCubic(begin.y, end.y, begin.dy, end.dy, length, section.y);
  setCubic(begin.z, end.z, begin.dz, end.dz, length, section.z);
  return section;
}
}  // namespace

SectionBlend::SectionBlend(const Profile& a, const Profile& b, const std::vector<CorrespondingPlaces>& places)
{
  refuseIf(places.empty(), "have no corresponding places");
  const ParameterMap map(places);
  const CorrespondingPlaces &first = places.front(), &last = places.back();
  const double end = map.common().back() + std::min(a.length() - last.a, b.length() - last.b);
  const double begin = -std::min(first.a, first.b);
  refuseIf(!(end - begin >= least_length), "have less than 10 mm in common");
  const auto count = std::max(2L, std::lround(std::ceil((end - begin) / longest_section)));
  length_ = (end - begin) / static_cast<double>(count);
  std::vector<Knot> on_a, on_b;
  std::vector<CorrespondingPlaces> parameters;
  for (long i = 0; i <= count; ++i)
  {
    CorrespondingPlaces u{}, slope{};
    map.at(begin + static_cast<double>(i) * length_, u, slope);
    on_a.emplace_back(a, u.a, slope.a);
    on_b.emplace_back(b, u.b, slope.b);
    parameters.push_back(u);
  }
  for (std::size_t i = 1; i < on_a.size(); ++i)
  {
    of_a_.push_back(between(on_a[i - 1], on_a[i], length_));
    of_b_.push_back(between(on_b[i - 1], on_b[i], length_));
    const ShapeError in_a = a.errorWithin(parameters[i - 1].a, parameters[i].a);
    const ShapeError in_b = b.errorWithin(parameters[i - 1].b, parameters[i].b);
    error_.push_back({std::max(in_a.position, in_b.position), std::max(in_a.curvature, in_b.curvature),
                      in_a.missing || in_b.missing});
  }
}

CubicSection SectionBlend::at(std::size_t section, double share) const
{
  const CubicSection &a = of_a_[section], &b = of_b_[section];
  CubicSection mean{};
  for (std::size_t k = 0; k < 4; ++k)
  {
    mean.y[k] = a.y[k] + share * (b.y[k] - a.y[k]);
    mean.z[k] = a.z[k] + share * (b.z[k] - a.z[k]);
  }
  return mean;
}
}  // namespace wheel_rail_contact::core
