// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/constants.h"
#include "core/normal/operator/operator_cache.h"
#include "problems.h"

/// Random contacts defined by the gap of two bodies, for tests and for the calibration of error estimates.
namespace wheel_rail_contact::core::scenes
{
using Random = std::mt19937_64;

using problems::uniform;

/// Random number, uniform in the logarithm.
inline double spread(Random& random, double low, double high)
{
  return std::exp(uniform(random, std::log(low), std::log(high)));
}

inline bool oneIn(Random& random, unsigned n)
{
  return random() % n == 0;
}

/// Gap of a patch at (x, y) [m].
using Gap = std::function<double(double, double)>;

/// One or several patches under a common load.
struct GapScene
{
  bool even = true;  ///< even in x
  std::vector<Gap> patches;
  double load = 0;  ///< [N]
};

/// Hertz gap, with ellipses from about 1:10 to 10:1.
inline Gap hertzGap(Random& random)
{
  const double along = 0.5 / spread(random, 0.1, 1), across = along * std::exp(uniform(random, -3.5, 3.5));
  return [=](double x, double y) { return along * x * x + across * y * y; };
}

/// Curve with piecewise constant second derivative; value and slope are zero at y = 0.
class ArcCurve
{
 public:
  /// `curvature[i]` applies up to `discontinuity[i]` (increasing), the last one beyond all of them.
  ArcCurve(std::vector<double> discontinuity, std::vector<double> curvature)
      : discontinuity_(std::move(discontinuity)), curvature_(std::move(curvature))
  {
  }
  double operator()(double y) const { return y >= 0 ? walk(y, 1) : walk(-y, -1); }

