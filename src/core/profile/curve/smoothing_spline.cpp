// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "core/constants.h"
#include "core/option_check.h"
#include "core/profile/curve/spline.h"

namespace wheel_rail_contact::core
{
namespace
{
using Column = std::vector<double>;

/// Number of uniform cubic B-splines that are non-zero in an interval.
constexpr std::size_t cover = 4;
constexpr double knot_distance = 0.5e-3;  ///< [m]
constexpr double group_length = 0.2e-3;   ///< of points that are averaged [m]
/// Coefficients of the third difference: one row of the penalty.
constexpr std::array<double, cover> third_difference = {-1.0, 3.0, -3.0, 1.0};
/// The penalty is multiplied by (reference_curvature / curvature)², with a curvature of at least least_curvature [1/m].
constexpr double least_curvature = 3.0;
constexpr double reference_curvature = 10.0;
/// Distance beyond the ends of a corner over which the penalty is also reduced [m].
constexpr double corner_reach = 2e-3;
/// Number of neighbouring points of a stretch. The curve leaves one with a kink: the mean square deviation of its
/// points is `kinked` times the target or more, which chance gives to one of 50 000 stretches.
constexpr std::size_t stretch = 10;
constexpr double kinked = 4;
constexpr double relief = 1e-2;          ///< factor of the penalty at such a stretch, in each round
constexpr int most_rounds = 3;           ///< of fits with less penalty there
constexpr double most_of_points = 0.25;  ///< share of such stretches above which the noise is not that of the points

std::array<double, cover> basis(double t)
{
  const double s = 1.0 - t;
  return {s * s * s / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0, (3.0 * s * s * s - 6.0 * s * s + 4.0) / 6.0,
          t * t * t / 6.0};
}

/// Least-squares fit of both coordinates by B-splines with a penalty.
class PenalisedFit
{
 public:
  explicit PenalisedFit(const std::vector<SampledPoint>& points)
  {
    const Column u = polygonLength(points);
    intervals_ = static_cast<std::size_t>(std::ceil(u.back() / knot_distance)) + 1;
    step_ = u.back() / static_cast<double>(intervals_);
    const std::size_t size = intervals_ + cover - 1;
    normal_.assign(size, {});
    right_y_.assign(size, 0.0);
    right_z_.assign(size, 0.0);
    relaxation_.assign(intervals_ - 1, 1.0);
    relief_ = relaxation_;
    double weights = 0;
    for (const SampledPoint& point : points)
    {
      weights += point.weight;
    }
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      Sample sample{std::min(static_cast<std::size_t>(u[i] / step_), intervals_ - 1), {}, points[i]};
      sample.basis = basis(u[i] / step_ - static_cast<double>(sample.interval));
      sample.point.weight *= static_cast<double>(points.size()) / weights;
      for (std::size_t a = 0; a < cover; ++a)
      {
        const std::size_t row = sample.interval + a;
        const double share = sample.point.weight * sample.basis[a];
        right_y_[row] += share * sample.point.y;
        right_z_[row] += share * sample.point.z;
        for (std::size_t b = a; b < cover; ++b)
        {
          normal_[row][b - a] += share * sample.basis[b];
        }
      }
      samples_.push_back(sample);
    }
  }

  /// Fits with the strongest penalty for which the weighted mean square deviation is at most `target` [m²]. Where the
  /// curve has a kink, the penalty is reduced, and the deviations do not count: they would make it vanish everywhere.
  void fitTo(double target)
  {
    relief_.assign(relief_.size(), 1.0);
    counts_.assign(samples_.size(), true);
    fitCounted(target);
    for (int round = 0; round < most_rounds && relieveKinks(target); ++round)
    {
      fitCounted(target);
    }
  }

  /// Adapts the penalty to the curvature of the present fit.
  void relaxAtCorners()
  {
    const std::size_t last = y_.size() - 2;
    const auto reach = static_cast<std::size_t>(std::ceil(corner_reach / step_));
    for (std::size_t row = 0; row < relaxation_.size(); ++row)
    {
      const std::size_t middle = row + 1;
      double sharpest = least_curvature;
      for (std::size_t i = middle > reach ? middle - reach : 1; i <= std::min(middle + 1 + reach, last); ++i)
      {
        sharpest = std::max(sharpest, std::abs(curvature(i)));
      }
      relaxation_[row] = (reference_curvature / sharpest) * (reference_curvature / sharpest);
    }
  }

  /// @param noise  standard deviation of the points [m], for the error of the curve
  std::vector<ProfileSection> sections(double noise) const
  {
    std::vector<ProfileSection> sections;
    for (std::size_t i = 0; i < intervals_; ++i)
    {
      CubicSection cubic{};
      const auto fill = [this, i](const Column& q, double* c)
      {
        c[0] = (q[i] + 4.0 * q[i + 1] + q[i + 2]) / 6.0;
        c[1] = (q[i + 2] - q[i]) / (2.0 * step_);
        c[2] = (q[i] - 2.0 * q[i + 1] + q[i + 2]) / (2.0 * step_ * step_);
        c[3] = (-q[i] + 3.0 * q[i + 1] - 3.0 * q[i + 2] + q[i + 3]) / (6.0 * step_ * step_ * step_);
      };
      fill(y_, cubic.y);
      fill(z_, cubic.z);
      sections.push_back({cubic, step_, errorOf(i, noise)});
    }
    return sections;
  }

