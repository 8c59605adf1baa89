// SPDX-License-Identifier: BSD-3-Clause
#include "crest_pressure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact_edge.h"
#include "pressure_crests.h"

namespace wheel_rail_contact
{
namespace
{
using Eigen::Index;

const double pi = std::acos(-1.0);

constexpr int reach = 6;  ///< columns looked at to either side of the crest
constexpr int width = 2 * reach + 1;
constexpr int between = width - 1;  ///< places between columns

/// Jumps of less are smooth; cells are wrong by a fiftieth of it at most.
constexpr double least_jump = 0.01;
/// Second differences of more are the end of a body; those of joints are below 3.
constexpr double no_surface = 5;
constexpr int edge_cells = 5;  ///< from the edge inward, whose pressure is known to be off
/// How far an edge may lie beyond the centre of the outermost loaded cell [cells], see edgeDistance().
constexpr double least_beyond = -0.175, most_beyond = 0.825;

/// The crest's row, columns from -reach to reach. Pressures are over the crest's.
struct Row
{
  std::array<double, width> p{};       ///< zero beyond the grid
  std::array<double, width> second{};  ///< second differences of the gap as pressures
  std::array<bool, width> known{};     ///< whether they are, of loaded cells
  int first = 0, last = 0;             ///< outermost columns of the grid, at most `reach` away

  double at(int offset) const { return p[static_cast<std::size_t>(offset + reach)]; }
};

/// A jump of the gap's curvature.
struct Jump
{
  double place = 0;  ///< from the crest [cells]
  double size = 0;   ///< jump of the second difference as a pressure over the crest's
};

struct Jumps
{
  std::array<Jump, between> list;
  std::size_t count = 0;

