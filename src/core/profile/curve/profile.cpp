// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/profile.h"

#include <algorithm>
#include <cmath>

#include "core/constants.h"
#include "core/option_check.h"

namespace wheel_rail_contact::core
{
namespace
{
CurveExpansion evaluate(const LineSection& line, double t)
{
  return {{line.y0 + t * line.dy, line.z0 + t * line.dz, line.dy, line.dz, 0.0, 0.0}, 0.0, 0.0};
}

CurveExpansion evaluate(const ArcSection& arc, double t)
{
  const double bend = 1.0 / arc.radius;
  const double phi = arc.angle + arc.turn * t * bend;
  const double c = std::cos(phi);
  const double s = std::sin(phi);
  const double third = arc.turn * bend * bend;
  return {{arc.yc + arc.radius * c, arc.zc + arc.radius * s, -arc.turn * s, arc.turn * c, -c * bend, -s * bend},
          third * s,
          -third * c};
}

/// Horner scheme for a polynomial and its first three derivatives.
CurveExpansion evaluate(const PolynomialSection& law, double t)
{
  const double y = law.y0 + t;
  double value = 0.0, first = 0.0, half_second = 0.0, sixth_third = 0.0;
  for (std::size_t k = law.count; k-- > 0;)
  {
    sixth_third = sixth_third * y + half_second;
    half_second = half_second * y + first;
    first = first * y + value;
    value = value * y + law.coefficient[k];
  }
  return {{y, value, 1.0, first, 0.0, 2.0 * half_second}, 0.0, 6.0 * sixth_third};
}

CurveExpansion evaluate(const CubicSection& law, double t)
{
  const double* y = law.y;
  const double* z = law.z;
  return {{y[0] + t * (y[1] + t * (y[2] + t * y[3])), z[0] + t * (z[1] + t * (z[2] + t * z[3])),
           y[1] + t * (2.0 * y[2] + t * 3.0 * y[3]), z[1] + t * (2.0 * z[2] + t * 3.0 * z[3]),
           2.0 * y[2] + t * 6.0 * y[3], 2.0 * z[2] + t * 6.0 * z[3]},
          6.0 * y[3],
          6.0 * z[3]};
}

/// Lines and cubics need no further check: any finite numbers define them.
void checkSection(const ProfileSection& section)
{
  refuseIf(!(section.length > 0.0) || !std::isfinite(section.length), "profile: section length is ", section.length,
           " m, must be positive and finite");
  const auto* arc = std::get_if<ArcSection>(&section.law);
  const double radius = arc != nullptr ? arc->radius : infinity;
  refuseIf(!(radius > 0.0), "profile: arc radius is ", radius, " m, must be positive");
  const auto* law = std::get_if<PolynomialSection>(&section.law);
  const std::size_t count = law != nullptr ? law->count : 0;
  refuseIf(count > PolynomialSection::max_coefficients, "profile: polynomial has ", count, " coefficients, at most ",
           PolynomialSection::max_coefficients, " are allowed");
}

constexpr double origin_accuracy = 1e-9;  ///< of ParameterRange::origin [m]
constexpr int most_steps = 20;            ///< of its search

/// With several buckets for each section, most look-ups need no search.
constexpr std::size_t buckets_per_section = 4;
}  // namespace

double CurvePoint::curvature() const
{
  const double speed_squared = dy * dy + dz * dz;
  return (dy * ddz - dz * ddy) / (speed_squared * std::sqrt(speed_squared));
}

Profile::Profile(std::string name, const std::vector<ProfileSection>& sections) : Profile(std::move(name))
{
  refuseIf(sections.empty(), "profile: '" + name_ + "' has no sections");
  beginPart();
  for (const ProfileSection& section : sections)
  {
    checkSection(section);
    add(section);
  }
  makeBuckets();
  findOrigins();
}

void Profile::clear()
{
  law_.clear();
  error_.clear();
  parts_.clear();
  start_.assign(1, 0.0);
}

void Profile::beginPart()
{
  if (!parts_.empty())
  {
    const ParameterRange before = parts_.back();
    add({LineSection{}, part_distance});
    setContinuation(law_.size() - 1);
    parts_.back() = before;
  }
  parts_.push_back({length(), length()});
}

void Profile::add(const ProfileSection& section)
{
  law_.push_back(section.law);
  error_.push_back(section.error);
  start_.push_back(start_.back() + section.length);
  parts_.back().end = start_.back();
}

void Profile::setContinuation(std::size_t section)
{
  const double t = start_[section] - start_[section - 1];
  const CurvePoint end = std::visit([t](const auto& law) { return evaluate(law, t).point; }, law_[section - 1]);
  law_[section] = LineSection{end.y, end.z, end.dy, end.dz};
}

ProfileSection Profile::section(std::size_t index) const
{
  return {law_[index], start_[index + 1] - start_[index], error_[index]};
}

void Profile::makeBuckets()
{
  const std::size_t buckets = buckets_per_section * law_.size();
  buckets_per_metre_ = static_cast<double>(buckets) / length();
  bucket_.resize(buckets + 1);
  std::size_t section = 0;
  for (std::size_t k = 0; k <= buckets; ++k)
  {
    const double u = static_cast<double>(k) / buckets_per_metre_;
    while (section + 1 < law_.size() && start_[section + 1] <= u)
    {
      ++section;
    }
    bucket_[k] = section;
  }
}

/// In each part, starts at the nearest boundary of two sections, and moves along the tangent to the foot of the origin.
void Profile::findOrigins()
{
  for (ParameterRange& part : parts_)
  {
    double nearest = infinity;
    const auto first = std::lower_bound(start_.begin(), start_.end(), part.begin);
    const auto last = std::upper_bound(first, start_.end(), part.end);
    for (auto u = first; u != last; ++u)
    {
      const CurvePoint point = at(*u);
      if (const double distance = std::hypot(point.y, point.z); distance < nearest)
      {
        nearest = distance;
        part.origin = *u;
      }
    }
    for (int i = 0; i < most_steps; ++i)
    {
      const CurvePoint point = at(part.origin);
      const double step = -(point.y * point.dy + point.z * point.dz) / (point.dy * point.dy + point.dz * point.dz);
      part.origin = std::clamp(part.origin + step, part.begin, part.end);
      if (std::abs(step) < origin_accuracy)
      {
        break;
      }
    }
  }
}

ParameterRange Profile::partAt(double u) const
{
  const auto distance = [u](const ParameterRange& part) { return std::max({part.begin - u, u - part.end, 0.0}); };
  return *std::min_element(parts_.begin(), parts_.end(),
                           [&](const ParameterRange& one, const ParameterRange& other)
                           { return distance(one) < distance(other); });
}

std::size_t Profile::sectionAt(double u) const
{
  const double position = u * buckets_per_metre_;
  if (!(position > 0.0))
  {
    return 0;
  }
  const std::size_t last = bucket_.size() - 1;
  const std::size_t k = position < static_cast<double>(last) ? static_cast<std::size_t>(position) : last - 1;
  std::size_t section = bucket_[k];
  // By rounding of the bucket boundary, u may be just before the first section of its bucket.
  if (u < start_[section])
  {
    return section - 1;
  }
  const auto begin = start_.begin() + 1;
  using Offset = std::vector<double>::difference_type;
  const auto after =
      std::upper_bound(begin + static_cast<Offset>(section), begin + static_cast<Offset>(bucket_[k + 1]), u);
  return static_cast<std::size_t>(after - begin);
}

ShapeError Profile::errorWithin(double u_first, double u_last) const
{
  ShapeError largest;
  for (std::size_t i = sectionAt(u_first), last = sectionAt(u_last); i <= last; ++i)
  {
    largest.position = std::max(largest.position, error_[i].position);
    largest.curvature = std::max(largest.curvature, error_[i].curvature);
    largest.missing = largest.missing || error_[i].missing;
  }
  return largest;
}

CurvePoint Profile::at(double u) const
{
  const std::size_t section = sectionAt(u);
  const double t = u - start_[section];
  return std::visit([t](const auto& law) { return evaluate(law, t).point; }, law_[section]);
}

double Profile::speedAt(double u) const
{
  const std::size_t section = sectionAt(u);
  if (std::holds_alternative<ArcSection>(law_[section]))
  {
    return 1;
  }
  const double t = u - start_[section];
  const CurvePoint point = std::visit([t](const auto& law) { return evaluate(law, t).point; }, law_[section]);
  return std::sqrt(point.dy * point.dy + point.dz * point.dz);
}

void ProfileCursor::moveTo(double u)
{
  const std::vector<double>& start = profile_->start_;
  section_ = profile_->sectionAt(u);
  begin_ = section_ == 0 ? -infinity : start[section_];
  end_ = section_ + 2 == start.size() ? infinity : start[section_ + 1];
}

/// Moves to the parameter u. Returns its distance from the start of its section [m].
double ProfileCursor::offsetOf(double u)
{
  if (!(u >= begin_ && u < end_))
  {
    moveTo(u);
  }
  reach_ = std::min(u - begin_, end_ - u);
  return u - profile_->start_[section_];
}

CurvePoint ProfileCursor::at(double u)
{
  const double t = offsetOf(u);
  return std::visit([t](const auto& law) { return evaluate(law, t).point; }, profile_->law_[section_]);
}

CurveExpansion ProfileCursor::expansionAt(double u)
{
  const double t = offsetOf(u);
  return std::visit([t](const auto& law) { return evaluate(law, t); }, profile_->law_[section_]);
}
}  // namespace wheel_rail_contact::core
