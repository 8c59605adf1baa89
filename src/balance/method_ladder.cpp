// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/balance/method_ladder.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "wheel_rail_contact/normal/conjugate_gradients.h"
#include "wheel_rail_contact/normal/kik_piotrowski.h"
#include "wheel_rail_contact/normal/seidel.h"

namespace wheel_rail_contact
{
namespace
{
/// Residual of the normal solution where rail deflection and contact forces have to agree closely [-].
constexpr double coupled_residual = 1e-6;

constexpr GridSize rough_grid{10, 24};
constexpr GridSize closed_form_grid{8, 16};  ///< on which the gap is looked at and the ellipsoid is told

/// Cells of the largest grid that is prepared for all shapes of patches. On a larger one, which can only be given by
/// hand, a shape is prepared when it is first met: all of them would take seconds.
constexpr int most_prepared_cells = 64 * 128;

/// Smooth contacts need cells along more than across and find enough on the coarser half of the grids; curvature jumps
/// need them across. Ordinary errors and typical estimates (max pressure, area, approach): as
/// test/calibration/calibrate_ladder.cpp printed them for 300 scenes of seed 3; rounded, errors up. The middle 80 % of
/// the largest estimates lie within a factor of 1.6 to 2.4 on the coarser half, of 4 to 7 on the others.
constexpr std::array<Rung, 13> rungs{{{{8, 16}, 0.07, {11.7, 11.3, 7.6}},
                                      {{10, 24}, 0.022, {6.1, 5.2, 5.4}},
                                      {{12, 24}, 0.017, {4.7, 3.8, 4.7}},
                                      {{12, 32}, 0.010, {4.0, 3.1, 4.6}},
                                      {{16, 32}, 0.009, {2.5, 2.2, 2.4}},
                                      {{16, 48}, 0.004, {2.05, 1.51, 2.4}},
                                      {{20, 48}, 0.004, {1.43, 1.26, 1.48}},
                                      {{24, 56}, 0.004, {1.0, 1.0, 1.0}},
                                      {{24, 80}, 0.0020, {0.39, 0.66, 0.93}},
                                      {{24, 96}, 0.0015, {0.30, 0.51, 0.89}},
                                      {{32, 96}, 0.0012, {0.26, 0.46, 0.54}},
                                      {{48, 96}, 0.0008, {0.23, 0.36, 0.27}},
                                      {{64, 128}, 0.0006, {0.12, 0.24, 0.17}}}};

/// What errors estimated on a rung promise on 24 × 56 cells.
ErrorEstimate normalised(const ErrorEstimate& error, const Rung& rung)
{
  return {error.max_pressure / rung.typical.max_pressure, error.area / rung.typical.area,
          error.approach / rung.typical.approach};
}

/// Largest error promised on a rung by what is promised on 24 × 56 cells [-].
double promised(const ErrorEstimate& normal, const Rung& rung)
{
  return std::max({normal.max_pressure * rung.typical.max_pressure, normal.area * rung.typical.area,
                   normal.approach * rung.typical.approach});
}

Rung rungFor(const ContactConfig& contact)
{
  if (contact.cells_along > 0)
  {
    return {{contact.cells_along, contact.cells_across}, 0, {1, 1, 1}, nullptr};
  }
  return *std::find_if(rungs.begin(), rungs.end() - 1,
                       [&](const Rung& rung) { return rung.ordinary_error <= contact.tolerance; });
}

std::unique_ptr<NormalSolver> makeSeidel(SeidelOptions::Form form)
{
  SeidelOptions options;
  options.form = form;
  return std::make_unique<Seidel>(options);
}

std::unique_ptr<NormalSolver> makeConjugateGradients(const ContactModelConfig& config, const std::vector<Rung>& grids)
{
  ConjugateGradientsOptions options;
  const RailBendingConfig& bending = config.rail_bending;
  if (bending.model == RailBendingConfig::Model::compliance &&
      bending.lateral_force != RailBendingConfig::LateralForce::contact)
  {
    options.residual = coupled_residual;
  }
  auto solver = std::make_unique<ConjugateGradients>(options);
  solver->prepare(rough_grid.along, rough_grid.across);
  for (const Rung& rung : grids)
  {
    if (rung.size.along * rung.size.across <= most_prepared_cells)
    {
      solver->prepare(rung.size.along, rung.size.across);
    }
  }
  return solver;
}

std::unique_ptr<NormalSolver> makeSolver(const ContactModelConfig& config, const std::vector<Rung>& grids)
{
  switch (config.contact.method)
  {
    case NormalMethod::hertz:
      return std::make_unique<HertzSolver>();
    case NormalMethod::kik_piotrowski:
      return std::make_unique<KikPiotrowski>();
    case NormalMethod::seidel:
      return makeSeidel(SeidelOptions::Form::repaired);
    case NormalMethod::seidel_printed:
      return makeSeidel(SeidelOptions::Form::printed);
    default:
      return makeConjugateGradients(config, grids);
  }
}
}  // namespace

MethodLadder::MethodLadder(const ContactModelConfig& config) : rough_{}, closed_form_{}
{
  const bool free = config.contact.method == NormalMethod::automatic && config.contact.cells_along == 0;
  rungs_ = free ? std::vector<Rung>(rungs.begin(), rungs.end()) : std::vector<Rung>{rungFor(config.contact)};
  const auto rough = std::find_if(rungs.begin(), rungs.end(), [](const Rung& rung) { return rung.size == rough_grid; });
  rough_ = *rough;
  solver_ = makeSolver(config, rungs_);
  for (Rung& rung : rungs_)
  {
    rung.solver = solver_.get();
  }
  rough_.solver = solver_.get();
  if (free && config.rail_bending.model != RailBendingConfig::Model::compliance)
  {
    hertz_ = std::make_unique<HertzSolver>();
    closed_form_ = {closed_form_grid, 0, {1, 1, 1}, hertz_.get()};
  }
}

void RungChoice::start(const ErrorEstimate& rough)
{
  rung_ = coarsest();
  closed_form_ = false;
  closed_form_wait_ = 0;
  const ErrorEstimate normal = normalised(rough, ladder_->rough());
  while (rung_ + 1 < ladder_->count() && rung().ordinary_error > tolerance_ && promised(normal, rung()) > tolerance_)
  {
    ++rung_;
  }
}

/// The coarsest rung that is not known to fail here.
std::size_t RungChoice::coarsest() const
{
  const Failure& failure = failures_[slot(place_)];
  return failure.place == place_ && answers_ - failure.answer < remembered ? failure.finer : 0;
}

void RungChoice::arrive(double place)
{
  place_ = std::lround(place / same_place);
  ++answers_;
  if (coarsest() > rung_)
  {
    rung_ = coarsest();
    descended_ = false;
  }
}

bool RungChoice::climb(const ErrorEstimate& error)
{
  if (closed_form_)
  {
    return error.largest() > closedFormLimit() && leaveClosedForm();
  }
  if (error.largest() <= tolerance_ || rung_ + 1 >= ladder_->count())
  {
    return false;
  }
  failures_[slot(place_)] = {place_, rung_ + 1, answers_};
  const ErrorEstimate normal = normalised(error, rung());
  const std::size_t highest = std::min(rung_ + longest_climb, ladder_->count() - 1);
  do
  {
    ++rung_;
  } while (rung_ < highest && promised(normal, rung()) > tolerance_);
  if (descended_)
  {
    wait_ = next_wait_;
    next_wait_ = std::min(4 * next_wait_, longest_wait);
    descended_ = false;
  }
  return true;
}

void RungChoice::tryClosedForm(const NormalProblem& problem, const NormalSolution& solution)
{
  if (closed_form_ || ladder_->closedForm() == nullptr || --closed_form_wait_ > 0)
  {
    return;
  }
  closed_form_wait_ = between_tries;
  if (HertzSolver::canSolve(problem))
  {
    ladder_->closedForm()->solver->estimateErrors(problem, solution, scratch_);
    closed_form_ = largestOf(scratch_).largest() < descend_reserve * closedFormLimit();
  }
}

double RungChoice::closedFormLimit() const
{
  return std::min(tolerance_, round_enough);
}

bool RungChoice::leaveClosedForm()
{
  const bool left = closed_form_;
  closed_form_ = false;
  return left;
}

void RungChoice::descend(const ErrorEstimate& error)
{
  if (closed_form_)
  {
    return;
  }
  const ErrorEstimate faded{fading * lately_.max_pressure, fading * lately_.area, fading * lately_.approach};
  lately_ = largestOf(normalised(error, rung()), faded);
  const std::size_t before = rung_;
  wait_ = std::max(wait_ - 1, 0);
  if (descended_)
  {
    next_wait_ = std::max(next_wait_ / 2, first_wait);
  }
  const double reserve = wait_ > 0 ? large_reserve : descend_reserve;
  while (rung_ > coarsest() && promised(lately_, ladder_->at(rung_ - 1)) < reserve * tolerance_)
  {
    --rung_;
  }
  descended_ = rung_ < before;
}
}  // namespace wheel_rail_contact
