// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "core/text/formatted.h"
#include "core/track/line_rows.h"

namespace wheel_rail_contact::core
{
using namespace line_quantity;

namespace
{
using LineRows = std::vector<LineRow>;

/// Question where a quantity that is given twice has two values: the difference of both rails, and that of their
/// columns.
std::string contradiction(const LineRows& rows, std::size_t difference, std::size_t left, std::size_t right)
{
  constexpr double rounding = 0.2e-3;  // to 0.1 mm, of all three [m]
  const auto both = [=](const LineRow& row) { return row.value[left].value_or(0) - row.value[right].value_or(0); };
  const auto off = [&](const LineRow& row) { return std::abs(both(row) - row.value[difference].value_or(0)); };
  const LineRow& worst =
      *std::max_element(rows.begin(), rows.end(), [&](const LineRow& a, const LineRow& b) { return off(a) < off(b); });
  const bool are_given = worst.value[difference] && worst.value[left] && worst.value[right];
  return !are_given || off(worst) < rounding
             ? ""
             : formatted(
                   "'%s' and both '%s' disagree by up to %.4g mm: at x = %.10g m it deviates by %.4g mm from the "
                   "ideal track, they by %.4g mm; '%s' is kept, with the mean of both",
                   line_columns[difference].name, difference == gauge ? "alignment" : "level", 1e3 * off(worst),
                   *worst.value[x], 1e3 * *worst.value[difference], 1e3 * both(worst), line_columns[difference].name);
}

/// Question on a value that stays where the others move: a lost signal, or a filler.
std::string frozen(const LineRows& rows, std::size_t column)
{
  constexpr std::size_t longest = 25, shortest = 5;        // rows: always; where it jumps at an end
  constexpr double least_jump = 5e-3, least_slope = 0.01;  // [m], [rad]; over the distance
  constexpr double abrupt = 2;                             // over the mean change
  std::size_t first = 0, end = 0, changes = 0;             // of the longest run
  const auto value = [&](std::size_t i) { return rows[i].value[column].value_or(0); };
  const auto jump = [&](std::size_t i) { return i == 0 || i == rows.size() ? 0 : std::abs(value(i) - value(i - 1)); };
  const auto jumps = [&](std::size_t i)
  { return jump(i) > least_jump && jump(i) > least_slope * (*rows[i].value[x] - *rows[i - 1].value[x]); };
  double travel = 0;  // sum of all changes [m], [rad]
  for (std::size_t i = 1; i < rows.size(); ++i)
  {
    travel += jump(i);
    changes += jump(i) > 0 ? 1U : 0U;
  }
  for (std::size_t begin = 0, i = 1; i <= rows.size(); ++i)
  {
    if (i == rows.size() || value(i) != value(begin))
    {
      const bool is_lead = value(begin) == 0 && (begin == 0 || i == rows.size());  // an ideal track before and after
      const bool is_long = i - begin >= (jumps(begin) || jumps(i) ? shortest : longest);
      // A ramp of a design ends in its plateau without a jump.
      const bool is_abrupt = std::max(jump(begin), jump(i)) * static_cast<double>(changes) > abrupt * travel;
      const bool is_run = is_long && is_abrupt && !is_lead && i - begin > end - first;
      first = is_run ? begin : first;
      end = is_run ? i : end;
      begin = i;
    }
  }
  // A value that is kept in most rows is that of a design, or of a coarse rounding.
  return end == first || 2 * changes < rows.size() - (end - first)
             ? ""
             : formatted("column '%s' is the same in %zu rows, from x = %.10g to %.10g m: a lost signal?",
                         line_columns[column].name, end - first, *rows[first].value[x], *rows[end - 1].value[x]);
}

/// Question on values that are too small to be meant in their unit.
std::string tiny(const LineRows& rows, std::size_t column, double unit)
{
  constexpr double least = 20e-6, least_number = 0.02;  // [m], [rad]; as written
  double largest = 0;
  for (const LineRow& row : rows)
  {
    largest = std::max(largest, std::abs(row.value[column].value_or(0)));
  }
  // A gauge may be the nominal one.
  return column != gauge && largest > 0 && largest < least && largest < least_number * unit
             ? formatted("column '%s' is at most %.3g in its unit: another one?", line_columns[column].name,
                         largest / unit)
             : "";
}

/// Question on stations whose distance is that of no measurement.
std::string sparse(const LineRows& rows)
{
  constexpr std::size_t fewest = 10;                 // rows of a measurement
  constexpr double shortest = 1e-3, longest = 10.0;  // [m]
  const auto& first = rows.front().value;
  const bool is_measured = std::any_of(first.begin() + alignment, first.begin() + cross_level,
                                       [](const auto& value) { return value.has_value(); });
  const double mean = (*rows.back().value[x] - *first[x]) / static_cast<double>(rows.size() - 1);
  return rows.size() < fewest || !is_measured || (mean > shortest && mean < longest)
             ? ""
             : formatted("the stations are %.4g m apart: is x in another unit?", mean);
}

/// Question on a cant that raises the inner rail.
std::string raisedInside(const LineRows& rows)
{
  constexpr double least = 5e-3;  // [m]
  const auto raised = std::find_if(rows.begin(), rows.end(),
                                   [](const LineRow& row)
                                   {
                                     const double high = row.value[cant].value_or(0);
                                     return std::abs(high) > least && row.value[curvature].value_or(0) * high > 0;
                                   });
  return raised == rows.end()
             ? ""
             : formatted("at x = %.10g m the cant raises the inner rail: another sign?", *raised->value[x]);
}
}  // namespace

std::vector<std::string> lineDoubts(const LineRows& rows, const std::array<double, columns>& units)
{
  std::vector<std::string> doubts{sparse(rows), contradiction(rows, gauge, alignment_left, alignment_right),
                                  contradiction(rows, cross_level, level_left, level_right), raisedInside(rows)};
  for (std::size_t column = gauge; column < curvature; ++column)  // the design stays by intention
  {
    doubts.push_back(frozen(rows, column));
    doubts.push_back(tiny(rows, column, units[column]));
  }
  doubts.erase(std::remove(doubts.begin(), doubts.end(), ""), doubts.end());
  return doubts;
}
}  // namespace wheel_rail_contact::core
