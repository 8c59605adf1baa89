// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <regex>
#include <stdexcept>

#include "core/text/formatted.h"
#include "core/text/text_table.h"
#include "core/text/words.h"
#include "core/track/line_rows.h"

namespace wheel_rail_contact::core
{
using namespace line_quantity;

namespace
{
constexpr std::size_t largest_file = std::size_t{256} << 20U;  ///< of a line of some thousand kilometres [bytes]
constexpr std::size_t longest_row = 100000;                    ///< [bytes]
constexpr std::size_t most_stations = 2000000;                 ///< 500 km every 0.25 m; about 1 GB while it is read
constexpr std::size_t longest_word = 100;                      ///< of a title or a filler
/// Words in the names of quantities of a line: a column with one of them is never ignored.
constexpr const char* own_words[] = {"gauge", "alig",      "level",  "cant", "superelevation",
                                     "rail_", "curvature", "radius", "grad"};

/// Name of a column as in line_columns: in lower case, with _ in place of blanks, points and hyphens.
std::string columnKey(const std::string& name)
{
  static const std::regex gaps("[\\s._-]+"), place("s|distance|station|chainage|mileage"), cross("crosslevel");
  const std::string key = std::regex_replace(lowerCase(name.substr(0, longest_word)), gaps, "_");
  return std::regex_match(key, place)   ? "x"
         : std::regex_match(key, cross) ? "cross_level"
         : key == "superelevation"      ? "cant"
                                        : key;
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
    const TableTitles found = titlesWithUnits(file_, head, head.size() - 1, false);
    title_line_ = head[found.row].line;
    addColumns(found.titles);
    checkColumns();
  }

  /// Reads all rows. Those with a missing value are dropped.
  std::vector<LineRow> rows()
  {
    static const std::regex nines(R"([+-]?9([.,]?9){2,}[.,]?0*)");
    std::vector<LineRow> rows;
    std::size_t count = 0;
    for (TableRow cells; table_.next(cells); ++count)
    {
      if (std::any_of(used_.begin(), used_.end(), [&](const Used& used) { return isMissing(cells.cells[used.index]); }))
      {
        first_dropped_ = dropped_++ == 0 ? cells.line : first_dropped_;
        continue;
      }
      LineRow row;
      row.line = cells.line;
      for (const Used& used : used_)
      {
        std::optional<double>& value = row.value[used.quantity];
        const double number = file_.numberIn(withPoint(cells.cells[used.index]), line_columns[used.quantity].name);
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
  /// True if the table has one of these columns.
  bool has(std::size_t first, std::size_t end) const
  {
    return std::any_of(used_.begin(), used_.end(),
                       [&](const Used& used) { return used.quantity >= first && used.quantity < end; });
  }

  /// Units of the columns, in SI units.
  const std::array<double, columns>& units() const { return units_; }

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
    const auto* const rule = std::find_if(line_columns.begin(), line_columns.end(),
                                          [&](const LineColumn& column) { return key == column.name; });
    if (rule == line_columns.end())
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
    const auto column = static_cast<std::size_t>(rule - line_columns.begin());
    refuseTitlesIf(has(column), "column '" + title.name + "' is given twice");
    const std::vector<NamedUnit>& units = unitKind(rule->kind).units;
    std::vector<std::string> names;
    std::transform(units.begin(), units.end(), std::back_inserter(names), [](const NamedUnit& u) { return u.name; });
    refuseTitlesIf(title.unit.empty(), "column '" + title.name + "': must have a unit, for example '" + title.name +
                                           " [" + names[1] + "]'");
    const NamedUnit* unit = unitNamed(title.unit, rule->kind);
    refuseTitlesIf(unit == nullptr, "column '" + title.name + "': unknown unit '" + title.unit + "'; valid units are " +
                                        joined(names, ", "));
    units_[column] = unit->value;
    used_.push_back({index, column, unit->value * (axes_ == LineAxes::railway ? rule->railway_sign : 1)});
    has_place_ = has_place_ || column == x;
  }

  bool has(std::size_t column) const { return has(column, column + 1); }

  void checkColumns() const
  {
    refuseTitlesIf(!has(x),
                   "column 'x' is missing" + (ignored_.empty() ? "" : "; others are " + joined(ignored_, ", ")));
    refuseTitlesIf(!has(gauge, columns), "no column has an irregularity or a design; valid names are " + validNames());
    const auto both = [this](std::size_t one, std::size_t other)
    {
      refuseTitlesIf(has(one) && has(other),
                     std::string("give either '") + line_columns[one].name + "' or '" + line_columns[other].name + "'");
    };
    both(alignment, alignment_left);
    both(alignment, alignment_right);
    both(level, level_left);
    both(level, level_right);
    for (std::size_t track = gauge; track <= cross_level; ++track)
    {
      for (std::size_t rail = rail_lateral_left; rail < curvature; ++rail)
      {
        both(track, rail);
      }
    }
  }

  static std::string validNames()
  {
    std::vector<std::string> names;
    std::transform(line_columns.begin(), line_columns.end(), std::back_inserter(names),
                   [](const LineColumn& column) { return column.name; });
    return joined(names, ", ");
  }

  TextFile file_;
  CellTable table_;
  LineAxes axes_;
  std::size_t title_line_ = 0;
  bool has_place_ = false;  ///< a column is the whole place
  std::vector<Used> used_;
  std::array<double, columns> units_{};
  std::vector<std::string> ignored_;
  std::size_t dropped_ = 0, first_dropped_ = 0;
};

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
  return std::isinf(line.longestGap())
             ? ""
             : formatted("; longest gap %.4g m", line.longestGap()) +
                   (gap == stations.end() ? ""
                                          : formatted(", exceeded from %.10g to %.10g m", gap->x, std::next(gap)->x));
}
}  // namespace

TrackLine readTrackLine(const std::string& path, double nominal_gauge, const LineReading& reading, LineReport* report)
{
  try
  {
    LineFile table(path, reading.axes);
    std::vector<LineRow> rows = table.rows();
    const bool is_deviation = isDeviation(rows, nominal_gauge, table.file());
    const bool is_reversed = isReversed(rows, table.file());
    checkValues(rows, nominal_gauge, table.file());
    std::vector<LineStation> stations;
    std::transform(rows.begin(), rows.end(), std::back_inserter(stations),
                   [nominal_gauge](const LineRow& row) { return stationOf(row, nominal_gauge); });
    const double gap = reading.longest_gap > 0       ? reading.longest_gap
                       : table.has(gauge, curvature) ? usualGap(stations)
                                                     : std::numeric_limits<double>::infinity();
    TrackLine line(path, stations, gap, reading.repeat);
    if (report != nullptr)
    {
      report->text =
          formatted("%zu stations from %.10g to %.10g m", stations.size(), stations.front().x, stations.back().x) +
          (reading.repeat ? ", repeated" : "") +
          (is_deviation ? formatted("; gauge as deviation from %.10g m", nominal_gauge) : "") +
          (is_reversed ? "; x decreases in the file: left and right are taken as seen towards increasing x" : "") +
          designText(rows) + gapText(line, stations) + table.remarks();
      report->doubts = lineDoubts(rows, table.units());
    }
    return line;
  }
  catch (const FileError& error)
  {
    throw std::invalid_argument(error.what());
  }
}
}  // namespace wheel_rail_contact::core
