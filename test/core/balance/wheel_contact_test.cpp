// SPDX-License-Identifier: BSD-3-Clause
// One wheel on the surface of its rail, against the reference code and its own energy.
#include "core/balance/wheel_contact.h"

#include "../normal/problems.h"
#include "conformal_reference.h"
#include "core/balance/rail_support.h"
#include "wheelset_scene.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr GridSize coarse{24, 64}, fine{64, 128};

/// Highest pressure of a cell [Pa] and whole area [m²].
struct Total
{
  double highest = 0, area = 0;
};

Total totalOf(const WheelContact& contact)
{
  Total total;
  for (const PatchPressure& patch : contact.solution().patches)
  {
    total.highest = std::max(total.highest, patch.pressure.maxCoeff());
    total.area += patch.area;
  }
  return total;
}

class WheelContactTest : public testing::Test
{
 protected:
  WheelContactTest() { contact_.setRail(straight_); }

  /// Sets the pose of the right wheel, in side axes, of a wheelset in balance.
  void balance(double y, double yaw = 0)
  {
    const WheelsetResult& result = wheelset_.evaluate(stateAt(y, wheel_load, yaw));
    ASSERT_TRUE(isUsable(result.status)) << result.reason << " at y " << y;
    pose_ = toSide(Side::right, {y, result.z, yaw, result.roll});
  }

  /// Solves under a load until hardly any approach remains. @return number of solutions; 0 if there is none
  int settle(WheelsetPose pose, double load = wheel_load)
  {
    constexpr int most = 12;
    for (int count = 1; count <= most; ++count)
    {
      if (contact_.solveLoad(pose, load) != WheelStatus::solved)
      {
        return 0;
      }
      pose.z = contact_.height();
      if (std::abs(contact_.remaining()) < 1e-4 * contact_.overlap())
      {
        return count;
      }
    }
    return 0;
  }

  /// Solves on kept grids with wheel and rail moved by `move` along a coordinate.
  void solveMoved(Motion motion, double move, OverlapGrids::Choice choice = OverlapGrids::Choice::own)
  {
    WheelsetPose pose = pose_;
    pose.z += motion == wheel_up ? move : 0;
    pose.roll += motion == wheel_roll ? move : 0;
    Eigen::Vector3d rail = Eigen::Vector3d::Zero();
    if (motion >= rail_lateral)
    {
      rail[motion - rail_lateral] = move;
    }
    contact_.setRail(straight_.deflected(toDeflection(rail)));
    ASSERT_EQ(contact_.solveAt(pose, choice), WheelStatus::solved);
  }

  ContactModelConfig config_ = fineScene();
  WheelsetContact wheelset_{config_};
  PlacedRail straight_ = restingRail(config_, Side::left);
  ConjugateGradients solver_ = problems::solverTo(1e-6);
  WheelContact contact_{config_, Side::left, straight_, solver_};
  WheelsetPose pose_;
};

/// Lever arm of the contact about the centre of a rotation [m]; 1 for a displacement.
double arm(Motion motion)
{
  return motion == wheel_roll ? 0.75 : motion == rail_roll ? 0.02 : 1;
}

/// Conjugate gradients that report a failure of every warm start.
class ColdSolver : public NormalSolver
{
 public:
  const char* name() const override { return "conjugate_gradient"; }
  void solve(const NormalProblem& problem, bool warm, NormalSolution& solution) override
  {
    solver_.solve(problem, warm, solution);
  }
  void solveCurved(const CurvedProblem& problem, bool warm, NormalSolution& solution) override
  {
    warm_starts += warm ? 1 : 0;
    solver_.solveCurved(problem, warm, solution);
    solution.status = warm ? SolveStatus::stalled : solution.status;
  }
  int warm_starts = 0;

 private:
  ConjugateGradients solver_;
};
}  // namespace

// Tolerances of 1.2 %: the surface that carries the cells differs by terms of the order of approach / radius (0.2
// mm / 13 mm = 1.5 % on the flange), and the grids by their discretisation.
TEST_F(WheelContactTest, AgreesWithTheConformalResultsOfTheReferenceCode)
{
  contact_.setGrid(0, fine);
  for (const ConformalReference& row : conformal_references)
  {
    balance(row.y);
    ASSERT_GT(settle(pose_), 0) << "y " << row.y;
    const Total total = totalOf(contact_);
    EXPECT_NEAR(total.highest / row.max_pressure, 1, 0.012) << "y " << row.y;
    EXPECT_NEAR(total.area / row.area, 1, 0.012) << "y " << row.y;
  }
}

