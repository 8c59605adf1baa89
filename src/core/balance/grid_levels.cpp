// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/grid_levels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/normal/solvers/conjugate_gradients.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Residual of the normal solution per unit of contact/tolerance [-]. In 150 random wheelsets the errors of pressure
/// and area due to the residual were below the residual in 90 % of the cases and below three times the residual in 99 %
/// of them.
constexpr double residual_per_tolerance = 0.02;
/// Smallest residual. Also used where rail deflection and contact forces must agree closely [-].
constexpr double least_residual = 1e-6;

constexpr GridSize rough_grid{10, 24};
constexpr GridSize closed_form_grid{8, 16};  ///< to sample the gap and to return the ellipsoid

/// Number of cells up to which a grid is prepared for all cell shapes. On a larger grid, which can only be set by hand,
/// a shape is prepared at its first use: preparing all of them would take seconds.
constexpr int most_prepared_cells = 64 * 128;

/// In the order of the computing time. In smooth contacts, additional cells along the track reduce the error more than
/// cells across it, and the coarser half of the grids is sufficient. Curvature jumps need cells across the track,
/// narrow ends need cells along it.
///
/// Ordinary errors and typical estimates (highest pressure, area without narrow ends, approach, narrow ends) are the
/// output of test/calibration/calibrate_grid_levels.cpp for 300 scenes of seed 3, before the estimates of pressure
/// peaks and curvature discontinuities were changed to the present ones. Its present output predicts lower errors of
/// the pressure on coarse grids and of the area on fine grids. With it, the jump between tread and flange took a third
/// longer at 0.3 %, and other scenes took no less time.
///
/// The middle half of the estimates lies within a factor of 1 to 3. The exceptions are a factor of 5 for areas on the
/// finest grids, where they dominate few contacts, and a factor of 9 for narrow ends.
constexpr std::array<GridLevel, 17> levels{{{{8, 16}, 0.0360, {79.7, 12.4, 7.56, 10.2}},
                                            {{10, 24}, 0.0074, {19.1, 6.76, 4.84, 7.42}},
                                            {{12, 24}, 0.0066, {17.6, 4.68, 4.84, 2.88}},
                                            {{12, 32}, 0.0047, {6.46, 3.73, 4.84, 4.18}},
                                            {{16, 32}, 0.0038, {5.69, 2.63, 2.47, 2.24}},
                                            {{16, 48}, 0.0022, {1.77, 2.03, 2.47, 1.67}},
                                            {{12, 64}, 0.0021, {1.1, 2.31, 4.84, 24.7}},
                                            {{20, 48}, 0.0015, {1.51, 1.42, 1.49, 1.33}},
                                            {{16, 64}, 0.0016, {0.864, 1.39, 2.47, 3.92}},
                                            {{24, 56}, 0.0007, {1, 1, 1, 1}},
                                            {{16, 80}, 0.0015, {0.364, 2.11, 2.47, 2.88}},
                                            {{16, 96}, 0.0014, {0.238, 2.1, 2.47, 3.64}},
                                            {{24, 80}, 0.0008, {0.306, 0.971, 1, 1.15}},
                                            {{24, 96}, 0.0006, {0.183, 0.962, 1, 1.08}},
                                            {{32, 96}, 0.0005, {0.172, 0.52, 0.562, 0.516}},
                                            {{48, 96}, 0.0003, {0.153, 0.253, 0.25, 0.259}},
                                            {{64, 128}, 0.0002, {0.0682, 0.145, 0.144, 0.158}}}};

static_assert(levels.size() <= GridLevelChoice::most_levels);

/// Predicts the errors on 24 × 56 cells from the errors estimated on a level. The area part excludes the error of
/// narrow ends. The part due to the residual is left out, because it does not depend on the cells.
ErrorEstimate normalised(const ErrorEstimate& error, const GridLevel& level)
{
  const ErrorEstimate& typical = level.typical;
  const ErrorEstimate algebra = ofResidual(error.residual);
  const auto mesh = [](double all, double other) { return std::max(all - other, 0.0); };
  return {mesh(error.max_pressure, algebra.max_pressure) / typical.max_pressure,
          mesh(error.area, algebra.area + error.narrow_ends) / typical.area,
          mesh(error.approach, algebra.approach) / typical.approach, error.narrow_ends / typical.narrow_ends,
          error.residual};
}

