// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>
#include <regex>
#include <stdexcept>

#include "core/text/formatted.h"
#include "core/text/text_table.h"
#include "core/text/words.h"
#include "wheel_rail_contact/core/track.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr std::size_t largest_file = std::size_t{256} << 20U;  ///< of a line of some thousand kilometres [bytes]
constexpr std::size_t longest_row = 100000;                    ///< [bytes]
constexpr std::size_t most_stations = 2000000;                 ///< 500 km every 0.25 m; about 1 GB while it is read
constexpr std::size_t longest_word = 100;                      ///< of a title or a filler
constexpr double largest_value = 0.2;  ///< of a displacement, or a difference from the nominal gauge [m], [rad]
/// Largest change between two stations: slope [-], and change of any two [share of the gauge], far above those of real
/// track (1:20 on the worst one, steps of a millimetre). A larger one is a filler for a missing value, or a fault.
constexpr double steepest = 0.1, step_share = 0.003;
constexpr double least_filler = 0.005;  ///< change to a value of nines from which it is a filler [m], [rad]

/// Quantities of a table.
enum Quantity
{
  x,
  gauge,
  alignment,
  alignment_left,
  alignment_right,
  level,
  level_left,
  level_right,
  cross_level,
  rail_lateral_left,
  rail_vertical_left,
  rail_roll_left,
  rail_lateral_right,
  rail_vertical_right,
  rail_roll_right,
  columns
};

struct ColumnRule
{
  const char* name;
  bool is_angle;
  double railway_sign;  ///< -1: its sign changes in railway axes
};

constexpr std::array<ColumnRule, columns> rules{{{"x", false, 1},
                                                 {"gauge", false, 1},
                                                 {"alignment", false, -1},
                                                 {"alignment_left", false, -1},
                                                 {"alignment_right", false, -1},
                                                 {"level", false, -1},
                                                 {"level_left", false, -1},
                                                 {"level_right", false, -1},
                                                 {"cross_level", false, 1},
                                                 {"rail_lateral_left", false, 1},
                                                 {"rail_vertical_left", false, -1},
                                                 {"rail_roll_left", true, 1},
                                                 {"rail_lateral_right", false, 1},
                                                 {"rail_vertical_right", false, -1},
                                                 {"rail_roll_right", true, 1}}};

/// Words in the names of quantities of a line: a column with one of them is never ignored.
constexpr const char* own_words[] = {"gauge", "alig", "level", "cant", "superelevation", "rail_"};

/// A row of the table in SI units and REP-103 axes; nothing where the column is missing.
struct Row
{
  std::array<std::optional<double>, columns> value;
  std::array<bool, columns> nines{};  ///< the cell contains only nines, as fillers do
  std::size_t line = 0;
};

/// Name of a column as in `rules`: in lower case, with _ in place of blanks, points and hyphens.
std::string columnKey(const std::string& name)
{
  static const std::regex gaps("[\\s._-]+"), place("s|distance|station|chainage|mileage"), cross("crosslevel");
  const std::string key = std::regex_replace(lowerCase(name.substr(0, longest_word)), gaps, "_");
  return std::regex_match(key, place) ? "x" : std::regex_match(key, cross) ? "cross_level" : key;
}

/// Table of a file. It is read as contact_states reads its tables, with a CellTable.
class LineFile
{
 public:
  LineFile(const std::string& path, LineAxes axes)
      : file_(path, largest_file, longest_row), table_(file_, false), axes_(axes)
  {
    const std::vector<TableRow>& head = table_.head();
    file_.refuseIf(head.empty(), 0, "has no titles of columns with their units, for example 'x [m], gauge [mm]'");
    std::vector<TableTitle> titles = titlesIn(head[head.size() > 1 ? head.size() - 2 : 0].cells);
    const bool has_units = head.size() > 1 && takeUnits(file_, head.back(), titles);
    titles = has_units ? titles : titlesIn(head.back().cells);
    title_line_ = head[head.size() - (has_units ? 2 : 1)].line;
    addColumns(titles);
    checkColumns();
  }