// Conformal with half-space coefficients: lateral force of the reference code without turned normals. Where normals
// turn so little that their turn may be neglected, it has no effect on the force.
TEST_F(WheelContactTest, LateralForceAgreesWithTheReferenceCode)
{
  contact_.setGrid(0, fine);
  constexpr struct
  {
    double y, force;
  } rows[] = {{-3e-3, 9300}, {-5.5e-3, 35023}, {-6e-3, 45011}};
  for (const auto& row : rows)
  {
    balance(row.y);
    ASSERT_GT(settle(pose_), 0) << "y " << row.y;
    EXPECT_NEAR(contact_.solved().forces()[rail_lateral] / row.force, 1, 3e-3) << "y " << row.y;
    EXPECT_NEAR(contact_.solved().forces()[wheel_up] / wheel_load, 1, 1e-6) << "y " << row.y;
  }
}

// Frictionless contact is conservative: F = -dU/dq along every coordinate. Central differences over 1 um of an overlap
// of 100 um, or the roll that moves a contact by as much. The grids are kept. Tolerance: 1 % of the force, or of the
// load at its lever arm where two moments nearly cancel. The stiffness, elastic and geometric part, is the derivative
// of the forces.
TEST_F(WheelContactTest, ForcesAreTheDerivativesOfTheEnergyAndTheStiffnessOfTheForces)
{
  contact_.setGrid(0, fine);
  for (const double y : {-2e-3, -5.5e-3, -6.3e-3, -7e-3})
  {
    balance(y);
    solveMoved(wheel_up, 0);
    const MotionVector forces = contact_.solved().forces();
    const MotionMatrix stiffness = contact_.stiffness();
    for (const Motion motion : {wheel_up, wheel_roll, rail_lateral, rail_up, rail_roll})
    {
      const double step = 1e-6 / arm(motion);
      solveMoved(motion, -step, OverlapGrids::Choice::kept);
      const double energy_before = contact_.solved().energy(), force_before = contact_.solved().forces()[motion];
      solveMoved(motion, step, OverlapGrids::Choice::kept);
      const double force = (energy_before - contact_.solved().energy()) / (2 * step);
      const double size = std::max(std::abs(force), wheel_load * arm(motion));
      EXPECT_NEAR(forces[motion], force, 0.01 * size) << "y " << y << " motion " << motion;
      if (y != -6.3e-3)  // where the load moves from the tread to the flange
      {
        const double slope = (force_before - contact_.solved().forces()[motion]) / (2 * step);
        // The stiffness leaves a residual of 3 %, and takes one slope of the wheel for each column: 8 % on the flange.
        EXPECT_NEAR(stiffness(motion, motion) / slope, 1, 0.1) << "y " << y << " motion " << motion;
      }
    }
  }
}

TEST_F(WheelContactTest, StiffnessIsSymmetric)
{
  contact_.setGrid(0, coarse);
  for (const double y : {-2e-3, -6.3e-3, -7e-3})
  {
    balance(y);
    solveMoved(wheel_up, 0);
    const MotionMatrix stiffness = contact_.stiffness();
    for (int m = 0; m < motions; ++m)
    {
      for (int n = 0; n < m; ++n)
      {
        const double size = std::sqrt(std::abs(stiffness(m, m) * stiffness(n, n)));
        EXPECT_NEAR(stiffness(m, n), stiffness(n, m), 0.05 * size) << "y " << y << ": " << m << ", " << n;
      }
    }
  }
}

TEST_F(WheelContactTest, VerticalForceGrowsAsTheWheelDescends)
{
  contact_.setGrid(0, coarse);
  for (const double y : {-2e-3, -4.3e-3, -6.3e-3, -7e-3})
  {
    balance(y);
    double last = 0;
    for (int k = 0; k <= 60; ++k)
    {
      WheelsetPose pose = pose_;
      pose.z += 1e-4 - 5e-6 * k;
      const WheelStatus status = contact_.solveAt(pose);
      ASSERT_TRUE(status == WheelStatus::solved || status == WheelStatus::no_contact) << "y " << y << " k " << k;
      const double force = contact_.solved().forces()[wheel_up];
      EXPECT_TRUE(force > last || (force == 0 && last == 0)) << "y " << y << " k " << k;
      last = force;
    }
    EXPECT_GT(last, wheel_load);
  }
}

// From any height the same result, within the remaining approach.
TEST_F(WheelContactTest, StartDoesNotChangeTheResult)
{
  contact_.setGrid(0, coarse);
  for (const double y : {0.0, -4.5e-3, -6.3e-3, -6.6e-3})
  {
    balance(y);
    ASSERT_GT(settle(pose_), 0) << "y " << y;
    const double height = contact_.height();
    const double highest = totalOf(contact_).highest;
    for (const double above : {5e-3, 1e-4, -5e-5, -3e-4})
    {
      WheelsetPose pose = pose_;
      pose.z += above;
      ASSERT_GT(settle(pose), 0) << "y " << y << " above " << above;
      EXPECT_NEAR(contact_.height(), height, 5e-7) << "y " << y << " above " << above;
      EXPECT_NEAR(totalOf(contact_).highest / highest, 1, 5e-3) << "y " << y;
    }
  }
}