/// Largest error predicted on a level, from the errors predicted on 24 × 56 cells [-].
double predicted(const ErrorEstimate& normal, const GridLevel& level)
{
  const ErrorEstimate& typical = level.typical;
  const ErrorEstimate algebra = ofResidual(normal.residual);
  return std::max({normal.max_pressure * typical.max_pressure + algebra.max_pressure,
                   normal.area * typical.area + normal.narrow_ends * typical.narrow_ends + algebra.area,
                   normal.approach * typical.approach + algebra.approach});
}

GridLevel levelFor(const ContactConfig& contact)
{
  if (contact.cells_along > 0)
  {
    return {{contact.cells_along, contact.cells_across}, 0, {1, 1, 1, 1}, nullptr};
  }
  return *std::find_if(levels.begin(), levels.end() - 1,
                       [&](const GridLevel& level) { return level.ordinary_error <= contact.tolerance; });
}

std::unique_ptr<NormalSolver> makeConjugateGradients(const ContactModelConfig& config,
                                                     const std::vector<GridLevel>& grids)
{
  ConjugateGradientsOptions options;
  options.residual = std::max(residual_per_tolerance * config.contact.tolerance, least_residual);
  const RailBendingConfig& bending = config.rail_bending;
  if (bending.model == RailBendingConfig::Model::compliance &&
      bending.lateral_force != RailBendingConfig::LateralForce::contact)
  {
    options.residual = least_residual;
  }
  auto solver = std::make_unique<ConjugateGradients>(options);
  solver->prepare(rough_grid.along, rough_grid.across);
  for (const GridLevel& level : grids)
  {
    if (level.size.along * level.size.across <= most_prepared_cells)
    {
      solver->prepare(level.size.along, level.size.across);
    }
  }
  return solver;
}

std::unique_ptr<NormalSolver> makeSolver(const ContactModelConfig& config, const std::vector<GridLevel>& grids)
{
  const NormalMethod method = config.contact.method;
  return method == NormalMethod::automatic || method == NormalMethod::conjugate_gradient
             ? makeConjugateGradients(config, grids)
             : makeNormalSolver(method);
}
}  // namespace

GridLevels::GridLevels(const ContactModelConfig& config, const Wrap& wrap) : rough_{}, closed_form_{}
{
  const bool free = config.contact.method == NormalMethod::automatic && config.contact.cells_along == 0;
  levels_ =
      free ? std::vector<GridLevel>(levels.begin(), levels.end()) : std::vector<GridLevel>{levelFor(config.contact)};
  const auto rough =
      std::find_if(levels.begin(), levels.end(), [](const GridLevel& level) { return level.size == rough_grid; });
  rough_ = *rough;
  solver_ = makeSolver(config, levels_);
  if (wrap)
  {
    solver_ = wrap(std::move(solver_));
  }
  for (GridLevel& level : levels_)
  {
    level.solver = solver_.get();
  }
  rough_.solver = solver_.get();
  if (free && config.rail_bending.model != RailBendingConfig::Model::compliance)
  {
    hertz_ = std::make_unique<HertzSolver>();
    closed_form_ = {closed_form_grid, 0, {1, 1, 1, 1}, hertz_.get()};
  }
}

void GridLevelChoice::start(const ErrorEstimate& rough)
{
  closed_form_ = false;
  closed_form_wait_ = 0;
  coarsened_ = false;
  const ErrorEstimate normal = normalised(rough, levels_->rough());
  level_ = 0;
  while (level_ + 1 < levels_->count() &&
         (failsHere(level_) || (level().ordinary_error > tolerance_ && predicted(normal, level()) > tolerance_)))
  {
    ++level_;
  }
}

const GridLevelChoice::Failure* GridLevelChoice::failureHere() const
{
  const Failure& failure = failures_[slot(place_)];
  return failure.place == place_ && results_ - failure.result < remembered ? &failure : nullptr;
}

