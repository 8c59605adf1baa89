// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/balance/patch_result.h"
#include "core/balance/wheelset_balance.h"
#include "core/normal/estimate/error_estimate.h"
#include "core/normal/solvers/hertz_solver.h"
#include "core/normal/solvers/kik_piotrowski.h"
#include "gap_scenes.h"
#include "pressure_extent.h"
#include "wheel_rail_contact/core/profile_reader.h"

/// Solutions of random scenes. Their true errors are from the same scene on a grid four times finer in each direction.
namespace wheel_rail_contact::core::scenes
{
/// Random gap for a method. For Hertz half of the gaps are nearly round, because it is accurate there only.
inline GapScene randomGapScene(NormalMethod method, Random& random)
{
  return method == NormalMethod::hertz && oneIn(random, 2) ? randomBowlScene(random) : randomGapScene(random);
}

/// Sample of one patch.
struct ErrorSample
{
  ErrorTerms terms;  ///< of conjugate gradients
  ErrorEstimate estimate;
  ErrorEstimate error;  ///< true error
};

constexpr int finer = 4;  ///< cells of the reference over cells of the sample, in each direction
/// Cells of the reference for gaps solved in closed form, whose errors do not decrease with the cells of the sample.
constexpr GridSize closed_form_truth{96, 256};

/// Grids of many shapes, coarse to fine, including some that `auto` does not use.
constexpr GridSize grids[] = {{4, 16},  {8, 16},  {8, 24},  {10, 24}, {12, 24}, {12, 32}, {16, 32}, {16, 48},
                              {12, 64}, {16, 64}, {24, 48}, {16, 96}, {32, 64}, {32, 96}, {48, 96}};

inline bool isSeidel(NormalMethod method)
{
  return method == NormalMethod::seidel || method == NormalMethod::seidel_printed;
}

inline std::unique_ptr<NormalSolver> makeSolver(NormalMethod method, double residual)
{
  if (method == NormalMethod::conjugate_gradient)
  {
    return std::make_unique<ConjugateGradients>(problems::solverTo(residual));
  }
  SeidelOptions options;
  options.form = method == NormalMethod::seidel_printed ? SeidelOptions::Form::printed : SeidelOptions::Form::repaired;
  options.residual = residual;
  return isSeidel(method) ? std::make_unique<Seidel>(options) : makeNormalSolver(method);
}

/// Fills terms and estimate. `own_approach` is that of the patch [m].
inline ErrorSample describe(NormalMethod method, const NormalSolver& solver, const NormalProblem& problem,
                            const NormalSolution& solution, std::size_t patch, double own_approach)
{
  ErrorSample sample;
  if (method == NormalMethod::conjugate_gradient)
  {
    const double residual = solution.residual * (problem.patches.size() == 1 ? 1 : solution.approach / own_approach);
    sample.terms = errorTerms(problem.patches[patch], solution.patches[patch], problem.modulus, residual);
  }
  sample.estimate = errorsOf(solver, problem, solution)[patch];
  return sample;
}

inline ErrorEstimate relativeErrors(const PatchPressure& found, double found_approach, const PatchPressure& truth,
                                    double true_approach)
{
  return {std::abs(found.max_pressure / truth.max_pressure - 1), std::abs(found.area / truth.area - 1),
          std::abs(found_approach / true_approach - 1)};
}

/// Solves gap scenes.
class GapSampler
{
 public:
  /// Adds a sample for every patch. Returns false under the conditions of solve(), or if a patch has no pressure on the
  /// cells of the sample.
  bool sample(NormalMethod method, const GapScene& scene, const GridSize& size, Random& random,
              std::vector<ErrorSample>& samples)
  {
    const auto solver = makeSolver(method, spread(random, 1e-5, 1e-3));
    return solve(method, *solver, scene, size, random) && add(method, *solver, samples);
  }

 private:
  static constexpr double modulus = 1.14e11;  ///< steel on steel [Pa]
  static constexpr int most_boxes = 12;
  static constexpr double margin = 1.1;  ///< margin of the boxes that the package uses [-]