  /// Reads all rows. Those with a missing value are dropped.
  std::vector<Row> rows()
  {
    static const std::regex nines(R"([+-]?99+[.,]?9+0*)");
    std::vector<Row> rows;
    std::size_t count = 0;
    for (TableRow cells; table_.next(cells); ++count)
    {
      if (std::any_of(used_.begin(), used_.end(), [&](const Used& used) { return isMissing(cells.cells[used.index]); }))
      {
        first_dropped_ = dropped_++ == 0 ? cells.line : first_dropped_;
        continue;
      }
      Row row;
      row.line = cells.line;
      for (const Used& used : used_)
      {
        std::optional<double>& value = row.value[used.quantity];
        const double number = file_.numberIn(withPoint(cells.cells[used.index]), rules[used.quantity].name);
        value = value.value_or(0) + number * used.factor;
        const std::string& cell = cells.cells[used.index];
        row.nines[used.quantity] = cell.size() <= longest_word && std::regex_match(cell, nines);
      }
      file_.refuseIf(rows.size() == most_stations, row.line,
                     formatted("more than %zu stations: divide it", most_stations));
      rows.push_back(row);
    }
    file_.refuseIf(2 * dropped_ > count, first_dropped_, formatted("%zu of %zu rows lack a value", dropped_, count));
    return rows;
  }

  const TextFile& file() const { return file_; }

  /// What is not used, as parts of a sentence.
  std::string remarks() const
  {
    return (dropped_ == 0 ? ""
                          : formatted("; %zu rows lack a value, the first in line %zu", dropped_, first_dropped_)) +
           (ignored_.empty() ? "" : "; ignored columns: " + joined(ignored_, ", "));
  }

 private:
  struct Used
  {
    std::size_t index;  ///< of the column in the file
    std::size_t quantity;
    double factor;  ///< from its unit and axes to SI units and REP-103 axes
  };

  void refuseTitlesIf(bool fault, const std::string& reason) const { file_.refuseIf(fault, title_line_, reason); }

  void addColumns(const std::vector<TableTitle>& titles)
  {
    for (std::size_t i = 0; i < titles.size(); ++i)
    {
      addColumn(i, titles[i]);
    }
    // A place in two columns: kilometres, and the rest in metres. Other columns of a place come first.
    for (std::size_t i = 0; i < titles.size() && !has_place_; ++i)
    {
      const std::string name = lowerCase(titles[i].name);
      if (titles[i].unit.empty() && (name == "km" || name == "m"))
      {
        used_.push_back({i, x, name == "km" ? 1e3 : 1});
        ignored_.erase(std::find(ignored_.begin(), ignored_.end(), titles[i].name));
      }
    }
  }

  void addColumn(std::size_t index, const TableTitle& title)
  {
    const std::string key = columnKey(title.name);
    const auto rule = std::find_if(rules.begin(), rules.end(), [&](const ColumnRule& r) { return key == r.name; });
    if (rule == rules.end())
    {
      const bool is_own = std::any_of(std::begin(own_words), std::end(own_words),
                                      [&](const char* word) { return key.find(word) != std::string::npos; });
      refuseTitlesIf(is_own, "column '" + title.name + "': unknown quantity; valid names are " + validNames());
      if (!title.name.empty())
      {
        ignored_.push_back(title.name);
      }
      return;
    }
    const auto column = static_cast<std::size_t>(rule - rules.begin());
    refuseTitlesIf(has(column), "column '" + title.name + "' is given twice");
    refuseTitlesIf(title.unit.empty(), "column '" + title.name + "': must have a unit, for example '" + title.name +
                                           (rule->is_angle ? " [mrad]'" : " [mm]'"));
    const std::optional<double> unit = unitNamed(rule->is_angle ? angleUnits() : lengthUnits(), title.unit);
    refuseTitlesIf(!unit, "column '" + title.name + "': unknown unit '" + title.unit + "'; valid units are " +
                              (rule->is_angle ? "rad, mrad, deg" : "m, cm, mm, um, in, ft, km, mi"));
    used_.push_back({index, column, *unit * (axes_ == LineAxes::railway ? rule->railway_sign : 1)});
    has_place_ = has_place_ || column == x;
  }