bool GridLevelChoice::failsHere(std::size_t level) const
{
  const Failure* failure = failureHere();
  return failure != nullptr && level != failure->met_tolerance &&
         (failure->levels[level] || predicted(failure->normal, levels_->at(level)) > clear_failure * tolerance_);
}

void GridLevelChoice::arrive(double place)
{
  place_ = std::lround(place / same_place);
  ++results_;
  while (level_ + 1 < levels_->count() && failsHere(level_))
  {
    ++level_;
  }
  coarsened_ = coarsened_ && level_ < before_;
}

std::size_t GridLevelChoice::nextLevel(const ErrorEstimate& normal, std::size_t highest) const
{
  const Failure* failure = failureHere();
  const auto failed = [failure](std::size_t level) { return failure != nullptr && failure->levels[level]; };
  std::size_t best = level_;
  double least = predicted(normal, level());
  for (std::size_t next = level_ + 1; next < levels_->count(); ++next)
  {
    const bool found = best > level_, beyond = next > highest;
    if (beyond ? found || coarsened_ : found && least <= tolerance_)
    {
      break;
    }
    const double error = predicted(normal, levels_->at(next));
    if (!failed(next) && error < least)
    {
      best = next;
      least = error;
    }
  }
  if (best == level_)
  {
    ++best;
    while (best < highest && failed(best))
    {
      ++best;
    }
  }
  return best;
}

bool GridLevelChoice::refine(const ErrorEstimate& error)
{
  if (closed_form_)
  {
    return error.largest() > closedFormLimit() && leaveClosedForm();
  }
  if (error.largest() <= tolerance_ || level_ + 1 >= levels_->count())
  {
    return false;
  }
  const ErrorEstimate normal = normalised(error, level());
  const Failure* before = failureHere();
  Failure failure{place_, results_, before != nullptr ? before->levels : std::bitset<most_levels>(), normal, no_level};
  failure.levels.set(level_);
  failures_[slot(place_)] = failure;
  level_ = nextLevel(normal, coarsened_ ? before_ : std::min(level_ + longest_refinement, levels_->count() - 1));
  if (coarsened_)
  {
    wait_ = next_wait_;
    next_wait_ = std::min(4 * next_wait_, longest_wait);
    coarsened_ = false;
  }
  return true;
}

void GridLevelChoice::tryClosedForm(const NormalProblem& problem, const NormalSolution& solution)
{
  if (closed_form_ || levels_->closedForm() == nullptr || --closed_form_wait_ > 0)
  {
    return;
  }
  closed_form_wait_ = between_tries;
  if (HertzSolver::canSolve(problem))
  {
    levels_->closedForm()->solver->estimateErrors(problem, solution, scratch_);
    closed_form_ = largestOf(scratch_).largest() < coarsen_reserve * closedFormLimit();
  }
}

double GridLevelChoice::closedFormLimit() const
{
  return std::min(tolerance_, round_enough);
}

bool GridLevelChoice::leaveClosedForm()
{
  const bool left = closed_form_;
  closed_form_ = false;
  return left;
}

void GridLevelChoice::coarsen(const ErrorEstimate& error)
{
  if (closed_form_)
  {
    coarsened_ = false;
    return;
  }
  Failure& failure = failures_[slot(place_)];
  failure.met_tolerance = failureHere() != nullptr && error.largest() <= tolerance_ ? level_ : failure.met_tolerance;
  const ErrorEstimate decayed{decay * recent_.max_pressure, decay * recent_.area, decay * recent_.approach,
                              decay * recent_.narrow_ends, decay * recent_.residual};
  recent_ = largestOf(normalised(error, level()), decayed);
  before_ = level_;
  wait_ = std::max(wait_ - 1, 0);
  if (coarsened_)
  {
    next_wait_ = std::max(next_wait_ / 2, first_wait);
  }
  const double reserve = wait_ > 0 ? large_reserve : coarsen_reserve;
  std::size_t coarser = 0;
  while (coarser < level_ && (failsHere(coarser) || predicted(recent_, levels_->at(coarser)) >= reserve * tolerance_))
  {
    ++coarser;
  }
  level_ = coarser;
  coarsened_ = level_ < before_;
}
}  // namespace wheel_rail_contact::core
