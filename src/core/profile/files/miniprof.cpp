// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/profile/files/content.h"
#include "core/text/words.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double mm = 1e-3;  ///< [m]
/// Points begin where so many lines of numbers follow one another: the free text of old headers contains numbers, too.
constexpr std::size_t least_block = 10;

/// Line up to a comment. A quotation mark begins one, too.
std::string pointText(const std::string& line)
{
  return withoutComment(trim(line.substr(0, line.find('"'))));
}

/// Words of a line of a point, with a decimal point.
std::vector<std::string> pointWords(const std::string& line)
{
  std::vector<std::string> words = splitWords(pointText(line));
  std::transform(words.begin(), words.end(), words.begin(), withPoint);
  return words;
}

/// Number of words of a line if all are numbers, else 0.
std::size_t numbersIn(const std::string& line)
{
  const std::vector<std::string> words = pointWords(line);
  const auto is_number = [](const std::string& word) { return parseNumber(word).has_value(); };
  return std::all_of(words.begin(), words.end(), is_number) ? words.size() : 0;
}

/// Number of the first line of the points; 0 if there are none.
std::size_t firstPoint(TextFile& file)
{
  std::size_t first = 0, rows = 0, first_row = 0;
  while (file.next() && rows < least_block)
  {
    const bool is_empty = pointText(file.line()).empty(), is_row = numbersIn(file.line()) > 1;
    first = is_row && rows == 0 ? file.number() : first;
    first_row = is_row && first_row == 0 ? file.number() : first_row;
    rows = is_empty ? rows : is_row ? rows + 1 : 0;
  }
  file.rewind();
  return rows < least_block ? first_row : first;
}

class MiniProfReader
{
 public:
  MiniProfReader(TextFile& file, ProfileKind kind) : file_(file), kind_(kind) {}

  FileProfile read()
  {
    const std::size_t first = firstPoint(file_);
    while (file_.next())
    {
      if (first > 0 && file_.number() >= first)
      {
        const std::vector<std::string> words = pointWords(file_.line());
        if (!words.empty())
        {
          readPoint(words);
        }
        continue;
      }
      free_header_ = free_header_ || (file_.number() == 1 && beginsOldMiniProf(file_.line()));
      readHeader(file_.line());
    }
    file_.refuseIf(static_cast<double>(content_.points.size()) < stated_points_,
                   "file ends after " + std::to_string(content_.points.size()) + " of " +
                       std::to_string(static_cast<long>(stated_points_)) + " points (XYPoints): truncated");
    const bool is_wheel = kind_ == ProfileKind::wheel;
    content_.format = "MiniProf";
    if (columns_ > 0 && found_columns_ != columns_)
    {
      content_.remark = std::to_string(found_columns_) + " columns instead of the " + std::to_string(columns_) +
                        " of ColumnDef, of which X and Y are the first";
    }
    content_.unit = mm;
    content_.y = is_wheel ? ProfileReading::Y::outward : ProfileReading::Y::inward;
    content_.z = is_wheel ? ProfileReading::Z::down : ProfileReading::Z::up;
    content_.from_flange_back = is_wheel;
    content_.running_circle = is_wheel ? tape_circle_ * mm : 0;
    return content_;
  }

 private:
  void readHeader(std::string line)
  {
    const bool is_remark = pointText(line).empty();
    line.erase(std::remove(line.begin(), line.end(), '"'), line.end());
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos && (is_remark || free_header_))
    {
      return;
    }
    file_.refuseIf(equals == std::string::npos, "line is neither key=value nor a point: not a MiniProf profile");
    const std::string key = lowerCase(trim(line.substr(0, equals)));
    const std::string value = trim(line.substr(equals + 1));
    if (key == "columndef")
    {
      readColumns(value);
    }
    else if (key == "xoffset" || key == "yoffset" || key == "xypoints")
    {
      (key == "xoffset" ? x_offset_ : key == "yoffset" ? y_offset_ : stated_points_) = number(key, value);
    }
    else if (key == "wheeldiametertaperline" && number(key, value) > 0.0)
    {
      tape_circle_ = number(key, value);
    }
    else if (key == "tilt" && number(key, value) != 0.0)
    {
      file_.refuse("Tilt is not 0: the rotation must be applied before the profile is stored");
    }
  }

  /// Number in the header; 0 if the value is empty.
  double number(const std::string& key, const std::string& value) const
  {
    const std::optional<double> parsed = value.empty() ? 0.0 : parseNumber(value);
    file_.refuseIf(!parsed || std::abs(*parsed) > 1e6, "value of '" + key + "' is not a plausible number");
    return *parsed;
  }

  void readColumns(const std::string& definition)
  {
    const std::vector<std::string> names = splitCells(lowerCase(definition), ',');
    const auto column_of = [&](const char* name)
    {
      const auto found = std::find(names.begin(), names.end(), name);
      file_.refuseIf(found == names.end(), std::string("ColumnDef has no ") + (name[0] == 'x' ? "X" : "Y"));
      return static_cast<std::size_t>(found - names.begin());
    };
    columns_ = names.size();
    x_column_ = column_of("x");
    y_column_ = column_of("y");
  }

  void readPoint(const std::vector<std::string>& words)
  {
    // X and Y are known as the first two columns of any number, if it is the same in all lines.
    const bool begins_with_both = x_column_ + y_column_ == 1;
    found_columns_ = found_columns_ == 0 ? words.size() : found_columns_;
    const std::size_t valid = begins_with_both ? found_columns_ : columns_;
    if (words.size() < 2 || (columns_ > 0 && words.size() != valid))
    {
      file_.refuse("number of columns is " + std::to_string(words.size()) +
                   (columns_ > 0 ? ", ColumnDef states " + std::to_string(columns_) + ", and the first point has " +
                                       std::to_string(found_columns_)
                                 : ", at least X and Y are required"));
    }
    const double x = file_.numberIn(words[x_column_]), y = file_.numberIn(words[y_column_]);
    addPoint(file_, content_, {x + x_offset_, y + y_offset_}, words[y_column_]);
  }

  TextFile& file_;
  ProfileKind kind_;
  std::size_t columns_ = 0;        ///< number of columns; 0: not stated, X and Y are the first two
  std::size_t found_columns_ = 0;  ///< of the first point
  std::size_t x_column_ = 0;
  std::size_t y_column_ = 1;
  double x_offset_ = 0;     ///< [mm]
  double y_offset_ = 0;     ///< [mm]
  double tape_circle_ = 0;  ///< [mm]; 0: not stated
  double stated_points_ = 0;
  bool free_header_ = false;  ///< old file: its header may contain any text
  FileProfile content_;
};
}  // namespace

FileProfile readMiniProf(TextFile& file, ProfileKind kind)
{
  return MiniProfReader(file, kind).read();
}
}  // namespace wheel_rail_contact::core