  bool has(std::size_t column) const
  {
    return std::any_of(used_.begin(), used_.end(), [&](const Used& used) { return used.quantity == column; });
  }

  void checkColumns() const
  {
    refuseTitlesIf(!has(x),
                   "column 'x' is missing" + (ignored_.empty() ? "" : "; others are " + joined(ignored_, ", ")));
    const bool has_other = std::any_of(used_.begin(), used_.end(), [](const Used& used) { return used.quantity != x; });
    refuseTitlesIf(!has_other, "no column has an irregularity; valid names are " + validNames());
    const auto both = [this](std::size_t one, std::size_t other)
    {
      refuseTitlesIf(has(one) && has(other),
                     std::string("give either '") + rules[one].name + "' or '" + rules[other].name + "'");
    };
    both(alignment, alignment_left);
    both(alignment, alignment_right);
    both(level, level_left);
    both(level, level_right);
    for (std::size_t track = gauge; track <= cross_level; ++track)
    {
      for (std::size_t rail = rail_lateral_left; rail < columns; ++rail)
      {
        both(track, rail);
      }
    }
  }

  static std::string validNames()
  {
    std::vector<std::string> names;
    std::transform(rules.begin(), rules.end(), std::back_inserter(names),
                   [](const ColumnRule& rule) { return rule.name; });
    return joined(names, ", ");
  }

  TextFile file_;
  CellTable table_;
  LineAxes axes_;
  std::size_t title_line_ = 0;
  bool has_place_ = false;  ///< a column is the whole place
  std::vector<Used> used_;
  std::vector<std::string> ignored_;
  std::size_t dropped_ = 0, first_dropped_ = 0;
};

/// Mean and difference of a quantity of both rails, left and right, from what is given.
struct Pair
{
  double middle = 0, difference = 0;

  Pair(const std::optional<double>& mean, const std::optional<double>& left, const std::optional<double>& right,
       const std::optional<double>& given_difference)
  {
    difference = given_difference ? *given_difference : left && right ? *left - *right : 0;
    middle = mean            ? *mean
             : left && right ? 0.5 * (*left + *right)
             : left          ? *left - 0.5 * difference
             : right         ? *right + 0.5 * difference
                             : 0;
  }
};

LineStation stationOf(const Row& row)
{
  const auto value = [&row](std::size_t column) { return row.value[column].value_or(0); };
  const Pair lateral(row.value[alignment], row.value[alignment_left], row.value[alignment_right], row.value[gauge]);
  const Pair vertical(row.value[level], row.value[level_left], row.value[level_right], row.value[cross_level]);
  LineStation station;
  station.x = value(x);
  station.cross_level = vertical.difference;
  station.rail.left = {lateral.middle + 0.5 * lateral.difference + value(rail_lateral_left),
                       vertical.middle + value(rail_vertical_left), value(rail_roll_left)};
  station.rail.right = {-lateral.middle + 0.5 * lateral.difference + value(rail_lateral_right),
                        vertical.middle + value(rail_vertical_right), value(rail_roll_right)};
  return station;
}

/// Makes deviations of the gauge from the nominal one. @return true if they are
bool isDeviation(std::vector<Row>& rows, double nominal, const TextFile& file)
{
  if (rows.empty() || !rows.front().value[gauge])
  {
    return false;
  }
  const bool is_deviation = std::abs(*rows.front().value[gauge]) < 0.5 * nominal;
  for (Row& row : rows)
  {
    double& value = *row.value[gauge];
    if (!(std::abs(value - (is_deviation ? 0 : nominal)) <= largest_value))
    {
      file.refuse(row.line, "gauge = " + std::to_string(value) +
                                " m: must be the whole gauge, within 0.2 m of track/gauge" +
                                ", or in all rows the deviation from it");
    }
    value -= is_deviation ? 0 : nominal;
  }
  return is_deviation;
}

