// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "../core/normal/error_samples.h"
#include "core/normal/solvers/hertz.h"

/// Contacts solved so accurately that only the error of the cells remains, with their true values: samples for fits.
namespace wheel_rail_contact::core::fits
{
/// A patch that is the only one of its problem.
struct Contact
{
  const PatchGap& gap;
  double modulus;  ///< [Pa]
  const PatchPressure& found;
  double true_area;      ///< [m²]
  double true_pressure;  ///< highest pressure [Pa]
};

constexpr std::array<GridSize, 20> grids{{{4, 16},  {6, 16},  {6, 24},  {8, 16},  {8, 24},  {10, 24}, {12, 24},
                                          {12, 32}, {16, 32}, {16, 48}, {12, 64}, {20, 48}, {16, 64}, {24, 56},
                                          {16, 80}, {16, 96}, {24, 80}, {32, 64}, {32, 96}, {48, 96}}};

/// Hertz contacts of B/A from 0.1 to 20 on one of the grids. A quarter is rotated by up to 0.3 rad, a quarter covers
/// only few cells. They are shifted from the middle of the grid by parts of a cell.
class HertzContacts
{
 public:
  template <typename Visit>
  void visit(scenes::Random& random, Visit visit)
  {
    constexpr double modulus = 1.14e11, load = 1e4;
    const GridSize size = grids[random() % grids.size()];
    const bool symmetric = scenes::oneIn(random, 2), few = scenes::oneIn(random, 4);
    const double angle = symmetric || scenes::oneIn(random, 2) ? 0 : scenes::uniform(random, 0, 0.3);
    const double ratio = std::exp(scenes::uniform(random, std::log(0.1), std::log(20)));
    const HertzContact hertz = hertzForForce({1, ratio}, modulus, load);
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const double along = std::hypot(hertz.semi_axis_x * cosine, hertz.semi_axis_y * sine);
    const double across = std::hypot(hertz.semi_axis_y * cosine, hertz.semi_axis_x * sine);
    const double margin_along = few ? scenes::uniform(random, 1.1, size.along / 2.5) : usualMargin(random);
    const double margin_across = few ? scenes::uniform(random, 1.1, size.across / 3.0) : usualMargin(random);
    const cell_aspect::Cell cell =
        cell_aspect::coveringCell(2 * margin_along * along, 2 * margin_across * across, size.along, size.across);
    const double x0 = symmetric ? 0 : scenes::uniform(random, -0.5, 0.5) * cell.dx;
    const double y0 = scenes::uniform(random, -0.5, 0.5) * cell.dy;
    const auto gap = [=](double x, double y)
    {
      const double u = (x - x0) * cosine + (y - y0) * sine, v = (y - y0) * cosine - (x - x0) * sine;
      return u * u + ratio * v * v;
    };
    NormalProblem problem;
    problem.modulus = modulus;
    problem.value = load;
    problem.patches.resize(1);
    problem.patches[0].grid = {size.along, size.across, cell.dx, cell.dy, -0.5 * (size.across - 1) * cell.dy,
                               symmetric};
    scenes::sample(gap, problem.patches[0]);
    solver_.solve(problem, false, solution_);
    if (solution_.status == SolveStatus::converged && !solution_.patches[0].touches_border)
    {
      visit(Contact{problem.patches[0], modulus, solution_.patches[0], hertz.area, hertz.max_pressure});
    }
  }

 private:
  static double usualMargin(scenes::Random& random) { return scenes::uniform(random, 1.03, 1.35); }

