// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../standard_headers.h"
#include "../thread_time.h"
#include "core/balance/wheelset_balance.h"
#include "core/normal/solvers/conjugate_gradients.h"

namespace wheel_rail_contact::core::stability
{
/// Cells of a grid, and time of a product on it over that on 12 x 24 cells, both symmetric. Measured on 8 x 16, 12 x
/// 24, 16 x 32, 16 x 48, 24 x 64, 32 x 96, 48 x 128 and 64 x 192 cells, smallest of 40 runs. Without symmetry it is
/// twice as much, within 8 %.
constexpr std::array<std::array<double, 2>, 8> product_costs{
    {{128, 0.42}, {288, 1}, {512, 1.54}, {768, 2.66}, {1536, 6.6}, {3072, 17.5}, {6144, 36}, {12288, 91}}};

/// The rest of a solution - placing the wheel, grids, gap, pressure and area - takes as long as about this number of
/// its products: 8 on 12 x 24 cells, 4 to 7 on 24 x 64, by least squares over the times of 20 000 states.
constexpr double products_per_solution = 6;

/// Work of one product on all patches of a problem. Normals that are turned take two.
inline double workOfProduct(const CurvedProblem& problem)
{
  double work = 0;
  for (const PatchGap& patch : problem.patches)
  {
    const double cells = static_cast<double>(patch.grid.nx) * patch.grid.ny;
    const auto size = std::find_if(product_costs.begin(), product_costs.end() - 1,
                                   [&](const std::array<double, 2>& cost) { return cells <= cost[0]; });
    work += (patch.grid.symmetric ? 1 : 2) * (*size)[1] * cells / (*size)[0];
  }
  const bool turned = std::any_of(problem.normals.begin(), problem.normals.end(),
                                  [](const ColumnNormals& normals) { return normals.areTurned(); });
  return (turned ? 2 : 1) * work;
}

/// Numbers of one search.
struct Measurement
{
  double y = 0;                                ///< [m]
  double refused = 0, beside = 0, above = 0;   ///< 1 if it is so; `above`: error estimate above the tolerance
  double solutions = 0, work = 0, effort = 0;  ///< of both wheels
  double seconds = 0, in_solver = 0;           ///< time [s]
};

/// Measurements of several states.
struct Measurements : std::vector<Measurement>
{
  using Number = double Measurement::*;

  double sum(Number number) const
  {
    double sum = 0;
    std::for_each(begin(), end(), [&](const Measurement& one) { sum += one.*number; });
    return sum;
  }
  double quantile(Number number, double share = 0.5) const
  {
    std::vector<double> numbers;
    std::transform(begin(), end(), std::back_inserter(numbers), [&](const Measurement& one) { return one.*number; });
    std::sort(numbers.begin(), numbers.end());
    return numbers[static_cast<std::size_t>(share * static_cast<double>(size() - 1))];
  }
};

/// A balance whose work is measured.
class MeasuredBalance
{
 public:
  explicit MeasuredBalance(const ContactModelConfig& config)
      : config_(config),
        levels_(config_,
                [this](std::unique_ptr<NormalSolver> solver) { return std::make_unique<Counter>(*solver, *this); }),
        balance_(config_, levels_)
  {
  }

  WheelsetBalance& balance() { return balance_; }

  Measurement solve(const WheelsetState& state)
  {
    now_ = {state.y};
    const double begin = threadTime();
    const bool usable = isUsable(balance_.solve(state));
    now_.seconds = threadTime() - begin;
    addStiffness();
    now_.effort += now_.work;
    const double error = std::max(balance_.wheelError(Side::left), balance_.wheelError(Side::right));
    now_.refused = usable ? 0 : 1;
    now_.above = usable && error > config_.contact.tolerance ? 1 : 0;
    return now_;
  }

 private:
  /// The solver, with a count of its solutions.
  struct Counter : ConjugateGradients
  {
    Counter(NormalSolver& solver, MeasuredBalance& balance)
        : ConjugateGradients(std::move(dynamic_cast<ConjugateGradients&>(solver))), owner(balance)
    {
    }
    void solveCurved(const CurvedProblem& problem, bool warm, NormalSolution& solution) override
    {
      owner.addStiffness();
      const double begin = threadTime();
      ConjugateGradients::solveCurved(problem, warm, solution);
      owner.now_.in_solver += threadTime() - begin;
      const bool is_left = &problem == &owner.balance_.wheel(Side::left).contact().problem();
      const double work = owner.work_of_product_[is_left ? Side::left : Side::right] = workOfProduct(problem);
      owner.now_.work += solution.iterations * work;
      owner.now_.effort += products_per_solution * work;
      owner.now_.solutions += 1;
    }
    MeasuredBalance& owner;
  };

  /// Adds the stiffnesses since the last call, which are those of the last problem of each wheel.
  void addStiffness()
  {
    for (const Side side : sides)
    {
      const int products = balance_.wheel(side).contact().stiffnessProducts();
      now_.work += (products - products_[side]) * work_of_product_[side];
      products_[side] = products;
    }
  }

  ContactModelConfig config_;
  GridLevels levels_;
  WheelsetBalance balance_;
  Measurement now_;
  Sides<int> products_{};            ///< for stiffnesses, that are counted
  Sides<double> work_of_product_{};  ///< in the last problem of a wheel
};
}  // namespace wheel_rail_contact::core::stability