/// Refuses values that no track has.
void checkValues(const std::vector<Row>& rows, double nominal_gauge, const TextFile& file)
{
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const Row &row = rows[i], &before = rows[i > 0 ? i - 1 : 0];
    const double distance = *row.value[x] - *before.value[x];
    for (std::size_t column = gauge; column < columns; ++column)
    {
      const double value = row.value[column].value_or(0), change = value - before.value[column].value_or(0);
      const bool is_large = std::abs(value) > largest_value;
      const bool is_filler = std::abs(change) > least_filler &&
                             ((row.nines[column] && std::abs(change) > 0.5 * std::abs(value)) ||
                              (before.nines[column] && std::abs(change) > 0.5 * std::abs(change - value)));
      if (is_large || is_filler || std::abs(change) > steepest * distance + step_share * nominal_gauge)
      {
        file.refuse(row.line, formatted("column '%s': %s %.4g %s%s: another unit, or a filler for a missing value, "
                                        "which must be an empty cell",
                                        rules[column].name, is_large ? "a value of" : "a change by",
                                        is_large ? value : change, rules[column].is_angle ? "rad" : "m",
                                        is_large ? "" : formatted(" within %.4g m", distance).c_str()));
      }
    }
  }
}

/// Puts the rows in the order of x. @return true if they were in the opposite order
bool isReversed(std::vector<Row>& rows, const TextFile& file)
{
  const bool reversed = rows.size() > 1 && *rows.front().value[x] > *rows.back().value[x];
  for (std::size_t i = 1; i < rows.size(); ++i)
  {
    const double step = *rows[i].value[x] - *rows[i - 1].value[x];
    file.refuseIf(!(reversed ? step < 0 : step > 0), rows[i].line,
                  reversed ? "x must decrease, as from the first row to the last" : "x must increase");
  }
  if (reversed)
  {
    std::reverse(rows.begin(), rows.end());
  }
  return reversed;
}

/// Three times the median distance of the stations [m].
double usualGap(const std::vector<LineStation>& stations)
{
  std::vector<double> distances;
  for (std::size_t i = 1; i < stations.size(); ++i)
  {
    distances.push_back(stations[i].x - stations[i - 1].x);
  }
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return distances.empty() ? 0 : 3 * *middle;
}

/// The longest gap, and the first place that exceeds it.
std::string gapText(const TrackLine& line, const std::vector<LineStation>& stations)
{
  const auto gap =
      std::adjacent_find(stations.begin(), stations.end(),
                         [&](const auto& one, const auto& next) { return next.x - one.x > line.longestGap(); });
  return formatted("; longest gap %.4g m", line.longestGap()) +
         (gap == stations.end() ? "" : formatted(", exceeded from %.10g to %.10g m", gap->x, std::next(gap)->x));
}
}  // namespace

TrackLine readTrackLine(const std::string& path, double nominal_gauge, const LineReading& reading,
                        std::string* understood)
{
  try
  {
    LineFile table(path, reading.axes);
    std::vector<Row> rows = table.rows();
    const bool is_deviation = isDeviation(rows, nominal_gauge, table.file());
    const bool is_reversed = isReversed(rows, table.file());
    checkValues(rows, nominal_gauge, table.file());
    std::vector<LineStation> stations;
    std::transform(rows.begin(), rows.end(), std::back_inserter(stations), stationOf);
    TrackLine line(path, stations, reading.longest_gap > 0 ? reading.longest_gap : usualGap(stations));
    if (understood != nullptr)
    {
      *understood =
          formatted("%zu stations from %.10g to %.10g m", stations.size(), line.begin(), line.end()) +
          (is_deviation ? formatted("; gauge as deviation from %.10g m", nominal_gauge) : "") +
          (is_reversed ? "; x decreases in the file: left and right are taken as seen towards increasing x" : "") +
          gapText(line, stations) + table.remarks();
    }
    return line;
  }
  catch (const FileError& error)
  {
    throw std::invalid_argument(error.what());
  }
}
}  // namespace wheel_rail_contact::core
