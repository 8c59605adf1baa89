// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "core/profile/profile_file.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double mm = 1e-3;                 ///< [m]
constexpr double tape_circle = 70.0;        ///< default distance of the running circle from the flange back [mm]
constexpr double overlap = 1.0;             ///< largest overlap of a measurement in two strokes [mm]
constexpr const char* old_style = "#MINI";  ///< start of the first line of old files, whose header is free text

class MiniProfReader
{
 public:
  MiniProfReader(ProfileFile& file, ProfileKind kind) : file_(file), kind_(kind) {}

  FileProfile read();

 private:
  void readHeader(std::string line);
  /// Number in the header; 0 if the value is empty.
  double number(const std::string& key, const std::string& value) const;
  void readColumns(const std::string& definition);
  void readPoint(const std::vector<std::string>& words);
  /// @throw ProfileError if the points of a wheel do not extend across its running circle.
  void checkTapeCircle() const;
  /// Converts X and Y [mm] to the profile frame [m].
  SampledPoint toFrame(double x, double y) const;

  ProfileFile& file_;
  ProfileKind kind_;
  std::size_t columns_ = 0;  ///< number of columns; 0: not stated, X and Y are the first two
  std::size_t x_column_ = 0;
  std::size_t y_column_ = 1;
  double x_offset_ = 0;               ///< [mm]
  double y_offset_ = 0;               ///< [mm]
  double tape_circle_ = tape_circle;  ///< [mm]
  double stated_points_ = 0;
  FileProfile content_;
};

FileProfile MiniProfReader::read()
{
  bool free_header = false;
  while (file_.next())
  {
    const std::string& line = file_.line();
    if (line.empty())
    {
      continue;
    }
    const std::vector<std::string> words = splitWords(line);
    if (!content_.points.empty() || (words.size() > 1 && parseNumber(words[0]) && parseNumber(words[1])))
    {
      readPoint(words);
    }
    else if (file_.number() == 1 && line.compare(0, std::string(old_style).size(), old_style) == 0)
    {
      free_header = true;
    }
    else if (!free_header)
    {
      readHeader(line);
    }
  }
  if (static_cast<double>(content_.points.size()) < stated_points_)
  {
    file_.refuse("file ends after " + std::to_string(content_.points.size()) + " of " +
                 std::to_string(static_cast<long>(stated_points_)) + " points (XYPoints): truncated");
  }
  checkTapeCircle();
  content_.noise = miniprof_noise;
  content_.overlap = overlap * mm;
  content_.height_from_tape = kind_ == ProfileKind::wheel;
  return content_;
}

void MiniProfReader::checkTapeCircle() const
{
  if (kind_ != ProfileKind::wheel || content_.points.empty())
  {
    return;
  }
  const auto [left, right] = std::minmax_element(content_.points.begin(), content_.points.end(),
                                                 [](const auto& a, const auto& b) { return a.point.y < b.point.y; });
  if (left->point.y > 0.0 || right->point.y < 0.0)
  {
    std::ostringstream text;
    text << "points from X = " << left->point.y / mm + tape_circle_ << " to " << right->point.y / mm + tape_circle_
         << " mm do not extend across the running circle, X = " << tape_circle_
         << " mm (WheelDiameterTaperline): X must be counted from the flange back to the field side";
    file_.refuse(0, text.str());
  }
}

void MiniProfReader::readHeader(std::string line)
{
  line.erase(std::remove(line.begin(), line.end(), '"'), line.end());
  const std::size_t equals = line.find('=');
  if (equals == std::string::npos)
  {
    file_.refuse("line is neither key=value nor a point: not a MiniProf profile");
  }
  const std::string key = lowerCase(trim(line.substr(0, equals)));
  const std::string value = trim(line.substr(equals + 1));
  if (key == "columndef")
  {
    readColumns(value);
  }
  else if (key == "xoffset")
  {
    x_offset_ = number(key, value);
  }
  else if (key == "yoffset")
  {
    y_offset_ = number(key, value);
  }
  else if (key == "xypoints")
  {
    stated_points_ = number(key, value);
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

double MiniProfReader::number(const std::string& key, const std::string& value) const
{
  const std::optional<double> parsed = value.empty() ? 0.0 : parseNumber(value);
  if (!parsed || std::abs(*parsed) > 1e6)
  {
    file_.refuse("value of '" + key + "' is not a plausible number");
  }
  return *parsed;
}

void MiniProfReader::readColumns(const std::string& definition)
{
  const std::vector<std::string> names = splitFields(definition);
  const auto column_of = [&](const char* name)
  {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
    {
      file_.refuse(std::string("ColumnDef has no ") + name);
    }
    return static_cast<std::size_t>(found - names.begin());
  };
  columns_ = names.size();
  x_column_ = column_of("X");
  y_column_ = column_of("Y");
}

void MiniProfReader::readPoint(const std::vector<std::string>& words)
{
  if (words.size() < 2 || (columns_ > 0 && words.size() != columns_))
  {
    file_.refuse("number of columns is " + std::to_string(words.size()) +
                 (columns_ > 0 ? ", ColumnDef states " + std::to_string(columns_) : ", at least X and Y are required"));
  }
  const auto value_of = [&](std::size_t column)
  {
    const std::optional<double> value = parseNumber(words[column]);
    if (!value)
    {
      file_.refuse("'" + words[column] + "' is not a number");
    }
    return *value;
  };
  addPoint(file_, content_, toFrame(value_of(x_column_) + x_offset_, value_of(y_column_) + y_offset_));
}

SampledPoint MiniProfReader::toFrame(double x, double y) const
{
  return kind_ == ProfileKind::wheel ? SampledPoint{(x - tape_circle_) * mm, -y * mm} : SampledPoint{-x * mm, y * mm};
}
}  // namespace

FileProfile readMiniProf(ProfileFile& file, ProfileKind kind)
{
  return MiniProfReader(file, kind).read();
}
}  // namespace wheel_rail_contact::core
