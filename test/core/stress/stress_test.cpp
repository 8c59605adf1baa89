// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/stress.h"

#include <Eigen/Eigenvalues>

#include "../../seeded.h"
#include "core/normal/operator/influence.h"
#include "core/stress/point_sources.h"
#include "core/stress/stress_search.h"
#include "pressures.h"

using namespace wheel_rail_contact::core;

TEST(Stress, OfUniaxialShearAndHydrostaticStates)
{
  EXPECT_DOUBLE_EQ(vonMises({5, 0, 0, 0, 0, 0}), 5);
  EXPECT_DOUBLE_EQ(vonMises({0, 0, 0, 0, 2, 0}), 2 * std::sqrt(3.0));
  EXPECT_NEAR(vonMises({-7, -7, -7, 0, 0, 0}), 0, 1e-14);
  for (const double principal : principalStresses({-3, -3, -3, 0, 0, 0}))
  {
    EXPECT_DOUBLE_EQ(principal, -3);
  }
  EXPECT_DOUBLE_EQ(maxShear({-3, -3, -3, 0, 0, 0}), 0);
}

TEST(Stress, PrincipalStressesAreTheEigenvaluesOfTheTensor)
{
  Seeded random(std::random_device{}());
  for (int k = 0; k < 200; ++k)
  {
    const Stress s{random.unit(), random.unit(), random.unit(), random.unit(), random.unit(), random.unit()};
    Eigen::Matrix3d tensor;
    tensor << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, s.zz;
    const Eigen::Vector3d expected = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tensor).eigenvalues();
    const std::array<double, 3> found = principalStresses(s);
    for (std::size_t i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(found[i], expected[2 - static_cast<Eigen::Index>(i)], 1e-7);  // rounding where two are close
    }
    EXPECT_NEAR(maxShear(s), 0.5 * (expected[2] - expected[0]), 1e-7);
  }
}

TEST(Stress, StrainFollowsHookesLaw)
{
  const Material steel{2e11, 0.3, 0};
  const Strain pulled = strainOf({4e8, 0, 0, 0, 0, 0}, steel);
  EXPECT_DOUBLE_EQ(pulled.xx, 2e-3);
  EXPECT_DOUBLE_EQ(pulled.yy, -0.6e-3);
  const Strain sheared = strainOf({0, 0, 0, 0, 1e8, 0}, steel);
  EXPECT_DOUBLE_EQ(sheared.xz, 1e8 * 1.3 / 2e11);  // half of tau / G
  EXPECT_THROW(strainOf({}, Material{-1, 0.3, 0}), std::invalid_argument);
}

TEST(Stress, ConfigurationIsChecked)
{
  EXPECT_NO_THROW(validate(StressConfig{0, false}));
  EXPECT_NO_THROW(validate(StressConfig{4, true}));
  EXPECT_THROW(validate(StressConfig{3, false}), std::invalid_argument);
  EXPECT_THROW(validate(StressConfig{65, false}), std::invalid_argument);
  EXPECT_THROW(validate(StressConfig{0, true}), std::invalid_argument);
}

using pressures::Cells;

void expectNear(const Stress& one, const Stress& other, double tolerance)
{
  for (const auto component : {&Stress::xx, &Stress::yy, &Stress::zz, &Stress::yz, &Stress::xz, &Stress::xy})
  {
    EXPECT_NEAR(one.*component, other.*component, tolerance);
  }
}

TEST(StressLayers, EqualTheSumOfAllCells)
{
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  for (const auto& [nx, ny] : {std::pair{8, 6}, std::pair{5, 7}, std::pair{1, 4}, std::pair{6, 1}})
  {
    const Cells cells = pressures::random(nx, ny, seed);
    const std::vector<double> depths{0, 0.2, 3};
    const std::vector<StressLayer> layers = stressLayers(cells.grid, cells.pressure, 0.28, depths);
    ASSERT_EQ(layers.size(), depths.size());
    for (const StressLayer& layer : layers)
    {
      for (int j = 0; j < ny; ++j)
      {
        for (int i = 0; i < nx; ++i)
        {
          const Eigen::Vector3d place(cells.grid.x(i), cells.grid.y(j), layer.depth);
          expectNear(layer.at(i, j), stressAt(cells.grid, cells.pressure, 0.28, place), 1e-13);
        }
      }
    }
  }
}

