// SPDX-License-Identifier: BSD-3-Clause
#include "core/stress/point_forces.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wheel_rail_contact::core
{
namespace
{
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
    EXPECT_NEAR(sums.one[k], one, 1e-5 * one);
    EXPECT_NEAR(sums.x[k], x_sum, 1e-5 * one);
    EXPECT_NEAR(sums.y[k], y_sum, 1e-5 * one);
    EXPECT_NEAR(sums.xx[k], xx, 1e-5 * one);
    EXPECT_NEAR(sums.xy[k], xy, 1e-5 * one);
    EXPECT_NEAR(sums.yy[k], yy, 1e-5 * one);
    EXPECT_NEAR(sums.chi_xx[k], chi_xx, 1e-5 * one);
    EXPECT_NEAR(sums.chi_yy[k], chi_yy, 1e-5 * one);
    EXPECT_NEAR(sums.chi_xy[k], chi_xy, 1e-5 * one);
  }
}

INSTANTIATE_TEST_SUITE_P(Supported, PointForceLoop, testing::ValuesIn(supportedPointForceKernels()),
                         [](const auto& instance) { return std::string(instance.param->name); });
}  // namespace
}  // namespace wheel_rail_contact::core
