// SPDX-License-Identifier: BSD-3-Clause
// Derivatives of a result, against central differences of results.
#include "../../seeded.h"
#include "wheelset_scene.h"

namespace wheel_rail_contact::core
{
namespace
{
using Six = Eigen::Matrix<double, 6, 1>;
using Table = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// A grid so fine that it adds no ripple to the differences.
ContactModelConfig derivedScene(bool bends, WheelsetConfig::Balance balance)
{
  ContactModelConfig config = bends ? onPads(softPads()) : manchesterScene();
  config.contact = {NormalMethod::conjugate_gradient, 1e-6, 64, 128};
  config.contact.derivatives = true;
  config.wheelset.balance = balance;
  return config;
}

Six wrenchOf(const WheelsetResult& result)
{
  return (Six() << result.rail_wrench.force, result.rail_wrench.moment).finished();
}

Six solutionOf(const WheelsetResult& result)
{
  const Sides<WheelForces>& wheel = result.wheel;
  return (Six() << result.z, result.roll, wheel.left.vertical, wheel.left.lateral, wheel.right.vertical,
          wheel.right.lateral)
      .finished();
}

/// A value of a state, and its change for a difference.
struct Varied
{
  double& (*of)(WheelsetState&);
  double step;
};

template <typename Get>
Table differences(WheelsetContact& contact, const WheelsetState& state, const std::vector<Varied>& columns,
                  const Get& get)
{
  Table table(6, columns.size());
  for (std::size_t column = 0; column < columns.size(); ++column)
  {
    const auto& [of, step] = columns[column];
    WheelsetState ahead = state, behind = state;
    of(ahead) += step;
    of(behind) -= step;
    const Six after = get(okResult(contact, ahead));
    table.col(static_cast<Eigen::Index>(column)) = (after - get(okResult(contact, behind))) / (2 * step);
  }
  return table;
}

/// Largest difference of each column over its largest entry [-].
Eigen::RowVectorXd errors(const Eigen::Ref<const Eigen::MatrixXd>& found,
                          const Eigen::Ref<const Eigen::MatrixXd>& exact)
{
  return (found - exact).cwiseAbs().colwise().maxCoeff().cwiseQuotient(exact.cwiseAbs().colwise().maxCoeff());
}

class DerivativesTest : public testing::TestWithParam<std::tuple<bool, WheelsetConfig::Balance, CreepMethod>>
{
};

// Yaws below 2 mrad are left out: their columns are small, and the differences have the ripple of the cells.
TEST_P(DerivativesTest, AreThoseOfTheResults)
{
  const auto [bends, balance, creep] = GetParam();
  Seeded random(62);
  ContactModelConfig config = derivedScene(bends, balance);
  config.creep.method = creep;
  config.contact.tolerance *= creep == CreepMethod::none ? 1 : 10;  // so that friction converges in a few passes
  const bool rubs = creep != CreepMethod::none;
  ContactModelConfig held = config;
  held.wheelset.solve_height_and_roll = false;
  WheelsetContact solved(config), given(held);
  // Moments lift a wheel on the flange of a rigid rail. With friction, the differences of results bend there.
  const double spacing = rubs || (!bends && balance == WheelsetConfig::Balance::moments) ? 0.9e-3 : 1.2e-3;  // [m]
  for (int i = 0; i < (rubs ? 2 : 3); ++i)
  {
    const double load = random.within(4e4, 1.2e5);
    WheelsetState state = stateAt(spacing * (2 * i + 1 + random.within(0, 1)), load, random.within(2e-3, 8e-3),
                                  0.2 * load * random.unit());
    state.motion.speed = 20;
    state.motion.lateral_velocity = 0.015;
    solved.reset();
    given.reset();
    const WheelsetResult result = okResult(solved, state);
    std::vector<Varied> loads{{[](WheelsetState& s) -> double& { return s.y; }, rubs ? 3e-6 : 1e-5},
                              {[](WheelsetState& s) -> double& { return s.yaw; }, rubs ? 1e-4 : 1e-3},
                              {[](WheelsetState& s) -> double& { return s.force_z; }, 2e-3 * load},
                              {[](WheelsetState& s) -> double& { return s.torque_x; }, 2e-3 * load}};
    const std::vector<Varied> motions{
        {[](WheelsetState& s) -> double& { return s.motion.speed; }, 0.1},  // the rotation is free
        {[](WheelsetState& s) -> double& { return s.motion.lateral_velocity; }, 4e-4},
        {[](WheelsetState& s) -> double& { return s.motion.yaw_rate; }, 8e-4}};
    loads.insert(loads.end(), motions.begin(), rubs ? motions.end() : motions.begin());
    const Table by_loads = differences(solved, state, loads, solutionOf);
    state.z = result.z;
    state.roll = result.roll;
    std::vector<Varied> positions{{[](WheelsetState& s) -> double& { return s.y; }, rubs&& bends ? 1e-5 : 2e-6},
                                  {[](WheelsetState& s) -> double& { return s.z; }, 2e-6},
                                  {[](WheelsetState& s) -> double& { return s.roll; }, 2e-6},
                                  {[](WheelsetState& s) -> double& { return s.yaw; }, rubs ? 1e-4 : 1e-3}};
    positions.insert(positions.end(), motions.begin(), rubs ? motions.begin() + 2 : motions.begin());
    const Table by_position = differences(given, state, positions, wrenchOf);
    ContactDerivatives found = okResult(given, state).derivatives;
    found.solution = result.derivatives.solution;
    if (rubs)  // without the rotation; the yaw rate follows the speed and the lateral velocity
    {
      ASSERT_EQ(found.forces.cols() + found.solution.cols(), 18);
      found.forces = found.forces.leftCols<6>().eval();
      found.solution = found.solution.leftCols<7>().eval();
    }
    const Eigen::RowVectorXd of_forces = errors(found.forces, by_position),
                             of_heights = errors(found.solution.topRows<2>(), by_loads.topRows<2>()),
                             of_wheels = errors(found.solution.bottomRows<4>(), by_loads.bottomRows<4>());
    std::cout << "y " << 1e3 * state.y << " mm: " << of_forces << " | " << of_heights << " | " << of_wheels << "\n";
    const double allowed = rubs ? 0.015 : 0.01;  // friction jumps more with the cells
    EXPECT_LT(of_forces.maxCoeff(), allowed) << found.forces << "\n against\n" << by_position;
    if (!rubs)  // heights hardly change with friction
    {
      EXPECT_LT(of_heights.maxCoeff(), allowed) << found.solution << "\n against\n" << by_loads;
    }
    if (!(rubs && bends))  // friction does not converge to what a difference needs
    {
      EXPECT_LT(of_wheels.maxCoeff(), allowed) << found.solution << "\n against\n" << by_loads;
    }
  }
}

using Balance = WheelsetConfig::Balance;
INSTANTIATE_TEST_SUITE_P(Scenes, DerivativesTest,
                         testing::Combine(testing::Bool(), testing::Values(Balance::wheel_loads, Balance::moments),
                                          testing::Values(CreepMethod::none)));
INSTANTIATE_TEST_SUITE_P(Creep, DerivativesTest,
                         testing::Combine(testing::Bool(), testing::Values(Balance::wheel_loads),
                                          testing::Values(CreepMethod::fastsim)));

TEST(DerivativesOffTest, CostNothingAndChangeNoResult)
{
  ContactModelConfig config = manchesterScene();
  WheelsetContact plain(config);
  config.contact.derivatives = true;
  WheelsetContact derived(config);
  const WheelsetState state = stateAt(4e-3, 8e4, 1e-3);
  const WheelsetResult &one = okResult(plain, state), &two = okResult(derived, state);
  EXPECT_EQ(one.derivatives.forces.size() + one.derivatives.solution.size(), 0);
  EXPECT_EQ(two.derivatives.forces.size() + two.derivatives.solution.size(), 48);
  EXPECT_TRUE(wrenchOf(one) == wrenchOf(two) && solutionOf(one) == solutionOf(two));
}
}  // namespace
}  // namespace wheel_rail_contact::core
