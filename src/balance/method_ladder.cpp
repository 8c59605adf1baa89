// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/balance/method_ladder.h"

#include <algorithm>
#include <array>

#include "wheel_rail_contact/normal/conjugate_gradients.h"
#include "wheel_rail_contact/normal/hertz_solver.h"
#include "wheel_rail_contact/normal/kik_piotrowski.h"
#include "wheel_rail_contact/normal/seidel.h"

namespace wheel_rail_contact
{
namespace
{
/// Residual of the normal solution where rail deflection and contact forces have to agree closely [-].
constexpr double coupled_residual = 1e-6;

constexpr GridSize rough_grid{8, 24};

/// Cells of the largest grid that is prepared for all shapes of patches. On a larger one, which can only be given by
/// hand, a shape is prepared when it is first met: all of them would take seconds.
constexpr int most_prepared_cells = 64 * 128;

/// Smooth contacts need cells along more than across, curvature jumps the other way round: the grids grow by turns.
/// Ordinary errors: of 95 % of the patches of S1002 on UIC60 between y = -7 mm and 7 mm. Typical estimates: medians
/// over random wheelset scenes.
constexpr std::array<Rung, 9> rungs{{{{8, 16}, 0.085, 0.0150},
                                     {{8, 24}, 0.03, 0.0120},
                                     {{12, 32}, 0.018, 0.0062},
                                     {{16, 48}, 0.014, 0.0042},
                                     {{24, 56}, 0.005, 0.0026},
                                     {{32, 64}, 0.0030, 0.0019},
                                     {{32, 96}, 0.0020, 0.0019},
                                     {{48, 96}, 0.0015, 0.0013},
                                     {{64, 128}, 0.0010, 0.0010}}};

Rung rungFor(const ContactConfig& contact)
{
  if (contact.cells_along > 0)
  {
    return {{contact.cells_along, contact.cells_across}, 0, 0};
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

MethodLadder::MethodLadder(const ContactModelConfig& config) : rough_{}
{
  const bool free = config.contact.method == NormalMethod::automatic && config.contact.cells_along == 0;
  rungs_ = free ? std::vector<Rung>(rungs.begin(), rungs.end()) : std::vector<Rung>{rungFor(config.contact)};
  const auto rough = std::find_if(
      rungs.begin(), rungs.end(),
      [](const Rung& rung) { return rung.size.along == rough_grid.along && rung.size.across == rough_grid.across; });
  rough_ = *rough;
  solver_ = makeSolver(config, rungs_);
}

void RungChoice::start(double rough_error)
{
  std::size_t wanted = 0;
  while (wanted + 1 < ladder_->count() && ladder_->at(wanted).ordinary_error > tolerance_ &&
         rough_error * ladder_->at(wanted).typical_estimate > tolerance_ * ladder_->rough().typical_estimate)
  {
    ++wanted;
  }
  rung_ = wanted;
}

bool RungChoice::climb(double error)
{
  if (error <= tolerance_ || rung_ + 1 >= ladder_->count())
  {
    return false;
  }
  const double typical = rung().typical_estimate;
  const std::size_t highest = std::min(rung_ + longest_climb, ladder_->count() - 1);
  do
  {
    ++rung_;
  } while (rung_ < highest && error * rung().typical_estimate > tolerance_ * typical);
  if (descended_)
  {
    wait_ = next_wait_;
    next_wait_ = std::min(4 * next_wait_, longest_wait);
    descended_ = false;
  }
  return true;
}

void RungChoice::descend(double error)
{
  const std::size_t before = rung_;
  wait_ = std::max(wait_ - 1, 0);
  if (descended_)
  {
    next_wait_ = std::max(next_wait_ / 2, first_wait);
  }
  while (wait_ == 0 && rung_ > 0 &&
         error * ladder_->at(rung_ - 1).typical_estimate <
             descend_reserve * tolerance_ * ladder_->at(before).typical_estimate)
  {
    --rung_;
  }
  descended_ = rung_ < before;
}
}  // namespace wheel_rail_contact