 private:
  /// Lower triangle of a symmetric band matrix with three diagonals below the main one, by columns.
  using Band = std::vector<std::array<double, cover>>;

  struct Sample
  {
    std::size_t interval;
    std::array<double, cover> basis;
    SampledPoint point;  ///< weights scaled to the mean 1
  };

  void fitCounted(double target)
  {
    // Logarithms of a negligible and of a dominant penalty. The deviation increases with the penalty.
    double low = -15.0, high = 25.0;
    for (int halving = 0; halving < 30; ++halving)
    {
      const double middle = 0.5 * (low + high);
      fit(std::exp(middle));
      (meanSquare(0, samples_.size(), true) < target ? low : high) = middle;
    }
    fit(std::exp(low));
  }

  /// Reduces the penalty around stretches with a kink. @return false if there is none, or the noise is not that of the
  /// points
  bool relieveKinks(double target)
  {
    std::vector<std::size_t> found;
    std::size_t left_out = 0;
    for (std::size_t next = 0; next < samples_.size() && samples_.size() >= stretch; next += stretch)
    {
      const std::size_t first = std::min(next, samples_.size() - stretch);  // the last stretch ends with the curve
      const bool is_off = meanSquare(first, first + stretch, false) > kinked * target;
      left_out += is_off || !counts_[first] ? stretch : 0;
      if (is_off)
      {
        found.push_back(first);
      }
    }
    if (found.empty() || static_cast<double>(left_out) > most_of_points * static_cast<double>(samples_.size()))
    {
      return false;
    }
    const auto reach = static_cast<std::size_t>(std::ceil(corner_reach / step_));
    for (const std::size_t first : found)
    {
      const std::size_t begin = samples_[first].interval, end = samples_[first + stretch - 1].interval + reach;
      std::fill_n(counts_.begin() + static_cast<std::ptrdiff_t>(first), stretch, false);
      for (std::size_t row = begin - std::min(begin, reach); row < std::min(end, relief_.size()); ++row)
      {
        relief_[row] *= relief;
      }
    }
    return true;
  }

  void fit(double penalty)
  {
    Band band = normal_;
    for (std::size_t i = 0; i < relaxation_.size(); ++i)
    {
      for (std::size_t a = 0; a < cover; ++a)
      {
        for (std::size_t b = a; b < cover; ++b)
        {
          band[i + a][b - a] += penalty * relaxation_[i] * relief_[i] * third_difference[a] * third_difference[b];
        }
      }
    }
    factorise(band);
    y_ = solve(band, right_y_);
    z_ = solve(band, right_z_);
    factors_ = std::move(band);
  }

  /// Standard deviation of a linear combination of the coefficients of an interval, for noise of 1. The covariance is
  /// that of Wahba (Bayesian confidence intervals for the cross-validated smoothing spline, J. R. Statist. Soc. B 45,
  /// 1983): the inverse of the equations. It contains the bias of the smoothing.
  double deviationOf(const std::array<double, cover>& combination, std::size_t interval) const
  {
    Column right(y_.size(), 0.0);
    for (std::size_t a = 0; a < cover; ++a)
    {
      right[interval + a] = combination[a];
    }
    const Column x = solve(factors_, right);
    double variance = 0;
    for (std::size_t a = 0; a < cover; ++a)
    {
      variance += combination[a] * x[interval + a];
    }
    return std::sqrt(std::max(variance, 0.0));
  }

  /// Error of the curve in the middle of an interval: by noise, and by the smoothing of a change of curvature. The
  /// latter is taken as half the change over a quarter of the wavelength on either side that has both deviations: that
  /// is how far the smoothing reaches.
  ShapeError errorOf(std::size_t interval, double noise) const
  {
    constexpr double middle = 0.5;
    constexpr std::array<double, cover> second_derivative = {0.5, -0.5, -0.5, 0.5};  // there, times step²
    const double position = noise * deviationOf(basis(middle), interval);
    const double by_noise = noise * deviationOf(second_derivative, interval) / (step_ * step_);
    const double quarter = by_noise > 0 ? 0.5 * pi * std::sqrt(position / by_noise) : 0;
    const std::size_t last = y_.size() - 2, here = interval + 1;
    const auto reach = static_cast<std::size_t>(std::ceil(std::min(quarter / step_, static_cast<double>(last))));
    const double change = curvature(std::min(here + 1 + reach, last)) - curvature(here > reach ? here - reach : 1);
    return {position, std::hypot(by_noise, 0.5 * change), false};
  }