namespace
{
constexpr double nu = 0.3;

Stress below(const Cells& cells, double x, double y, double z)
{
  return stressAt(cells.grid, cells.pressure, nu, {x, y, z});
}

// Johnson 1985, eq. 3.45 (with 3.42 for the radial stress). Cells of a sixtieth of the diameter change the stress by
// 0.03 %.
TEST(StressAt, AxisOfACircularHertzContact)
{
  const Cells cells = pressures::hertz(64, 64, 1, 1);
  double highest = 0, depth = 0;
  for (double z = 0.1; z < 3; z += 0.01)
  {
    const Stress stress = below(cells, 0, 0, z);
    const double radial = -(1 + nu) * (1 - z * std::atan(1 / z)) + 0.5 / (1 + z * z);
    EXPECT_NEAR(stress.zz, -1 / (1 + z * z), 1e-3) << z;
    EXPECT_NEAR(stress.xx, radial, 1e-3) << z;
    EXPECT_NEAR(stress.yy, radial, 1e-3) << z;
    depth = maxShear(stress) > highest ? z : depth;
    highest = std::max(highest, maxShear(stress));
  }
  EXPECT_NEAR(highest, 0.3100, 3e-4);  // 0.31 p0 at 0.48 a (Johnson 1985, sec. 3.4)
  EXPECT_NEAR(depth, 0.48, 0.011);
}

// Johnson 1985, eq. 4.45 and 4.46. The contact is 4000 half-widths long; in its middle the strain along it is zero.
TEST(StressAt, AxisOfALineContact)
{
  Cells cells{pressures::centredGrid(1, 128, 4000, 2.2), Eigen::ArrayXXd::Zero(1, 128)};
  for (int j = 0; j < 128; ++j)
  {
    const auto primitive = [](double y)
    {
      const double u = std::max(-1.0, std::min(1.0, y));
      return 0.5 * (u * std::sqrt(1 - u * u) + std::asin(u));
    };
    const double y = cells.grid.y(j), half = 0.5 * cells.grid.dy;
    cells.pressure(0, j) = (primitive(y + half) - primitive(y - half)) / cells.grid.dy;
  }
  double highest = 0, depth = 0;
  for (double z = 0.1; z < 3; z += 0.01)
  {
    const Stress stress = below(cells, 0, 0, z);
    const double root = std::sqrt(1 + z * z), across = -((1 + 2 * z * z) / root - 2 * z), normal = -1 / root;
    EXPECT_NEAR(stress.yy, across, 1e-3) << z;
    EXPECT_NEAR(stress.zz, normal, 1e-3) << z;
    EXPECT_NEAR(stress.xx, nu * (across + normal), 1e-3) << z;
    depth = maxShear(stress) > highest ? z : depth;
    highest = std::max(highest, maxShear(stress));
  }
  EXPECT_NEAR(highest, 0.3003, 3e-4);  // 0.30 p0 at 0.78 b
  EXPECT_NEAR(depth, 0.786, 0.011);
}

TEST(StressAt, SurfaceCarriesThePressureAndNoShear)
{
  const Cells cells = pressures::random(5, 4, 1);
  for (int j = 0; j < 4; ++j)
  {
    for (int i = 0; i < 5; ++i)
    {
      const Stress stress = below(cells, cells.grid.x(i), cells.grid.y(j), 0);
      EXPECT_NEAR(stress.zz, -cells.pressure(i, j), 1e-14);
      EXPECT_NEAR(stress.xz, 0, 1e-14);
      EXPECT_NEAR(stress.yz, 0, 1e-14);
    }
  }
  const Stress outside = below(cells, 9, 8, 0);
  EXPECT_NEAR(outside.zz, 0, 1e-14);
  EXPECT_NEAR(outside.xx + outside.yy, 0, 1e-14);  // free of dilatation
}

TEST(StressAt, ForcesAreInEquilibrium)
{
  const unsigned seed = std::random_device{}();
  const Cells cells = pressures::random(6, 7, seed);
  Seeded random(seed);
  constexpr double h = 1e-4;
  for (int k = 0; k < 50; ++k)
  {
    const Eigen::Vector3d at(random.within(-5, 5), random.within(-5, 5), random.within(0.3, 4));
    const auto slope = [&](int axis, double Stress::*component)
    {
      Eigen::Vector3d step = Eigen::Vector3d::Zero();
      step[axis] = h;
      const Stress after = stressAt(cells.grid, cells.pressure, nu, at + step);
      const Stress before = stressAt(cells.grid, cells.pressure, nu, at - step);
      return (after.*component - before.*component) / (2 * h);
    };
    // The largest derivatives are about 1; the difference quotient has an error of h² times the third ones.
    EXPECT_NEAR(slope(0, &Stress::xx) + slope(1, &Stress::xy) + slope(2, &Stress::xz), 0, 1e-6);
    EXPECT_NEAR(slope(0, &Stress::xy) + slope(1, &Stress::yy) + slope(2, &Stress::yz), 0, 1e-6);
    EXPECT_NEAR(slope(0, &Stress::xz) + slope(1, &Stress::yz) + slope(2, &Stress::zz), 0, 1e-6);
  }
}

// The strain along the depth, summed to infinity, is the displacement of the surface by the influence coefficients.
TEST(StressAt, StrainAgreesWithTheDisplacementOfTheSurface)
{
  const Material steel{2e11, nu, 0};
  const Cells cell{pressures::centredGrid(1, 1, 1.5, 0.8), Eigen::ArrayXXd::Constant(1, 1, 1e9)};
  const double x = 0.4, y = 1.1;
  double sum = 0;
  constexpr int steps = 4000;
  for (int k = 0; k < steps; ++k)  // z = t / (1 - t)
  {
    const double t = (k + 0.5) / steps, z = t / (1 - t);
    sum += strainOf(stressAt(cell.grid, cell.pressure, nu, {x, y, z}), steel).zz / ((1 - t) * (1 - t) * steps);
  }
  const double displacement = 1e9 * (1 - nu * nu) / (M_PI * steel.young) * rectangleInfluence(x, y, 1.5, 0.8);
  EXPECT_NEAR(-sum, displacement, 1e-5 * displacement);
}

TEST(StressAt, FarAwayItIsThatOfAPointForce)
{
  const Cells cell{pressures::centredGrid(1, 1, 0.02, 0.01), Eigen::ArrayXXd::Constant(1, 1, 1 / 2e-4)};
  const double x = 1.2, y = -0.7, z = 0.9, r = std::sqrt(x * x + y * y + z * z);
  const Stress stress = below(cell, x, y, z);
  const double factor = -3 * z / (2 * M_PI * std::pow(r, 5));  // Johnson 1985, eq. 3.20
  EXPECT_NEAR(stress.zz, factor * z * z, 1e-4 * std::abs(factor));
  EXPECT_NEAR(stress.xz, factor * x * z, 1e-4 * std::abs(factor));
  EXPECT_NEAR(stress.yz, factor * y * z, 1e-4 * std::abs(factor));
}

TEST(StressAt, RejectsWrongInputAndTheShearStressAtACornerOfTheSurface)
{
  const Cells cells = pressures::random(3, 2, 1);
  EXPECT_THROW(stressAt(cells.grid, Eigen::ArrayXXd::Zero(2, 3), nu, {0, 0, 1}), std::invalid_argument);
  EXPECT_THROW(stressAt(cells.grid, cells.pressure, 0.6, {0, 0, 1}), std::invalid_argument);
  EXPECT_THROW(below(cells, 0, 0, -1e-9), std::invalid_argument);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(below(cells, 0, 0, nan), std::invalid_argument);
  EXPECT_THROW(below(cells, nan, 0, 1), std::invalid_argument);
  EXPECT_THROW(below(cells, 0, nan, 1), std::invalid_argument);
  EXPECT_THROW(stressAt(cells.grid, nan * cells.pressure, nu, {0, 0, 1}), std::invalid_argument);
  EXPECT_THROW(stressLayers(cells.grid, cells.pressure, 0.28, {0.1, -0.1}), std::invalid_argument);
  const double x = cells.grid.x(1) - 0.5 * cells.grid.dx, y = cells.grid.y(1) - 0.5 * cells.grid.dy;
  EXPECT_THROW(below(cells, x, y, 0), std::invalid_argument);
  EXPECT_TRUE(std::isfinite(below(cells, x, y, 1e-12).xy));
}

double alternating(const Stress& stress)
{
  return std::abs(stress.xz);
}

/// Highest value of a measure in layers below all cells.
double highestInLayers(const Cells& cells, double unit, double (*measure)(const Stress&))
{
  std::vector<double> depths;
  for (int k = 1; k <= 30; ++k)
  {
    depths.push_back(0.05 * k * unit);
  }
  double highest = 0;
  for (const StressLayer& layer : stressLayers(cells.grid, cells.pressure, 0.3, depths))
  {
    for (Eigen::Index k = 0; k < cells.pressure.size(); ++k)
    {
      highest = std::max(highest, measure(layer.at(k % cells.grid.nx, k / cells.grid.nx)));
    }
  }
  return highest;
}

HighestStresses search(const Cells& cells, const SemiAxes& axes)
{
  StressSearch search;
  search.set(cells.grid, cells.pressure, {0, cells.grid.ny}, axes);
  return search.find(0.3);
}

// The depths of the maxima are those of Johnson 1985, sec. 3.4 and 4.2. On 12 × 24 cells the pressure itself has errors
// of 0.5 %; |xz| lies near the ends of the contact, which the cells resolve less.
TEST(StressSearch, FindsTheMaximaBelowEllipsesOfHertz)
{
  for (const double ratio : {0.25, 0.5, 1.0, 2.0, 4.0})
  {
    const double a = ratio, b = 1, unit = std::min(a, b);
    const Cells fine = pressures::hertz(64, 64, a, b);
    const double von_mises = highestInLayers(fine, unit, vonMises), shear = highestInLayers(fine, unit, maxShear);
    const double orthogonal = highestInLayers(fine, unit, alternating);
    for (const auto& [nx, ny] : {std::pair{12, 24}, std::pair{16, 32}, std::pair{32, 96}})
    {
      const Cells cells = pressures::hertz(nx, ny, a, b);
      const HighestStresses highest = search(cells, {a, b});
      const Stress there = below(cells, highest.von_mises.x, highest.von_mises.y, highest.von_mises.depth);
      EXPECT_NEAR(highest.von_mises.value, vonMises(there), 1e-3 * von_mises) << ratio << " " << nx;
      EXPECT_NEAR(highest.von_mises.value, von_mises, 0.01 * von_mises) << ratio << " " << nx;
      EXPECT_NEAR(highest.shear.value, shear, 0.01 * shear) << ratio << " " << nx;
      EXPECT_NEAR(highest.orthogonal.value, orthogonal, 0.04 * orthogonal) << ratio << " " << nx;
      EXPECT_NEAR(highest.von_mises.x, 0, 0.03 * a);
      EXPECT_NEAR(highest.von_mises.y, 0, 0.03 * b);
    }
  }
  const HighestStresses round = search(pressures::hertz(32, 32, 1, 1), {1, 1});
  EXPECT_NEAR(round.von_mises.depth, 0.48, 0.02);
  EXPECT_NEAR(round.shear.depth, 0.48, 0.02);
  EXPECT_NEAR(1 / round.orthogonal.value, 4.68, 0.05);
}

// A narrow peak of the pressure beside a wide contact, as below an edge of a worn profile.
TEST(StressSearch, FindsANarrowPeakOffTheCentre)
{
  Cells cells = pressures::hertz(48, 96, 1, 2);
  for (int j = 0; j < cells.grid.ny; ++j)
  {
    const double distance = (cells.grid.y(j) - 1.3) / 0.15;
    cells.pressure.col(j) *= 1 + 2 * std::exp(-distance * distance);
  }
  const double von_mises = highestInLayers(cells, 1, vonMises);
  const HighestStresses highest = search(cells, {1, 2});
  EXPECT_NEAR(highest.von_mises.value, von_mises, 0.03 * von_mises);
  EXPECT_NEAR(highest.von_mises.y, 1.3, 0.05);
}

TEST(StressSearch, ColumnsOfOtherPatchesAreNotSearched)
{
  Cells cells = pressures::hertz(16, 32, 1, 1);
  cells.pressure.rightCols(16) *= 0.1;
  StressSearch search;
  search.set(cells.grid, cells.pressure, {16, 16}, {1, 0.5});
  const HighestStresses right = search.find(0.3);
  search.set(cells.grid, cells.pressure, {0, 16}, {1, 0.5});
  EXPECT_LT(right.von_mises.value, search.find(0.3).von_mises.value);
}

// At a depth of 2.5 distances of the forces, all six components off the axes. The cells of stressAt() have steps of the
// pressure, the forces do not: 0.3 % of the highest pressure on 32 × 32 cells.
TEST(PointSources, AgreeWithTheSumOfAllCells)
{
  const pressures::Cells cells = pressures::hertz(32, 32, 1, 1.5);
  PointSources sources;
  sources.set(cells.grid, cells.pressure, 2, 0.1, {});  // lengths in units of 2
  PointSources::Places places;
  for (std::size_t k = 0; k < point_batch; ++k)
  {
    places.x[k] = 0.1F * static_cast<float>(k % 4) - 0.2F;
    places.y[k] = 0.15F * static_cast<float>(k / 4) - 0.1F;
    places.depth[k] = 0.25F + 0.02F * static_cast<float>(k);
  }
  const std::array<Stress, point_batch> stresses = sources.at(places, 0.3);
  for (std::size_t k = 0; k < point_batch; ++k)
  {
    const Stress expected =
        stressAt(cells.grid, cells.pressure, 0.3, {2.0 * places.x[k], 2.0 * places.y[k], 2.0 * places.depth[k]});
    expectNear(stresses[k], expected, 3e-3);
  }
}

/// Parameter: each instruction set that this machine supports.
class PointForceLoop : public testing::TestWithParam<const PointForceKernels*>
{
};

TEST_P(PointForceLoop, SumsEqualThoseInDoublePrecision)
{
  const std::array<float, 3> x{0.1F, -0.4F, 1.3F}, y{0.2F, 0.9F, -0.7F}, force{1.5F, 0.3F, 2.0F};
  PointsBelow points;
  for (std::size_t k = 0; k < point_batch; ++k)
  {
    points.x[k] = 0.1F * static_cast<float>(k) - 0.8F;
    points.y[k] = 0.3F;
    points.depth[k] = 0.2F + 0.1F * static_cast<float>(k);
  }
  PointForceSums sums;
  GetParam()->sums({x.data(), y.data(), force.data(), x.size()}, points, sums);
  for (std::size_t k = 0; k < point_batch; ++k)
  {
    double one = 0, x_sum = 0, y_sum = 0, xx = 0, xy = 0, yy = 0, chi_xx = 0, chi_xy = 0, chi_yy = 0;
    for (std::size_t f = 0; f < x.size(); ++f)
    {
      const double dx = points.x[k] - x[f], dy = points.y[k] - y[f], z = points.depth[k];
      const double r = std::sqrt(dx * dx + dy * dy + z * z), turned = (2 * r + z) / (r * r * r * (r + z) * (r + z));
      one += force[f] / std::pow(r, 5);
      x_sum += force[f] * dx / std::pow(r, 5);
      y_sum += force[f] * dy / std::pow(r, 5);
      xx += force[f] * dx * dx / std::pow(r, 5);
      xy += force[f] * dx * dy / std::pow(r, 5);
      yy += force[f] * dy * dy / std::pow(r, 5);
      chi_xx += force[f] * (1 / (r * (r + z)) - dx * dx * turned);
      chi_yy += force[f] * (1 / (r * (r + z)) - dy * dy * turned);
      chi_xy -= force[f] * dx * dy * turned;
    }
    const std::pair<double, double> found_and_expected[] = {
        {sums.one[k], one},       {sums.x[k], x_sum},       {sums.y[k], y_sum},
        {sums.xx[k], xx},         {sums.xy[k], xy},         {sums.yy[k], yy},
        {sums.chi_xx[k], chi_xx}, {sums.chi_yy[k], chi_yy}, {sums.chi_xy[k], chi_xy}};
    for (const auto& [found, expected] : found_and_expected)
    {
      EXPECT_NEAR(found, expected, 1e-5 * one);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Supported, PointForceLoop, testing::ValuesIn(supportedPointForceKernels()),
                         [](const auto& instance) { return std::string(instance.param->name); });
}  // namespace
