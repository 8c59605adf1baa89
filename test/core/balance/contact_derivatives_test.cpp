// SPDX-License-Identifier: BSD-3-Clause
// Derivatives of a result, against central differences of results.
#include "../../seeded.h"
#include "wheelset_scene.h"

namespace wheel_rail_contact::core
{
namespace
{
using Six = Eigen::Matrix<double, 6, 1>;
using Table = Eigen::Matrix<double, 6, 4>;

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
  double WheelsetState::*value;
  double step;
};

template <typename Get>
Table differences(WheelsetContact& contact, const WheelsetState& state, const std::array<Varied, 4>& columns,
                  const Get& get)
{
  Table table;
  for (int column = 0; column < 4; ++column)
  {
    const auto& [value, step] = columns[static_cast<std::size_t>(column)];
    WheelsetState ahead = state, behind = state;
    ahead.*value += step;
    behind.*value -= step;
    const Six after = get(okResult(contact, ahead));
    table.col(column) = (after - get(okResult(contact, behind))) / (2 * step);
  }
  return table;
}

/// Largest difference of each column over its largest entry [-].
Eigen::RowVector4d errors(const Eigen::Ref<const Eigen::MatrixXd>& found,
                          const Eigen::Ref<const Eigen::MatrixXd>& exact)
{
  return (found - exact).cwiseAbs().colwise().maxCoeff().cwiseQuotient(exact.cwiseAbs().colwise().maxCoeff());
}

class DerivativesTest : public testing::TestWithParam<std::tuple<bool, WheelsetConfig::Balance>>
{
};

// Yaws below 2 mrad are left out: their columns are small, and the differences have the ripple of the cells.
TEST_P(DerivativesTest, AreThoseOfTheResults)
{
  const auto [bends, balance] = GetParam();
  Seeded random(62);
  const ContactModelConfig config = derivedScene(bends, balance);
  ContactModelConfig held = config;
  held.wheelset.solve_height_and_roll = false;
  WheelsetContact solved(config), given(held);
  const bool lifts = !bends && balance == WheelsetConfig::Balance::moments;  // a wheel, on the flange
  const double spacing = lifts ? 0.9e-3 : 1.2e-3;                            // of the positions, up to the flange [m]
  for (int i = 0; i < 3; ++i)
  {
    const double load = random.within(4e4, 1.2e5);
    WheelsetState state = stateAt(spacing * (2 * i + 1 + random.within(0, 1)), load, random.within(2e-3, 8e-3),
                                  0.2 * load * random.unit());
    solved.reset();
    given.reset();
    const WheelsetResult result = okResult(solved, state);
    const Table by_loads = differences(solved, state,
                                       {{{&WheelsetState::y, 1e-5},
                                         {&WheelsetState::yaw, 1e-3},
                                         {&WheelsetState::force_z, 2e-3 * load},
                                         {&WheelsetState::torque_x, 2e-3 * load}}},
                                       solutionOf);
    state.z = result.z;
    state.roll = result.roll;
    const Table by_position = differences(given, state,
                                          {{{&WheelsetState::y, 2e-6},
                                            {&WheelsetState::z, 2e-6},
                                            {&WheelsetState::roll, 2e-6},
                                            {&WheelsetState::yaw, 1e-3}}},
                                          wrenchOf);
    const ContactDerivatives& found = result.derivatives;
    const Eigen::RowVector4d of_forces = errors(found.forces, by_position),
                             of_heights = errors(found.solution.topRows<2>(), by_loads.topRows<2>()),
                             of_wheels = errors(found.solution.bottomRows<4>(), by_loads.bottomRows<4>());
    std::cout << "y " << 1e3 * state.y << " mm: " << of_forces << " | " << of_heights << " | " << of_wheels << "\n";
    EXPECT_LT(of_forces.maxCoeff(), 0.01) << found.forces << "\n against\n" << by_position;
    EXPECT_LT(of_heights.maxCoeff(), 0.01) << found.solution << "\n against\n" << by_loads;
    EXPECT_LT(of_wheels.maxCoeff(), 0.01) << found.solution << "\n against\n" << by_loads;
    EXPECT_TRUE(okResult(given, state).derivatives.forces.isApprox(found.forces, 2e-3));
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, DerivativesTest,
                         testing::Combine(testing::Bool(), testing::Values(WheelsetConfig::Balance::wheel_loads,
                                                                           WheelsetConfig::Balance::moments)));

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
