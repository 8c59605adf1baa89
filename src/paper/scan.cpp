// SPDX-License-Identifier: BSD-3-Clause
#include "paper/scan.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>

#include "paper/one_wheel.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core::paper
{
namespace
{
constexpr GridSize scan_grid{32, 64};
constexpr Range refined_position{-0.1e-3, 0.1e-3, 20};        ///< around a position of the coarse scan [m]
constexpr double near_printed = 0.04;                         ///< largest deviation without bending for addPairs() [-]
constexpr Range refined_inclination{-0.75e-3, 0.75e-3, 6};    ///< around a pair of the coarse scan [rad]
constexpr Range refined_pair_position{-0.12e-3, 0.12e-3, 8};  ///< around a pair of the coarse scan [m]
constexpr Range refined_turn{-1e-3, 1e-3, 8};                 ///< around a pair of the coarse scan [rad]
constexpr double sinking = 1e-3;                              ///< downward displacement in the part "rails" [m]

void solveRow(OneWheel& wheel, ScanRow& row)
{
  wheel.displaceCrown(row.crown);
  row.figures = wheel.solve(row.y, row.roll, row.load) ? wheel.figures() : Figures{0, 0};
}

void add(OneWheel& wheel, ScanRow row, std::vector<ScanRow>& rows)
{
  solveRow(wheel, row);
  rows.push_back(std::move(row));
}

/// A row of a part that searches for pairs.
ScanRow rowFrom(const ScanRow& start, const std::string& part)
{
  ScanRow row = start;
  row.part = part;
  row.without = start.figures;
  return row;
}

double startDeviation(const ScanRow& row)
{
  return deviation(row.figures, printed_without_bending);
}
}  // namespace

Scan::Scan(ContactModelConfig config, NormalSolver& solver, ScanRanges ranges)
    : config_(std::move(config)), solver_(solver), ranges_(std::move(ranges))
{
}

ContactModelConfig Scan::configFor(const std::string& rail, double inclination) const
{
  ContactModelConfig config = config_;
  config.rail_profile = std::make_shared<Profile>(loadProfile(rail, ProfileKind::rail));
  config.track.rail_inclination = inclination;
  return config;
}

std::vector<ScanRow> Scan::start() const
{
  std::vector<ScanRow> rows;
  for (const std::string& rail : ranges_.rails)
  {
    for (const double inclination : ranges_.inclinations)
    {
      OneWheel wheel(configFor(rail, inclination), solver_, scan_grid);
      for (const double load : ranges_.loads)
      {
        for (const double y : ranges_.position.values())
        {
          add(wheel, {"start", rail, inclination, load, y, 0, {}, {}, {}, {}}, rows);
        }
      }
    }
  }
  return rows;
}

std::vector<ScanRow> Scan::nearestStarts(const std::vector<ScanRow>& rows, double limit) const
{
  std::vector<ScanRow> nearest;
  for (const std::string& rail : ranges_.rails)
  {
    for (const double inclination : ranges_.inclinations)
    {
      const ScanRow* best = nullptr;
      for (const ScanRow& row : rows)
      {
        const bool fits = row.rail == rail && row.inclination == inclination && row.load == printed_wheel_load;
        best = fits && (best == nullptr || startDeviation(row) < startDeviation(*best)) ? &row : best;
      }
      if (best == nullptr || startDeviation(*best) > 2 * limit)
      {
        continue;
      }
      OneWheel wheel(configFor(rail, inclination), solver_, scan_grid);
      ScanRow refined = *best;
      for (const double offset : refined_position.values())
      {
        ScanRow row = *best;
        row.y += offset;
        solveRow(wheel, row);
        refined = startDeviation(row) < startDeviation(refined) ? row : refined;
      }
      if (startDeviation(refined) < limit)
      {
        nearest.push_back(refined);
      }
    }
  }
  std::sort(nearest.begin(), nearest.end(),
            [](const ScanRow& a, const ScanRow& b) { return startDeviation(a) < startDeviation(b); });
  return nearest;
}

std::vector<ScanRow> Scan::shift(const ScanRow& start) const
{
  OneWheel wheel(configFor(start.rail, start.inclination), solver_, scan_grid);
  std::vector<ScanRow> rows;
  for (const double lateral : ranges_.pure_shift.values())
  {
    ScanRow row = rowFrom(start, "shift");
    row.crown.lateral = lateral;
    add(wheel, row, rows);
  }
  return rows;
}

std::vector<ScanRow> Scan::pair(const ScanRow& start) const
{
  OneWheel wheel(configFor(start.rail, start.inclination), solver_, scan_grid);
  std::vector<ScanRow> rows;
  for (const double offset : ranges_.position_around_start.values())
  {
    ScanRow row = rowFrom(start, "pair");
    row.y += offset;
    solveRow(wheel, row);
    row.without = row.figures;
    for (const double shift : ranges_.shift)
    {
      for (const double turn : ranges_.turn.values())
      {
        row.crown = {shift, 0, turn};
        add(wheel, row, rows);
      }
    }
  }
  return rows;
}

/// If the results at row.y without deflection are close to the printed ones, adds rows with the rail displaced as
/// printed, and turned.
void Scan::addPairs(OneWheel& wheel, ScanRow row, const Range& turns, std::vector<ScanRow>& rows) const
{
  row.crown = {};
  solveRow(wheel, row);
  row.without = row.figures;
  if (startDeviation(row) > near_printed)
  {
    return;
  }
  for (const double turn : turns.values())
  {
    row.crown = {printed_displacement, 0, turn};
    add(wheel, row, rows);
  }
}

void Scan::refine(const ScanRow& best, std::vector<ScanRow>& rows) const
{
  const Range turns{best.crown.roll + refined_turn.first, best.crown.roll + refined_turn.last, refined_turn.steps};
  for (const double change : refined_inclination.values())
  {
    ScanRow row = best;
    row.inclination += change;
    OneWheel wheel(configFor(row.rail, row.inclination), solver_, scan_grid);
    for (const double offset : refined_pair_position.values())
    {
      row.y = best.y + offset;
      addPairs(wheel, row, turns, rows);
    }
  }
}

std::vector<ScanRow> Scan::inclination(const std::string& rail) const
{
  std::vector<ScanRow> rows;
  for (const double inclination : ranges_.free_inclination.values())
  {
    OneWheel wheel(configFor(rail, inclination), solver_, scan_grid);
    for (const double y : ranges_.position.values())
    {
      addPairs(wheel, {"inclination", rail, inclination, printed_wheel_load, y, 0, {}, {}, {}, {}}, ranges_.turn, rows);
    }
  }
  for (const double direction : {-1.0, 1.0})
  {
    std::optional<ScanRow> best;
    for (const ScanRow& row : rows)
    {
      const bool turned = direction * row.crown.roll > 0;
      best = turned && (!best || row.pairDeviation() < best->pairDeviation()) ? row : best;
    }
    if (best)
    {
      refine(*best, rows);
    }
  }
  return rows;
}

std::vector<ScanRow> Scan::alone(const std::string& rail) const
{
  OneWheel wheel(configFor(rail, config_.track.rail_inclination.left), solver_, scan_grid);
  std::vector<ScanRow> rows;
  for (const double y : ranges_.free_position.values())
  {
    for (const double turn : ranges_.free_turn.values())
    {
      add(wheel,
          {"alone", rail, config_.track.rail_inclination.left, printed_wheel_load, y, 0, {0, 0, turn}, {}, {}, {}},
          rows);
    }
  }
  return rows;
}

std::vector<ScanRow> Scan::roll(const ScanRow& start) const
{
  OneWheel wheel(configFor(start.rail, start.inclination), solver_, scan_grid);
  std::vector<ScanRow> rows;
  for (const double shift : {-printed_displacement, 0.0, printed_displacement})
  {
    for (const double roll : ranges_.roll.values())
    {
      ScanRow row = rowFrom(start, "roll");
      row.crown.lateral = shift;
      row.roll = roll;
      add(wheel, row, rows);
    }
  }
  return rows;
}

std::vector<ScanRow> Scan::rails(const ScanRow& start) const
{
  OneWheel wheel(configFor(start.rail, start.inclination), solver_, scan_grid);
  OneWheel other(configFor(start.rail, start.inclination), solver_, scan_grid);
  const std::array<RailDeflection, 4> displacements{
      {{}, {printed_displacement, 0, 0}, {-printed_displacement, 0, 0}, {0, -sinking, 0}}};
  std::vector<ScanRow> rows;
  for (const RailDeflection& own : displacements)
  {
    for (const RailDeflection& others : displacements)
    {
      ScanRow row = rowFrom(start, "rails");
      row.crown = own;
      row.other_crown = others;
      wheel.displaceCrown(own);
      other.displaceCrown(others);
      row.figures = rollToBalance(wheel, other, row.y, row.load, row.roll) ? wheel.figures() : Figures{0, 0};
      rows.push_back(row);
    }
  }
  return rows;
}
}  // namespace wheel_rail_contact::core::paper