 private:
  double curvatureAt(double y) const
  {
    const auto piece = std::upper_bound(discontinuity_.begin(), discontinuity_.end(), y) - discontinuity_.begin();
    return curvature_[static_cast<std::size_t>(piece)];
  }
  double walk(double distance, double side) const
  {
    double value = 0, slope = 0, at = 0;
    while (at < distance)
    {
      double next = distance;
      for (const double discontinuity : discontinuity_)
      {
        next = side * discontinuity > at ? std::min(next, side * discontinuity) : next;
      }
      const double length = next - at, second = curvatureAt(0.5 * side * (at + next));
      value += slope * length + 0.5 * second * length * length;
      slope += second * length;
      at = next;
    }
    return value;
  }
  std::vector<double> discontinuity_, curvature_;
};

/// Rail head with arcs of 300, 80 and 13 mm under a wheel with a curvature discontinuity.
inline Gap discontinuityGap(Random& random)
{
  const double contact = uniform(random, 0, 0.030), wheel_discontinuity = uniform(random, -6e-3, 6e-3);
  const double wheel = oneIn(random, 3) ? -1 / uniform(random, 0.310, 2) : uniform(random, -1 / 0.400, 1 / 0.350);
  const double wheel_beyond = oneIn(random, 2) ? uniform(random, -1 / 0.090, 1 / 0.100) : wheel;
  std::vector<double> discontinuities{-0.01023 - contact, 0.01023 - contact, 0.02603 - contact, wheel_discontinuity};
  std::sort(discontinuities.begin(), discontinuities.end());
  std::vector<double> curvatures;
  for (std::size_t i = 0; i <= discontinuities.size(); ++i)
  {
    const double y = i == discontinuities.size() ? discontinuities.back() + 1e-3
                     : i == 0                    ? discontinuities[0] - 1e-3
                                                 : 0.5 * (discontinuities[i - 1] + discontinuities[i]);
    const double from_crown = std::abs(contact + y);
    const double rail = from_crown < 0.01023 ? 1 / 0.300 : from_crown < 0.02603 ? 1 / 0.080 : 1 / 0.013;
    curvatures.push_back(std::max(rail + (y > wheel_discontinuity ? wheel_beyond : wheel), 0.3));
  }
  const double along = 0.5 / uniform(random, 0.3, 0.6);
  const ArcCurve curve(discontinuities, curvatures);
  return [=](double x, double y) { return along * x * x + curve(y); };
}

/// Two adjacent minima, from merged to almost separate.
inline Gap lobesGap(Random& random)
{
  const double along = 0.5 / uniform(random, 0.3, 0.6), half = uniform(random, 2e-3, 8e-3);
  const double depth = spread(random, 1e-6, 6e-5), tilt = uniform(random, -0.5, 0.5) * depth / half;
  return [=](double x, double y)
  {
    const double q = y / half, well = q * q - 1;
    return along * x * x + depth * well * well / (1 + 0.1 * q * q) + tilt * y;
  };
}

/// Arc of 13 mm in a slightly wider one.
inline Gap conformalGap(Random& random)
{
  const double along = 0.5 / uniform(random, 0.3, 0.6), inner = 0.013, outer = inner * (1 + spread(random, 0.01, 0.3));
  constexpr double reach = 0.0125;
  return [=](double x, double y)
  {
    const double t = std::min(std::abs(y), reach), beyond = std::max(std::abs(y) - reach, 0.0);
    const double inner_drop = inner - std::sqrt(inner * inner - t * t);
    const double outer_drop = outer - std::sqrt(outer * outer - t * t);
    return along * x * x + inner_drop - outer_drop + 5e4 * beyond * beyond;
  };
}

/// Parabola with up to five waves across, of 1 to 10 mm length.
inline Gap roughGap(Random& random)
{
  struct Wave
  {
    double number, height, phase;
  };
  const double along = 0.5 / uniform(random, 0.3, 0.6), across = spread(random, 0.5, 10);
  const double level = spread(random, 0.05, 1.5);
  std::vector<Wave> waves(1 + random() % 5);
  for (Wave& wave : waves)
  {
    const double length = spread(random, 1e-3, 1e-2);
    wave.number = 2 * pi / length;
    wave.height = level * across * length * length / (2 * pi * pi) * uniform(random, 0.2, 1);
    wave.phase = uniform(random, 0, 2 * pi);
  }
  return [=](double x, double y)
  {
    double gap = along * x * x + across * y * y;
    for (const Wave& wave : waves)
    {
      gap += wave.height * std::cos(wave.number * y + wave.phase);
    }
    return gap;
  };
}

/// The same contact as under a yawed wheel: not even in x, and different in each column.
inline Gap yawed(Random& random, const Gap& gap)
{
  const double turn = uniform(random, -0.1, 0.1), taper = uniform(random, -3, 3);
  return [=](double x, double y) { return gap(x + turn * y, y) * (1 + taper * x); };
}

inline GapScene randomGapScene(Random& random)
{
  static constexpr std::array<Gap (*)(Random&), 5> kinds{hertzGap, discontinuityGap, lobesGap, conformalGap, roughGap};
  const auto make = kinds[random() % kinds.size()];
  GapScene scene{!oneIn(random, 3), {make(random)}, 1e3 * spread(random, 5, 150)};
  if (oneIn(random, 6))
  {
    const Gap second = kinds[random() % 2](random);
    const double further = spread(random, 2e-6, 4e-5);
    scene.patches.push_back([=](double x, double y) { return second(x, y) + further; });
  }
  if (!scene.even)
  {
    for (Gap& gap : scene.patches)
    {
      gap = yawed(random, gap);
    }
  }
  return scene;
}

/// Paraboloid with an additional shape, from almost nothing to a third of the approach at the edge of the contact:
/// curvatures that vary along and across, and a curvature jump. Without symmetry it is also rotated.
inline GapScene randomBowlScene(Random& random)
{
  constexpr double modulus = 1.14e11;  // steel on steel [Pa]
  const double load = 1e3 * spread(random, 5, 150);
  const double along = 0.5 / spread(random, 0.1, 1), across = along * std::exp(uniform(random, -3, 3));
  const HertzContact contact = hertzForForce({along, across}, modulus, load);
  const double height = spread(random, 1e-4, 0.3) * contact.approach;
  const bool even = !oneIn(random, 3);
  std::array<double, 4> share{};
  std::generate(share.begin(), share.end(), [&] { return height * uniform(random, -1, 1); });
  const double discontinuity = uniform(random, -1, 1), turn = even ? 0 : uniform(random, -0.5, 0.5);
  const auto gap = [=](double x, double y)
  {
    const double turned_x = std::cos(turn) * x + std::sin(turn) * y, turned_y = std::cos(turn) * y - std::sin(turn) * x;
    const double u = turned_x / contact.semi_axis_x, v = turned_y / contact.semi_axis_y,
                 over = std::max(v - discontinuity, 0.0);
    const double other =
        share[0] * v * v * v + share[1] * v * v * v * v + share[2] * u * u * v + share[3] * over * over;
    return along * turned_x * turned_x + across * turned_y * turned_y + other;
  };
  return {even, {gap}, load};
}

/// The same box with cells `factor` times smaller in each direction.
inline Grid refined(const Grid& grid, int factor)
{
  Grid fine = grid;
  fine.nx *= factor;
  fine.ny *= factor;
  fine.dx /= factor;
  fine.dy /= factor;
  fine.y0 = grid.y0 - 0.5 * grid.dy + 0.5 * fine.dy;
  return fine;
}
}  // namespace wheel_rail_contact::core::scenes