  /// Solves a scene by `solver` on a random box with `size` cells, and the reference on finer cells. Returns false if
  /// there is no usable reference (a patch without pressure, or no box found) or no result of the method.
  bool solve(NormalMethod method, NormalSolver& solver, const GapScene& scene, const GridSize& size, Random& random)
  {
    problem_.modulus = modulus;
    problem_.value = scene.load;
    problem_.patches.resize(scene.patches.size());
    for (PatchGap& patch : problem_.patches)
    {
      patch.grid = {16, 48, 1e-3, 4e-4, -0.5 * 47 * 4e-4, scene.even};
    }
    if (!findBoxes(scene))
    {
      return false;
    }
    for (PatchGap& patch : problem_.patches)
    {
      patch.grid = randomBox(random, patch.grid, size);
    }
    fill(scene);
    solver.solve(problem_, false, found_);
    coarse_ = problem_;
    for (PatchGap& patch : problem_.patches)
    {
      patch.grid =
          method == NormalMethod::hertz ? regridded(patch.grid, closed_form_truth) : refined(patch.grid, finer);
    }
    fill(scene);
    ConjugateGradients strict = problems::solverTo(1e-6, 1000);
    strict.solve(problem_, false, true_);
    return found_.status == SolveStatus::converged && true_.status == SolveStatus::converged &&
           std::all_of(true_.patches.begin(), true_.patches.end(),
                       [](const PatchPressure& patch) { return patch.force > 0 && !patch.touches_border; });
  }
  void fill(const GapScene& scene)
  {
    for (std::size_t k = 0; k < scene.patches.size(); ++k)
    {
      problem_.patches[k] = problems::sampled(problem_.patches[k].grid, scene.patches[k]);
    }
  }

  /// Adapts the grids to the pressure until they cover it closely. Returns false if this fails.
  bool findBoxes(const GapScene& scene)
  {
    for (int attempt = 0; attempt < most_boxes; ++attempt)
    {
      fill(scene);
      box_solver_.solve(problem_, false, found_);
      bool hold = found_.status == SolveStatus::converged;
      for (std::size_t k = 0; hold && k < problem_.patches.size(); ++k)
      {
        if (!(found_.patches[k].force > 0))
        {
          return false;
        }
        hold = layBox(found_.patches[k], problem_.patches[k].grid) && hold;
      }
      if (hold)
      {
        return true;
      }
    }
    return false;
  }

  /// Adapts a grid to the pressure found on it. Returns true if it fitted already.
  static bool layBox(const PatchPressure& patch, Grid& grid)
  {
    const PressureExtent extent = findExtent(grid, patch.pressure);
    const double width = extent.y_end - extent.y_begin;
    const double begin = extent.y_begin - (extent.cutBegin(grid) ? 0.4 * width : 0);
    const double end = extent.y_end + (extent.cutEnd(grid) ? 0.4 * width : 0);
    const double length = 2 * extent.half_length * (extent.cutLength(grid) ? 1.4 : 1);
    const bool fits = !extent.cut(grid) && width > 0.6 * grid.ny * grid.dy && length > 0.6 * grid.nx * grid.dx;
    grid = covering(grid, length, 0.5 * (begin + end), end - begin, {grid.nx, grid.ny});
    return fits;
  }

  static Grid covering(const Grid& like, double length, double middle, double width, const GridSize& size)
  {
    const cell_aspect::Cell cell = cell_aspect::coveringCell(margin * length, margin * width, size.along, size.across);
    return {size.along, size.across, cell.dx, cell.dy, middle - 0.5 * (size.across - 1) * cell.dy, like.symmetric};
  }

  /// The same box with other cells.
  static Grid regridded(const Grid& grid, const GridSize& size)
  {
    return covering(grid, grid.nx * grid.dx / margin, middleOf(grid), grid.ny * grid.dy / margin, size);
  }

  static double middleOf(const Grid& grid) { return grid.y0 + 0.5 * (grid.ny - 1) * grid.dy; }

  /// A random box, as tight or loose as the package uses them, shifted by parts of a cell.
  static Grid randomBox(Random& random, const Grid& tight, const GridSize& size)
  {
    const bool close = oneIn(random, 2);
    const double looseness = close ? 1 : uniform(random, 1, 1.25);
    const double length = tight.nx * tight.dx / margin * looseness, width = tight.ny * tight.dy / margin * looseness;
    const double shift = (close ? 0.005 : 0.04) * uniform(random, -1, 1) * width;
    return covering(tight, length, middleOf(tight) + shift, width, size);
  }

  bool add(NormalMethod method, const NormalSolver& solver, std::vector<ErrorSample>& samples) const
  {
    for (std::size_t k = 0; k < coarse_.patches.size(); ++k)
    {
      const double touch = problem_.patches[k].gap.minCoeff();
      const double found_approach = found_.approach - touch, true_approach = true_.approach - touch;
      if (!(found_.patches[k].force > 0))
      {
        return false;
      }
      ErrorSample sample = describe(method, solver, coarse_, found_, k, found_approach);
      sample.error = relativeErrors(found_.patches[k], found_approach, true_.patches[k], true_approach);
      samples.push_back(sample);
    }
    return true;
  }