  ConjugateGradients solver_{scenes::strictOptions()};
  NormalSolution solution_;
};

/// A wheel; the gap across is A y² + B y⁴.
inline scenes::GapScene quarticScene(scenes::Random& random)
{
  const double along = 0.5 / scenes::uniform(random, 0.3, 0.6);
  const double square = scenes::spread(random, 0.05, 20), fourth = scenes::spread(random, 1e2, 1e5);
  return {"quartic",
          true,
          {[=](double x, double y) { return along * x * x + (square + fourth * y * y) * y * y; }},
          1e3 * scenes::spread(random, 5, 150)};
}

/// Smooth gap with a varying curvature: half of them bowls (gap_scenes.h), half quartics.
inline scenes::GapScene smoothScene(scenes::Random& random)
{
  return scenes::oneIn(random, 2) ? scenes::randomBowlScene(random) : quarticScene(random);
}

/// One scene in three is yawed.
inline scenes::GapScene evenOrYawed(scenes::Random& random, const char* kind, const scenes::Gap& gap, double load)
{
  const bool even = !scenes::oneIn(random, 3);
  return {kind, even, {even ? gap : scenes::yawed(random, gap)}, load};
}

/// Paraboloid whose curvature across jumps near the edge of the contact: by up to ten times its value, or to concave.
inline scenes::GapScene edgeDiscontinuityScene(scenes::Random& random)
{
  const double load = 1e3 * scenes::spread(random, 5, 150);
  const double along = 0.5 / scenes::spread(random, 0.1, 1), across = along * std::exp(scenes::uniform(random, -3, 3));
  const double edge = hertzForForce({along, across}, 1.14e11, load).semi_axis_y;
  const double discontinuity = scenes::uniform(random, 0.4, 1.4) * edge, most = scenes::oneIn(random, 4) ? 10 : 3;
  const double jump = scenes::uniform(random, -1.3, most) * across;
  const scenes::Gap gap = [=](double x, double y)
  {
    const double beyond = std::max(y - discontinuity, 0.0);
    return along * x * x + across * y * y + jump * beyond * beyond;
  };
  return evenOrYawed(random, "discontinuity at the edge", gap, load);
}

/// Gap whose curvature jumps or varies within a few cells. Half of them have one jump near the edge, the others are
/// arcs of a rail head, lobes and waves (gap_scenes.h).
inline scenes::GapScene discontinuityScene(scenes::Random& random)
{
  if (scenes::oneIn(random, 2))
  {
    return edgeDiscontinuityScene(random);
  }
  const bool arcs = scenes::oneIn(random, 2), waves = scenes::oneIn(random, 2);
  const scenes::Gap gap = arcs    ? scenes::discontinuityGap(random)
                          : waves ? scenes::roughGap(random)
                                  : scenes::lobesGap(random);
  const double load = 1e3 * scenes::spread(random, 5, 150);
  return evenOrYawed(random, arcs ? "arcs" : waves ? "waves" : "lobes", gap, load);
}

/// Gaps on one of the grids, against cells four times finer in each direction.
class GapContacts
{
 public:
  template <typename Visit>
  void visit(const scenes::GapScene& scene, scenes::Random& random, Visit visit)
  {
    const GridSize size = grids[random() % grids.size()];
    if (sampler_.solve(scenes::Method::grid, solver_, scene, size, random) && sampler_.found().patches[0].force > 0 &&
        !sampler_.found().patches[0].touches_border)
    {
      const PatchPressure& fine = sampler_.truth().patches[0];
      visit(Contact{sampler_.problem().patches[0], sampler_.problem().modulus, sampler_.found().patches[0], fine.area,
                    fine.max_pressure});
    }
  }

 private:
  scenes::GapSampler sampler_;
  ConjugateGradients solver_{scenes::strictOptions()};
};

/// Wheels with a single contact, on each of the grids. The reference has 192 × 512 cells and uses the present weights.
class WheelsetContacts
{
 public:
  template <typename Visit>
  void visit(const scenes::WheelsetScene& scene, Visit visit)
  {
    ContactModelConfig settled = scene.config;
    settled.contact.tolerance = 1e-4;
    WheelsetBalance truth(settled, sampler_.levelsFor(scenes::Method::grid, {192, 512}));
    if (truth.solve(scene.state) != ContactStatus::ok)
    {
      return;
    }
    for (const GridSize& size : grids)
    {
      WheelsetBalance balance(settled, sampler_.levelsFor(scenes::Method::grid, size));
      if (balance.solve(scene.state) != ContactStatus::ok)
      {
        continue;
      }
      for (const Side side : {Side::left, Side::right})
      {
        const Islands &found = balance.islands(side), &exact = truth.islands(side);
        if (found.islands().size() == 1 && exact.islands().size() == 1)
        {
          const PatchPressure& fine = exact.solution().patches[0];
          const NormalProblem& problem = found.problem();
          visit(
              Contact{problem.patches[0], problem.modulus, found.solution().patches[0], fine.area, fine.max_pressure});
        }
      }
    }
  }

 private:
  scenes::WheelsetSampler sampler_{scenes::Method::grid};
};

/// Number of contacts of each kind; of wheelsets the number of scenes.
struct Counts
{
  int wheelsets = 0, hertz = 0, gaps = 0, discontinuities = 0;
};

template <typename Visit>
void visitContacts(const Counts& counts, unsigned long seed, Visit visit)
{
  scenes::Random seeds(seed);
  HertzContacts hertz;
  for (int i = 0; i < counts.hertz; ++i)
  {
    hertz.visit(seeds, visit);
  }
  GapContacts gaps;
  for (int i = 0; i < counts.gaps + counts.discontinuities; ++i)
  {
    scenes::Random random(seeds());
    gaps.visit(i < counts.gaps ? smoothScene(random) : discontinuityScene(random), random, visit);
    std::fprintf(stderr, "\rseed %lu: %d of %d gaps", seed, i + 1, counts.gaps + counts.discontinuities);
  }
  WheelsetContacts wheelsets;
  for (int i = 0; i < counts.wheelsets; ++i)
  {
    scenes::Random random(seeds());
    wheelsets.visit(scenes::randomWheelsetScene(random), visit);
    std::fprintf(stderr, "\rseed %lu: %d of %d wheelsets", seed, i + 1, counts.wheelsets);
  }
  std::fprintf(stderr, "\n");
}

/// Collects the samples that add(contact, samples), declared with the type of the samples, makes of the contacts.
template <typename Samples>
Samples collect(const Counts& counts, unsigned long seed)
{
  Samples samples;
  visitContacts(counts, seed, [&](const Contact& contact) { add(contact, samples); });
  return samples;
}
}  // namespace wheel_rail_contact::core::fits