// One solution predicts the height under the load: the approach that remains leads to it.
TEST_F(WheelContactTest, RemainingApproachLeadsToTheHeightUnderTheLoad)
{
  contact_.setGrid(0, coarse);
  for (const double y : {0.0, -6.3e-3})
  {
    balance(y);
    ASSERT_GT(settle(pose_), 0) << "y " << y;
    const double height = contact_.height(), overlap = contact_.overlap();
    for (const double share : {-0.1, 0.1})
    {
      WheelsetPose pose = pose_;
      pose.z = height + share * overlap;
      ASSERT_EQ(contact_.solveLoad(pose, wheel_load), WheelStatus::solved);
      EXPECT_GT(share * contact_.remaining(), 0);
      EXPECT_NEAR(contact_.height(), height, 0.01 * overlap) << "y " << y << " share " << share;
    }
  }
}

// The elastic part is all of it on the tread.
TEST_F(WheelContactTest, HeightPerRollIsTheSlopeOfTheHeight)
{
  contact_.setGrid(0, coarse);
  for (const double y : {0.0, -2e-3})
  {
    balance(y);
    const auto heightAt = [&](double roll)
    {
      WheelsetPose pose = pose_;
      pose.roll += roll;
      EXPECT_GT(settle(pose), 0) << "y " << y;
      return contact_.height();
    };
    const double slope = (heightAt(1e-5) - heightAt(-1e-5)) / 2e-5;
    heightAt(0);
    EXPECT_NEAR(contact_.solved().heightPer(wheel_roll) / slope, 1, 0.01) << "y " << y;
  }
}

TEST_F(WheelContactTest, WithoutContactThereIsNoForce)
{
  contact_.setGrid(0, coarse);
  balance(0);
  ASSERT_GT(settle(pose_), 0);
  WheelsetPose pose = pose_;
  pose.z += 1e-3;
  EXPECT_EQ(contact_.solveAt(pose), WheelStatus::no_contact);
  EXPECT_TRUE(contact_.solved().forces().isZero(0));
  EXPECT_EQ(contact_.solved().energy(), 0);
  EXPECT_TRUE(contact_.stiffness().isZero(0));
  pose.y = 0.5;  // beside the rail
  EXPECT_EQ(contact_.solveAt(pose), WheelStatus::beside_rail);
  EXPECT_EQ(contact_.solveLoad(pose, wheel_load), WheelStatus::beside_rail);
  EXPECT_TRUE(contact_.solved().forces().isZero(0));
  EXPECT_GT(settle(pose_), 0);
}

TEST_F(WheelContactTest, FirstTouchIsTheHeightWithoutOverlap)
{
  contact_.setGrid(0, coarse);
  balance(-2e-3);
  for (const double above : {1e-3, -1e-4})
  {
    WheelsetPose pose = pose_;
    pose.z += above;
    ASSERT_EQ(contact_.touch(pose), WheelStatus::no_contact);
    pose.z = contact_.height();
    EXPECT_EQ(contact_.solveAt({pose.y, pose.z + 1e-9, pose.yaw, pose.roll}), WheelStatus::no_contact);
    EXPECT_EQ(contact_.solveAt({pose.y, pose.z - 1e-6, pose.yaw, pose.roll}), WheelStatus::solved);
  }
}

TEST_F(WheelContactTest, AFailedWarmStartIsFollowedByAColdOne)
{
  ColdSolver solver;
  WheelContact contact(config_, Side::left, straight_, solver);
  contact.setRail(straight_);
  contact.setGrid(0, coarse);
  balance(-2e-3);
  ASSERT_EQ(contact.solveLoad(pose_, wheel_load), WheelStatus::solved);
  ASSERT_EQ(contact.solveLoad(pose_, wheel_load), WheelStatus::solved);
  EXPECT_EQ(solver.warm_starts, 1);
}

// The pressures of each grid are kept apart, and only help the iteration.
TEST_F(WheelContactTest, ChangesBetweenGridsDoNotChangeTheResult)
{
  balance(-6.3e-3);
  contact_.setGrid(0, coarse);
  ASSERT_GT(settle(pose_), 0);
  const Total first = totalOf(contact_);
  contact_.setGrid(1, fine);
  ASSERT_GT(settle(pose_), 0);
  contact_.setGrid(0, coarse);
  ASSERT_GT(settle(pose_), 0);
  EXPECT_NEAR(totalOf(contact_).highest / first.highest, 1, 1e-3);
  EXPECT_NEAR(totalOf(contact_).area / first.area, 1, 1e-3);
}
}  // namespace wheel_rail_contact::core
