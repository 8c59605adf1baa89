// SPDX-License-Identifier: BSD-3-Clause
#include "scan.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>

#include "one_wheel.h"
#include "wheel_rail_contact/geometry/profile_reader.h"

namespace wheel_rail_contact::paper
{
namespace
{
constexpr GridSize scan_grid{32, 64};
constexpr Range refined_position{-0.1e-3, 0.1e-3, 20};  ///< around a position of the coarse scan [m]
constexpr double near_printed = 0.04;  ///< deviation without bending up to which other inclinations are gone into [-]
constexpr Range refined_cant{-0.75e-3, 0.75e-3, 6};           ///< around a pair of the coarse scan [rad]
constexpr Range refined_pair_position{-0.12e-3, 0.12e-3, 8};  ///< likewise [m]
constexpr Range refined_turn{-1e-3, 1e-3, 8};                 ///< likewise [rad]
constexpr double sinking = 1e-3;                              ///< of the other rail [m]

void solveRow(OneWheel& wheel, ScanRow& row)
{
  wheel.displaceCrown(row.crown);
  row.figures = wheel.solve(row.y, row.roll, row.load) ? wheel.figures() : Figures{0, 0};
}

/// A row of a part that looks for pairs.
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

ContactModelConfig Scan::configFor(const std::string& rail, double cant) const
{
  ContactModelConfig config = config_;
  config.rail_profile = std::make_shared<Profile>(loadProfile(rail, ProfileKind::rail));
  config.track.cant = cant;
  return config;
}

std::vector<ScanRow> Scan::start() const
{
  std::vector<ScanRow> rows;
  for (const std::string& rail : ranges_.rails)
  {
    for (const double cant : ranges_.cants)
    {
      OneWheel wheel(configFor(rail, cant), solver_, scan_grid);
      for (const double load : ranges_.loads)
      {
        for (int i = 0; i <= ranges_.position.steps; ++i)
        {
          ScanRow row{"start", rail, cant, load, ranges_.position.at(i), 0, {}, {}, {}, {}};
          solveRow(wheel, row);
          rows.push_back(row);
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
    for (const double cant : ranges_.cants)
    {
      const ScanRow* best = nullptr;
      for (const ScanRow& row : rows)
      {
        const bool fits = row.rail == rail && row.cant == cant && row.load == printed_wheel_load;
        best = fits && (best == nullptr || startDeviation(row) < startDeviation(*best)) ? &row : best;
      }
      if (best == nullptr || startDeviation(*best) > 2 * limit)
      {
        continue;
      }
      OneWheel wheel(configFor(rail, cant), solver_, scan_grid);
      ScanRow refined = *best;
      for (int i = 0; i <= refined_position.steps; ++i)
      {
        ScanRow row = *best;
        row.y += refined_position.at(i);
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
  OneWheel wheel(configFor(start.rail, start.cant), solver_, scan_grid);
  std::vector<ScanRow> rows;
  for (int i = 0; i <= ranges_.pure_shift.steps; ++i)
  {
    ScanRow row = rowFrom(start, "shift");
    row.crown.lateral = ranges_.pure_shift.at(i);
    solveRow(wheel, row);
    rows.push_back(row);
  }
  return rows;
}

std::vector<ScanRow> Scan::pair(const ScanRow& start) const
{
  OneWheel wheel(configFor(start.rail, start.cant), solver_, scan_grid);
  std::vector<ScanRow> rows;
  for (int i = 0; i <= ranges_.position_around_start.steps; ++i)
  {
    ScanRow row = rowFrom(start, "pair");
    row.y += ranges_.position_around_start.at(i);
    solveRow(wheel, row);
    row.without = row.figures;
    for (const double shift : ranges_.shift)
    {
      for (int k = 0; k <= ranges_.turn.steps; ++k)
      {
        row.crown = {shift, 0, ranges_.turn.at(k)};
        solveRow(wheel, row);
        rows.push_back(row);
      }
    }
  }
  return rows;
}

/// Where the figures at row.y without deflection are near the printed ones: the rail displaced as printed, and turned.
void Scan::addPairs(OneWheel& wheel, ScanRow row, const Range& turns, std::vector<ScanRow>& rows) const
{
  row.crown = {};
  solveRow(wheel, row);
  row.without = row.figures;
  if (startDeviation(row) > near_printed)
  {
    return;
  }
  for (int k = 0; k <= turns.steps; ++k)
  {
    row.crown = {printed_displacement, 0, turns.at(k)};
    solveRow(wheel, row);
    rows.push_back(row);
  }
}

void Scan::refine(const ScanRow& best, std::vector<ScanRow>& rows) const
{
  const Range turns{best.crown.roll + refined_turn.first, best.crown.roll + refined_turn.last, refined_turn.steps};
  for (int i = 0; i <= refined_cant.steps; ++i)
  {
    ScanRow row = best;
    row.cant += refined_cant.at(i);
    OneWheel wheel(configFor(row.rail, row.cant), solver_, scan_grid);
    for (int k = 0; k <= refined_pair_position.steps; ++k)
    {
      row.y = best.y + refined_pair_position.at(k);
      addPairs(wheel, row, turns, rows);
    }
  }
}

std::vector<ScanRow> Scan::inclination(const std::string& rail) const
{
  std::vector<ScanRow> rows;
  for (int i = 0; i <= ranges_.free_cant.steps; ++i)
  {
    const double cant = ranges_.free_cant.at(i);
    OneWheel wheel(configFor(rail, cant), solver_, scan_grid);
    for (int k = 0; k <= ranges_.position.steps; ++k)
    {
      addPairs(wheel, {"inclination", rail, cant, printed_wheel_load, ranges_.position.at(k), 0, {}, {}, {}, {}},
               ranges_.turn, rows);
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
  OneWheel wheel(configFor(rail, config_.track.cant), solver_, scan_grid);
  std::vector<ScanRow> rows;
  for (int i = 0; i <= ranges_.free_position.steps; ++i)
  {
    for (int k = 0; k <= ranges_.free_turn.steps; ++k)
    {
      ScanRow row{"alone", rail, config_.track.cant, printed_wheel_load, ranges_.free_position.at(i), 0, {}, {},
                  {},      {}};
      row.crown.roll = ranges_.free_turn.at(k);
      solveRow(wheel, row);
      rows.push_back(row);
    }
  }
  return rows;
}

std::vector<ScanRow> Scan::roll(const ScanRow& start) const
{
  OneWheel wheel(configFor(start.rail, start.cant), solver_, scan_grid);
  std::vector<ScanRow> rows;
  for (const double shift : {-printed_displacement, 0.0, printed_displacement})
  {
    for (int i = 0; i <= ranges_.roll.steps; ++i)
    {
      ScanRow row = rowFrom(start, "roll");
      row.crown.lateral = shift;
      row.roll = ranges_.roll.at(i);
      solveRow(wheel, row);
      rows.push_back(row);
    }
  }
  return rows;
}

std::vector<ScanRow> Scan::rails(const ScanRow& start) const
{
  OneWheel wheel(configFor(start.rail, start.cant), solver_, scan_grid);
  OneWheel other(configFor(start.rail, start.cant), solver_, scan_grid);
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
}  // namespace wheel_rail_contact::paper
