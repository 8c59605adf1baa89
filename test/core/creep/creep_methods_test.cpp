// SPDX-License-Identifier: BSD-3-Clause
#include "../../seeded.h"
#include "creep_scene.h"

namespace wheel_rail_contact::core
{
namespace
{
/// An ellipse by CONTACT: complete theory of steady rolling, 100 kN, friction 0.3, G = 82.03125 GPa, nu = 0.28, 48 × 48
/// cells on 1.05 times the ellipse. Forces over the friction limit, moment over the limit times sqrt(a b).
struct EllipseCase
{
  double a, b;
  Creepage creepage;
  double x, y, moment;
};

const EllipseCase ellipse_cases[] = {
    {4.330020e-03, 2.165010e-02, {4.876431e-05, 0, 0}, -0.043907, 0, 0},
    {4.330020e-03, 2.165010e-02, {0, 0, 1.343061e-01}, 0, -0.163093, -0.690201},
    {4.330020e-03, 2.165010e-02, {0, -4.876431e-04, 1.343061e-01}, 0, 0.078279, -0.710194},
    {5.725874e-03, 1.145175e-02, {2.464866e-03, 2.464866e-03, 0}, -0.743395, -0.659285, 0.011298},
    {6.904435e-03, 6.904435e-03, {6.780796e-04, 6.780796e-04, 0}, -0.323269, -0.284954, 0.076193},
    {6.904435e-03, 6.904435e-03, {2.876848e-03, 0, 0}, -0.924970, 0, 0},
    {6.904435e-03, 6.904435e-03, {0, 0, 7.407407e-01}, 0, -0.603691, -0.400324},
    {6.904435e-03, 6.904435e-03, {3.835797e-03, 0, 1.111111}, -0.540678, -0.433622, -0.359361},
    {6.904435e-03, 6.904435e-03, {0, -3.835797e-03, 1.111111}, 0, 0.042769, -0.552437},
    {9.502552e-03, 1.900510e-03, {0, 2.531287e-03, 0}, 0, -0.741540, 0.221284},
    {9.502552e-03, 1.900510e-03, {0, 5.062575e-03, 1.588382}, 0, -0.919495, -0.161675}};

/// Expects the forces to the tolerance [N], and the moments to the tolerance times a lever of 6 mm.
void expectNear(const CreepForce& found, const CreepForce& expected, double tolerance, CreepMethod method)
{
  EXPECT_NEAR(found.x, expected.x, tolerance) << toString(method);
  EXPECT_NEAR(found.y, expected.y, tolerance) << toString(method);
  EXPECT_NEAR(found.moment, expected.moment, tolerance * 0.006) << toString(method);
}

TEST(CreepForces, AreThoseOfTheReferenceCode)
{
  // The accuracy of the methods over all 190 ellipses of the source, of which these are some: see doc/theory.md. That
  // of the linear law with spin is not limited.
  const double any = std::numeric_limits<double>::infinity(), limit = CreepScene::friction_limit;
  for (const EllipseCase& c : ellipse_cases)
  {
    const bool has_spin = c.creepage.spin != 0;
    const auto compare = [&](CreepMethod method, double tolerance, double moment_tolerance)
    {
      const CreepForce force = ellipseCreepForce({c.a, c.b, 1e5}, c.creepage, method);
      EXPECT_NEAR(force.x / limit, c.x, tolerance) << toString(method);
      EXPECT_NEAR(force.y / limit, c.y, tolerance) << toString(method);
      EXPECT_NEAR(force.moment / (limit * std::sqrt(c.a * c.b)), c.moment, moment_tolerance) << toString(method);
    };
    compare(CreepMethod::exact, 0.02, 0.03);
    compare(CreepMethod::fastsim, has_spin ? 0.13 : 0.07, 0.14);
    compare(CreepMethod::linear, has_spin ? any : 0.07, any);
    const CreepProblem coarse = ellipseProblem({c.a, c.b, 1e5, 12, 24}, c.creepage);
    const CreepSolution solution = CreepScene::solve(CreepMethod::exact, coarse);
    EXPECT_LE(std::hypot(solution.force.x / limit - c.x, solution.force.y / limit - c.y), solution.error_estimate);
    EXPECT_LE(solution.error_estimate, 0.07);
  }
}

TEST(CreepForces, FullSlidingIsTheFrictionLimitAgainstTheSlip)
{
  const double limit = CreepScene::friction_limit;
  for (const CreepMethod method : creeping_methods)
  {
    const CreepSolution solution = CreepScene().solve(method, Creepage{0.3, -0.4, 0});
    EXPECT_EQ(solution.status, CreepStatus::converged);
    EXPECT_NEAR(solution.adhesion_share, 1, 1e-4) << toString(method);
    // Only the exact method has the direction of the slip; the others have different compliances along x and y.
    const double tolerance = method == CreepMethod::exact ? 1e-3 * limit : 0.05 * limit;
    EXPECT_NEAR(solution.force.x, -0.6 * limit, tolerance) << toString(method);
    EXPECT_NEAR(solution.force.y, 0.8 * limit, tolerance) << toString(method);
  }
}

TEST(CreepForces, AreMirroredWithTheCreepages)
{
  const Creepage creep = {8e-4, 5e-4, 0.4};
  for (const CreepMethod method : creeping_methods)
  {
    const CreepForce force = CreepScene().solve(method, creep).force;
    // Mirror image in the plane y = 0: y and rotations about x and z change their sign.
    const CreepForce mirrored = CreepScene().solve(method, Creepage{creep.x, -creep.y, -creep.spin}).force;
    // The sweeps of the exact method are not symmetric; they end at 5e-4.
    expectNear(mirrored, {force.x, -force.y, -force.moment}, 2e-3 * CreepScene::friction_limit, method);
  }
}

TEST(CreepForces, OfAPatchAtOtherCreepagesAreThoseOfANewOne)
{
  for (const CreepMethod method : creeping_methods)
  {
    CreepProblem problem = CreepScene().problem({8e-4, 5e-4, 0.4});
    problem.friction = {0.3, 0.4, 0.6};
    const auto solver = makeCreepSolver(method);
    CreepSolution solution;
    solver->solve(problem, false, solution);
    problem.creepage = {7e-4, -2e-4, 0.3};
    const CreepForce expected = CreepScene::solve(method, problem).force;
    solver->solveAgain(problem, solution);
    const double tolerance = (method == CreepMethod::exact ? 1e-3 : 1e-12) * CreepScene::friction_limit;  // of sweeps
    expectNear(solution.force, expected, tolerance, method);
  }
}

TEST(CreepForces, WheelThatRollsBackwardIsOneTurnedAroundTheNormal)
{
  const Creepage creep = {8e-4, 5e-4, 0.4};
  for (const CreepMethod method : creeping_methods)
  {
    CreepProblem problem = CreepScene().problem(creep);
    problem.pressure.leftCols(6) *= 0.5;  // not symmetric
    problem.pressure.topRows(9) *= 0.8;
    const CreepSolution forward = CreepScene::solve(method, problem);
    problem.speed = -1;
    problem.pressure = problem.pressure.reverse().eval();
    problem.creepage = {-creep.x, -creep.y, creep.spin};
    const CreepSolution backward = CreepScene::solve(method, problem);
    const double rounding = 1e-9 * CreepScene::friction_limit;
    expectNear(backward.force, {-forward.force.x, -forward.force.y, forward.force.moment}, rounding, method);
    EXPECT_NEAR(backward.power, forward.power, rounding) << toString(method);
  }
}

TEST(CreepForces, FastsimDoesNotJumpWhereTwoContactsOnAGridJoin)
{
  CreepProblem joined = CreepScene().problem({8e-4, 5e-4, 0.2});
  const CreepForce whole = CreepScene::solve(CreepMethod::fastsim, joined).force;
  CreepProblem apart = joined;
  apart.pressure.col(12) = 0;
  joined.pressure.col(12).setZero();
  joined.pressure(12, 12) = 1e-4 * joined.pressure.maxCoeff();
  const CreepForce one = CreepScene::solve(CreepMethod::fastsim, joined).force;
  const CreepForce two = CreepScene::solve(CreepMethod::fastsim, apart).force;
  const double tolerance = 5e-3 * CreepScene::friction_limit;  // a column has at least the length of a cell
  EXPECT_NEAR(one.x, two.x, tolerance);
  EXPECT_NEAR(one.y, two.y, tolerance);
  EXPECT_GT(std::abs(whole.x - two.x), 5 * tolerance);
}

TEST(CreepForces, FrictionNeverDrives)
{
  Seeded random(20);
  for (const CreepMethod method : creeping_methods)
  {
    const auto solver = makeCreepSolver(method);
    CreepSolution solution;
    for (int i = 0; i < 60; ++i)
    {
      const double size = std::pow(10, 2 * random.unit());
      const CreepScene scene = {0.006 * std::exp2(random.unit()), 0.006 * std::exp2(2 * random.unit())};
      CreepProblem problem =
          scene.problem({size * 1e-3 * random.unit(), size * 1e-3 * random.unit(), size * 0.3 * random.unit()});
      problem.speed = random.unit() < 0 ? -10 : 10;
      solver->solve(problem, false, solution);
      EXPECT_EQ(solution.status, CreepStatus::converged) << toString(method) << ", case " << i;
      EXPECT_GE(solution.power, 0) << toString(method) << ", case " << i;
      EXPECT_LE(solution.adhesion_share, 1 + 1e-12) << toString(method) << ", case " << i;
    }
  }
}

TEST(CreepForces, FrictionFallsWithTheSlipVelocity)
{
  const FrictionLaw law = {0.5, 0.4, 0.6};
  validate(law, "friction");
  EXPECT_EQ(law.at(0), 0.5);
  EXPECT_NEAR(law.at(1), 0.5 * (0.6 * std::exp(-0.6) + 0.4), 1e-15);
  EXPECT_NEAR(law.at(1e9), 0.2, 1e-15);
  CreepProblem problem = CreepScene().problem({0.05, 0, 0});
  problem.friction = law;
  problem.speed = -20;
  const CreepSolution solution = CreepScene::solve(CreepMethod::exact, problem);
  EXPECT_NEAR(solution.friction, law.at(1), 1e-15);
  EXPECT_NEAR(solution.force.x, -law.at(1) * 1e5, 1e-3 * 1e5);
}

TEST(CreepForces, MethodNoneAndNoFrictionHaveNoForce)
{
  CreepProblem problem = CreepScene().problem({0.001, 0, 0});
  EXPECT_EQ(CreepScene::solve(CreepMethod::none, problem).status, CreepStatus::no_slip);
  problem.friction.coefficient = 0;
  for (const CreepMethod method : creeping_methods)
  {
    const CreepSolution solution = CreepScene::solve(method, problem);
    EXPECT_EQ(solution.status, CreepStatus::no_slip);
    EXPECT_EQ(solution.force.x, 0);
  }
}

TEST(CreepForces, InvalidProblemsAreRefused)
{
  const auto expect_refused = [](CreepMethod method, auto spoil)
  {
    CreepProblem problem = CreepScene().problem({0.001, 0, 0});
    spoil(problem);
    EXPECT_EQ(CreepScene::solve(method, problem).status, CreepStatus::invalid_problem) << toString(method);
  };
  for (const CreepMethod method : creeping_methods)
  {
    expect_refused(method, [](CreepProblem& problem) { problem.creepage.spin = std::nan(""); });
    expect_refused(method, [](CreepProblem& problem) { problem.friction.coefficient = 2.1; });
  }
  for (const CreepMethod method : {CreepMethod::fastsim, CreepMethod::exact})
  {
    expect_refused(method, [](CreepProblem& problem) { problem.pressure.resize(3, 24); });
    expect_refused(method, [](CreepProblem& problem) { problem.pressure(3, 3) = -1; });
  }
  EXPECT_THROW(ellipseCreepForce({0, 0.005, 1e5}, {}, CreepMethod::exact), std::invalid_argument);
  EXPECT_THROW(ellipseCreepForce({0.006, 0.005, 1e5}, {}, CreepMethod::exact, {-0.1, 1, 0}), std::invalid_argument);
}

TEST(CreepMethods, HaveNames)
{
  for (const CreepMethod method : all_creep_methods)
  {
    EXPECT_EQ(creepMethodNamed(toString(method)), method);
  }
  EXPECT_THROW(creepMethodNamed("kalker"), std::invalid_argument);
}

TEST(ShearElasticity, IsTheMeanOfBothBodies)
{
  const Material steel;
  const ShearElasticity same = shearElasticity(steel, steel);
  EXPECT_NEAR(same.modulus, ShearElasticity().modulus, 1);
  EXPECT_NEAR(same.poisson, 0.28, 1e-15);
  const Material soft = {1.0e11, 0.4};
  const double g1 = steel.young / (2 * 1.28), g2 = soft.young / (2 * 1.4);
  const ShearElasticity pair = shearElasticity(steel, soft);
  EXPECT_NEAR(1 / pair.modulus, 0.5 * (1 / g1 + 1 / g2), 1e-24);
  EXPECT_NEAR(pair.poisson / pair.modulus, 0.5 * (0.28 / g1 + 0.4 / g2), 1e-24);
}
}  // namespace
}  // namespace wheel_rail_contact::core