  ConjugateGradients box_solver_;
  NormalProblem problem_, coarse_;
  NormalSolution found_, true_;
};

/// Solves a state on the grid of `fine`, from a solution on that of `coarse`, the levels of the balance. The result is
/// that of a cold start on the fine grid, but most solutions of the search are on the coarse one. Both must have the
/// same method and tolerance.
inline ContactStatus solveFromCoarse(WheelsetBalance& balance, GridLevels& coarse, GridLevels& fine,
                                     const WheelsetState& state)
{
  balance.solve(state);  // if it fails, the next one starts cold
  std::swap(coarse, fine);
  const ContactStatus status = balance.solve(state);
  std::swap(coarse, fine);
  return status;
}

/// A wheelset S1002 on the UIC60 rail of the benchmark or on 60E1.
struct WheelsetScene
{
  ContactModelConfig config;
  WheelsetState state;
};

inline WheelsetScene randomWheelsetScene(Random& random)
{
  static const auto wheel = std::make_shared<const Profile>(s1002Wheel());
  static const auto rail_60e1 = std::make_shared<const Profile>(rail60E1());
  static const auto rail_uic60 = std::make_shared<const Profile>(railUic60Manchester());
  WheelsetScene scene;
  scene.config.wheel_profile = wheel;
  scene.config.rail_profile = oneIn(random, 2) ? rail_60e1 : rail_uic60;
  scene.config.track.rail_inclination = oneIn(random, 2) ? 1.0 / 40 : 1.0 / 20;
  scene.config.track.gauge = uniform(random, 1.43, 1.44);
  scene.state.y = uniform(random, -7e-3, 7e-3);
  scene.state.yaw = oneIn(random, 2) ? 0 : uniform(random, -0.02, 0.02);
  scene.state.force_z = -2e3 * spread(random, 5, 150);
  return scene;
}

/// Solves wheelset scenes with the whole calculation. The balance is converged so far that only the error of the cells
/// remains. Keeps the solvers, because their preparation costs more than a solution.
class WheelsetSampler
{
 public:
  explicit WheelsetSampler(NormalMethod method) : method_(method) {}

  /// Adds a sample for every contact of a wheel that has as many contacts in the reference. Returns false if this does
  /// not hold for both wheels, or if the scene has no solution.
  bool sample(const WheelsetScene& scene, const GridSize& size, std::vector<ErrorSample>& samples)
  {
    const GridSize true_size{finer * size.along, finer * size.across};
    ContactModelConfig strict = scene.config;
    strict.contact.tolerance = 1e-4;
    ContactModelConfig settled = scene.config;
    if (method_ == NormalMethod::conjugate_gradient)
    {
      settled.contact.tolerance = settledTolerance(size);
    }
    const GridLevels& levels = levelsFor(method_, size);
    WheelsetBalance balance(settled, levels);
    WheelsetBalance truth(strict, levelsFor(NormalMethod::conjugate_gradient, true_size));
    if (balance.solve(scene.state) != ContactStatus::ok || truth.solve(scene.state) != ContactStatus::ok)
    {
      return false;
    }
    const std::size_t before = samples.size();
    bool alike = true;
    for (const Side side : {Side::left, Side::right})
    {
      alike = add(levels.solver(), side, balance, truth, samples) && alike;
    }
    return alike && samples.size() > before;
  }

  /// Solver of a method on a grid; kept for further calls.
  const GridLevels& levelsFor(NormalMethod method, const GridSize& size)
  {
    std::unique_ptr<GridLevels>& levels = solvers_[{static_cast<int>(method), size.along, size.across}];
    if (!levels)
    {
      ContactModelConfig config;
      config.contact = {method, settledTolerance(size), size.along, size.across};
      levels = std::make_unique<GridLevels>(config);
    }
    return *levels;
  }

 private:
  /// Tolerance at which the remaining error of the balance is smaller than that of the cells [-].
  static double settledTolerance(const GridSize& size) { return std::min(2e-3, 1.0 / (size.along * size.across)); }

  /// Approach of a contact from its first touch [m].
  static double approachOf(Side side, const WheelsetBalance& balance, std::size_t k)
  {
    PatchResult patch;
    fillPatch(side, balance, k, patch);
    return patch.approach;
  }

  /// @return false if the wheel has another number of contacts in the reference
  bool add(const NormalSolver& solver, Side side, const WheelsetBalance& balance, const WheelsetBalance& truth,
           std::vector<ErrorSample>& samples) const
  {
    const Islands &found = balance.islands(side), &fine = truth.islands(side);
    const std::size_t count = found.islands().size();
    const bool alike = count == fine.islands().size();
    for (std::size_t k = 0; alike && k < count; ++k)
    {
      const double approach = approachOf(side, balance, k);
      ErrorSample sample = describe(method_, solver, found.problem(), found.solution(), k, approach);
      sample.error =
          relativeErrors(found.solution().patches[k], approach, fine.solution().patches[k], approachOf(side, truth, k));
      samples.push_back(sample);
    }
    return alike;
  }

  NormalMethod method_;
  std::map<std::array<int, 3>, std::unique_ptr<GridLevels>> solvers_;
};
}  // namespace wheel_rail_contact::core::scenes