  /// Weighted mean square deviation of the points `first` to `end` (exclusive) [m²].
  /// @param only_counted  only of those that count
  double meanSquare(std::size_t first, std::size_t end, bool only_counted) const
  {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = first; i < end; ++i)
    {
      if (only_counted && !counts_[i])
      {
        continue;
      }
      ++count;
      const Sample& sample = samples_[i];
      double dy = -sample.point.y, dz = -sample.point.z;
      for (std::size_t a = 0; a < cover; ++a)
      {
        dy += sample.basis[a] * y_[sample.interval + a];
        dz += sample.basis[a] * z_[sample.interval + a];
      }
      sum += sample.point.weight * (dy * dy + dz * dz);
    }
    return sum / static_cast<double>(count);
  }

  /// Curvature at the middle of B-spline i [1/m], with i from 1 to the second-last.
  double curvature(std::size_t i) const
  {
    const double dy = 0.5 * (y_[i + 1] - y_[i - 1]);
    const double dz = 0.5 * (z_[i + 1] - z_[i - 1]);
    const double bend = dy * (z_[i + 1] - 2.0 * z_[i] + z_[i - 1]) - dz * (y_[i + 1] - 2.0 * y_[i] + y_[i - 1]);
    return bend / std::pow(dy * dy + dz * dz, 1.5);
  }

  static void factorise(Band& band)
  {
    for (std::size_t i = 0; i < band.size(); ++i)
    {
      const std::size_t below = std::min(cover, band.size() - i);
      std::array<double, cover> column = band[i];
      for (std::size_t a = 1; a < below; ++a)
      {
        band[i][a] = column[a] / column[0];
        for (std::size_t b = 1; b <= a; ++b)
        {
          band[i + b][a - b] -= band[i][a] * column[b];
        }
      }
    }
  }

  static Column solve(const Band& factors, Column x)
  {
    const auto below = [&](std::size_t i) { return std::min(cover, x.size() - i); };
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      for (std::size_t a = 1; a < below(i); ++a)
      {
        x[i + a] -= factors[i][a] * x[i];
      }
    }
    for (std::size_t i = x.size(); i-- > 0;)
    {
      x[i] /= factors[i][0];
      for (std::size_t a = 1; a < below(i); ++a)
      {
        x[i] -= factors[i][a] * x[i + a];
      }
    }
    return x;
  }

  std::vector<Sample> samples_;
  std::size_t intervals_ = 0;
  double step_ = 0;  ///< distance of the knots [m]
  Band normal_;      ///< normal matrix of the least squares, without penalty
  Column right_y_, right_z_;
  Column relaxation_, relief_;  ///< factors of the penalty in each row, by the curvature and at kinks [-]
  std::vector<bool> counts_;    ///< of each point: false at a kink
  Column y_, z_;                ///< coefficients [m]
  Band factors_;                ///< of the equations of the last fit
};

/// Largest distance of the curve from the polygon through the points, at the points and in the middle between them,
/// over what is plausible there: a share of the distance of the points.
double excess(const std::vector<ProfileSection>& sections, const std::vector<SampledPoint>& points, double noise)
{
  constexpr double share = 0.3, times_noise = 20, least = 1e-5;  // arcs rise less between points; [-, -, m]
  const Profile curve("", sections);
  const Column u = polygonLength(points);
  double largest = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    const CurvePoint p = curve.at(0.5 * (u[i] + u[i + 1]));
    const double y = 0.5 * (points[i].y + points[i + 1].y), z = 0.5 * (points[i].z + points[i + 1].z);
    const double plausible = share * (u[i + 1] - u[i]) + times_noise * noise + least;
    largest = std::max(largest, std::hypot(p.y - y, p.z - z) / plausible);
  }
  return largest;
}
}  // namespace

std::vector<SampledPoint> groupedPoints(const std::vector<SampledPoint>& points)
{
  std::vector<SampledPoint> means;
  for (std::size_t i = 0; i < points.size();)
  {
    SampledPoint sum{0, 0, 0};
    const SampledPoint& first = points[i];
    for (; i < points.size() && distance(first, points[i]) < group_length; ++i)
    {
      sum.y += points[i].weight * points[i].y;
      sum.z += points[i].weight * points[i].z;
      sum.weight += points[i].weight;
    }
    means.push_back({sum.y / sum.weight, sum.z / sum.weight, sum.weight});
  }
  return means;
}

std::vector<ProfileSection> smoothingSpline(const std::vector<SampledPoint>& points, double noise)
{
  refuseIf(!(noise > 0.0 && noise <= max_spline_noise), "profile spline: noise is " + std::to_string(noise * 1e6) +
                                                            " um, must be above 0 and at most " +
                                                            std::to_string(max_spline_noise * 1e6) + " um");
  PenalisedFit fit(points);
  fit.fitTo(noise * noise);
  fit.relaxAtCorners();
  fit.fitTo(noise * noise);
  std::vector<ProfileSection> sections = fit.sections(noise);
  refuseIf(!(excess(sections, points, noise) <= 1), "profile spline: the curve leaves the points: their noise is not " +
                                                        std::to_string(noise * 1e6) + " um, or points are missing");
  return sections;
}
}  // namespace wheel_rail_contact::core