  const Jump* begin() const { return list.data(); }
  const Jump* end() const { return list.data() + count; }
};

Row readRow(const PatchGap& gap, double modulus, const Eigen::ArrayXXd& pressure, Index row, Index column)
{
  const double top = pressure(row, column);
  const double as_pressure = modulus / (gap.grid.dy * top);
  Row line;
  for (int o = -reach; o <= reach; ++o)
  {
    const Index j = column + o;
    const auto k = static_cast<std::size_t>(o + reach);
    if (j >= 0 && j < pressure.cols())
    {
      line.p[k] = pressure(row, j) / top;
      line.first = std::min(line.first, o);
      line.last = o;
    }
    if (line.p[k] > 0 && j > 0 && j + 1 < pressure.cols())
    {
      line.second[k] = as_pressure * (gap.gap(row, j + 1) - 2 * gap.gap(row, j) + gap.gap(row, j - 1));
      line.known[k] = std::abs(line.second[k]) < no_surface;
    }
  }
  return line;
}

/// Steps of the second differences between the columns, less what those two columns on to either side share with
/// them: a curvature that changes smoothly. Zero within two of the ends.
std::array<double, between> stepsBesideSmooth(const Row& row)
{
  std::array<double, between> steps{}, sharp{};
  for (std::size_t k = 0; k < between; ++k)
  {
    steps[k] = row.known[k] && row.known[k + 1] ? row.second[k + 1] - row.second[k] : 0;
  }
  for (std::size_t k = 2; k + 2 < between; ++k)
  {
    const bool smooth = steps[k - 2] * steps[k] > 0 && steps[k + 2] * steps[k] > 0;
    const double shared = smooth ? std::min(std::abs(steps[k - 2]), std::abs(steps[k + 2])) : 0;
    sharp[k] = std::copysign(std::max(std::abs(steps[k]) - shared, 0.0), steps[k]);
  }
  return sharp;
}

/// Takes the greatest step with those beside it of the same sign for one jump, then the greatest of the others.
Jumps findJumps(const Row& row)
{
  std::array<double, between> steps = stepsBesideSmooth(row);
  Jumps found;
  const auto less = [](double a, double b) { return std::abs(a) < std::abs(b); };
  for (;;)
  {
    const auto greatest = static_cast<std::size_t>(std::max_element(steps.begin(), steps.end(), less) - steps.begin());
    const double step = steps[greatest];
    if (!(std::abs(step) > least_jump))
    {
      return found;
    }
    Jump jump;
    double moment = 0;
    for (std::size_t k = greatest - 1; k <= greatest + 1; ++k)
    {
      if (steps[k] * step > 0)
      {
        jump.size += steps[k];
        moment += steps[k] * (static_cast<double>(k) - reach + 0.5);
        steps[k] = 0;
      }
    }
    jump.place = moment / jump.size;
    found.list[found.count++] = jump;
  }
}

/// Two jumps to and fro within a few cells are the flanks of a wave, as rough profiles have them.
bool areWave(const Jump& one, const Jump& other)
{
  constexpr double near = 4, alike = 1.0 / 3;
  const double larger = std::max(std::abs(one.size), std::abs(other.size));
  return std::abs(one.place - other.place) < near && one.size * other.size < -alike * larger * larger;
}

bool areWaves(const Jumps& found)
{
  return std::any_of(
      found.begin(), found.end(),
      [&](const Jump& one)
      { return std::any_of(found.begin(), found.end(), [&one](const Jump& other) { return areWave(one, other); }); });
}

/// True pressure beside a jump of one, but for what is linear in t.
double partOfJump(double t)
{
  return t == 0 ? 0 : -t * std::log(std::abs(t)) / (2 * pi);
}

/// What the cells' pressure exceeds the root of the distance by near an edge, in the n-th loaded cell from there (0:
/// the outermost), over the root's factor; `beyond` is how far the edge lies beyond the outermost cell's centre
/// [cells]. Numbers as of edgeDistance(), from a line contact of 300 cells' width.
double cellErrorAtEdge(int n, double beyond)
{
  constexpr std::array<std::array<double, 2>, edge_cells> line{
      {{0.16667, 0.95456}, {1.0255, 0.40656}, {1.41792, 0.32562}, {1.73431, 0.27283}, {2.00136, 0.23975}}};
  const auto& [constant, slope] = line[static_cast<std::size_t>(n)];
  return constant + slope * beyond - std::sqrt(std::max(beyond + n, 0.0));
}

/// Takes off what the edge beyond the crest on the side `outward` (+1 or -1) makes of three cells' pressures. Where the
/// pressure is cut by the grid's border there is none.
void takeOffEdge(const Row& row, int outward, std::array<double, 3>& p)
{
  int last = 1;
  while (last < reach && row.at(outward * (last + 1)) > 0)
  {
    ++last;
  }
  const double p1 = row.at(outward * last), p2 = row.at(outward * (last - 1)), p3 = row.at(outward * (last - 2));
  if (last >= (outward < 0 ? -row.first : row.last) || !(p1 < p2))
  {
    return;
  }
  const double beyond = std::clamp(edgeDistance(p1, p2, p3), least_beyond, most_beyond);
  const double root = p2 / (cellErrorAtEdge(1, beyond) + std::sqrt(beyond + 1));
  for (int side = -1; side <= 1; ++side)
  {
    const int from_edge = last - side;
    if (from_edge >= 0 && from_edge < edge_cells)
    {
      p[static_cast<std::size_t>(1 + outward * side)] -= root * cellErrorAtEdge(from_edge, beyond);
    }
  }
}

/// Highest square between three cells across, of which the middle one is the crest: on a parabola, besides the parts of
/// jumps.
double topAcross(const std::array<double, 3>& p, const Jumps& near)
{
  const std::array<double, 3> q{p[0] * p[0], p[1] * p[1], p[2] * p[2]};
  if (near.count == 0)
  {
    const bool highest = q[1] >= q[0] && q[1] >= q[2];
    return highest ? q[1] + riseOf(p[0], p[1], p[2]) : std::max(q[0], q[2]);
  }
  const auto part = [&near](double y)
  {
    double sum = 0;
    for (const Jump& jump : near)
    {
      sum += 2 * jump.size * partOfJump(y - jump.place);
    }
    return sum;
  };
  const double before = q[0] - part(-1), here = q[1] - part(0), after = q[2] - part(1);
  const double slope = 0.5 * (after - before), bend = 0.5 * (after + before) - here;
  constexpr int steps = 8;  // to either side
  double top = 0;
  for (int k = -steps; k <= steps; ++k)
  {
    const double y = static_cast<double>(k) / steps;
    top = std::max(top, here + (slope + bend * y) * y + part(y));
  }
  return top;
}

/// By how much cells hold more than the highest pressure of smooth bends, over it [-], from bendOf() along and across
/// over the crest's square. A constant pressure on a cell that has to meet the contact condition in its centre exceeds
/// the pressure there by bend / 48 (to first order, for waves of any direction: the mean of the influence over a cell
/// is that much less than in its centre). A smaller approach takes part of it back, and across nearly all. Numbers
/// fitted to 32 000 patches of wheelsets on the grids of `auto`, and of 4 and 6 cells along: of smooth contacts they
/// leave less than 0.03 % on 16 × 48 cells, 0.2 % on 8 × 16 in nine of ten.
double excess(double along, double across)
{
  return along * std::min(0.011 + 0.1 * along, 0.022) + 0.006 * across * across;
}
}  // namespace

double cellErrorAtJump(double t)
{
  /// The cells' pressure, one cell after the other: constant, linear and square.
  constexpr std::array<std::array<double, 3>, 3> cells{
      {{0, 0.20575, -0.19467}, {0.14974, -0.09373, -0.04494}, {0.20416, -0.14814, -0.03134}}};
  const double x = std::abs(t);
  double error = 1 / (48 * pi * x);
  if (x < static_cast<double>(cells.size()))
  {
    const auto& [constant, linear, square] = cells[static_cast<std::size_t>(x)];
    error = constant + x * (linear + square * x) - partOfJump(x);
  }
  return t < 0 ? -error : error;
}

bool showsWaves(const PatchGap& gap, double modulus, const Eigen::ArrayXXd& pressure, Index row, Index column)
{
  return areWaves(findJumps(readRow(gap, modulus, pressure, row, column)));
}

double crestPressure(const PatchGap& gap, double modulus, const Eigen::ArrayXXd& pressure, Index row, Index column)
{
  const double top = pressure(row, column);
  const auto [along, across] = linesThrough(gap.grid, pressure, row, column);
  if (!across.isInside())
  {
    return top;
  }
  const Row cells = readRow(gap, modulus, pressure, row, column);
  const Jumps found = findJumps(cells);
  const bool waves = areWaves(found);
  const Jumps jumps = waves ? Jumps() : found;
  std::array<double, 3> p{across.p(-1), across.p(0), across.p(1)};
  takeOffEdge(cells, -1, p);
  takeOffEdge(cells, 1, p);
  for (const Jump& jump : jumps)
  {
    for (int side = -1; side <= 1; ++side)
    {
      double& cell = p[static_cast<std::size_t>(side + 1)];
      cell = std::max(cell - jump.size * cellErrorAtJump(side - jump.place), 0.0);
    }
  }
  const double q = topAcross(p, jumps);
  const double raised = (1 - excess(along.bend(), across.bend())) * std::sqrt(q + along.rise());
  return top * (waves ? std::max(raised, 1.0) : raised);
}
}  // namespace wheel_rail_contact
