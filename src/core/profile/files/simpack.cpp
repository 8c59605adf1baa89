// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/profile/files/content.h"
#include "core/text/words.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Edits and units that are stated in a Simpack file, by keyword.
using SimpackSettings = std::map<std::string, double>;
using Points = std::vector<SampledPoint>;

/// 2 and 3: shift, then rotation about x, from y towards z.
void shiftAndRotate(const SimpackSettings& settings, Points& points)
{
  const double angle = settings.at("rotate") / settings.at("units.ang.f");
  for (SampledPoint& p : points)
  {
    p.y += settings.at("shift.y");
    p.z += settings.at("shift.z");
  }
  rotate(angle, points);
}

/// 4: omits points outside the bounds. A lower bound above the upper bound switches the bounds off.
void cutToBounds(const SimpackSettings& settings, Points& points)
{
  const auto outside = [&settings](double value, const std::string& axis)
  {
    const double least = settings.at("bound." + axis + ".min");
    const double most = settings.at("bound." + axis + ".max");
    return least <= most && (value < least || value > most);
  };
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](const SampledPoint& p) { return outside(p.y, "y") || outside(p.z, "z"); }),
               points.end());
}

/// 5 and 6: mirror, then reversal of the order.
void mirrorAndInvert(const SimpackSettings& settings, Points& points)
{
  for (SampledPoint& p : points)
  {
    p.y *= settings.at("mirror.y") == 1.0 ? -1.0 : 1.0;
    p.z *= settings.at("mirror.z") == 1.0 ? -1.0 : 1.0;
  }
  if (settings.at("inversion") == 1.0)
  {
    std::reverse(points.begin(), points.end());
  }
}

/// Applies the edits in Simpack's own order to the points as listed in the file (z down), in the unit of the file. 1:
/// omits points too close to the preceding one.
void applyEdits(const SimpackSettings& settings, Points& points)
{
  points = thinnedOut(points, settings.at("point.dist.min"));
  shiftAndRotate(settings, points);
  cutToBounds(settings, points);
  mirrorAndInvert(settings, points);
}

/// Line up to the first comment sign (! or %) outside quotes.
std::string withoutRemark(const std::string& line)
{
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    quoted = quoted != (line[i] == '\'');
    if ((line[i] == '!' || line[i] == '%') && !quoted)
    {
      return trim(line.substr(0, i));
    }
  }
  return line;
}

class SimpackReader
{
 public:
  SimpackReader(TextFile& file, ProfileKind kind) : file_(file), kind_(kind) {}

  FileProfile read()
  {
    while (file_.next())
    {
      const std::string line = withoutRemark(file_.line());
      if (line.empty() || changeBlock(line))
      {
        continue;
      }
      if (block_ == Block::points)
      {
        readPoint(line);
      }
      else
      {
        readSetting(line);
      }
    }
    checkComplete();
    checkSettings();
    applyEdits(settings_, content_.points);
    content_.format = "Simpack";
    content_.unit = 1 / setting("units.len.f");
    content_.unit_in_file = true;
    content_.y = ProfileReading::Y::outward;
    content_.z = ProfileReading::Z::down;
    if (setting("approx.smooth") > 0)
    {
      content_.smoothing = setting("approx.smooth") * *content_.unit;
    }
    return content_;
  }

 private:
  enum class Block
  {
    outside,
    header,
    spline,
    points
  };

  /// Processes a line that opens or closes a block. Returns false for other lines.
  bool changeBlock(const std::string& line)
  {
    static const std::map<std::string, std::pair<Block, Block>> changes{
        {"header.begin", {Block::outside, Block::header}}, {"header.end", {Block::header, Block::outside}},
        {"spline.begin", {Block::outside, Block::spline}}, {"spline.end", {Block::spline, Block::outside}},
        {"point.begin", {Block::spline, Block::points}},   {"point.end", {Block::points, Block::spline}}};
    const auto change = changes.find(line);
    if (change == changes.end())
    {
      return false;
    }
    const auto [from, to] = change->second;
    file_.refuseIf(block_ != from, "'" + line + "' is out of place: not a Simpack profile, or damaged");
    file_.refuseIf(to == Block::points && points_ended_, "second block of points");
    block_ = to;
    points_ended_ = points_ended_ || from == Block::points;
    spline_ended_ = spline_ended_ || (from == Block::spline && to == Block::outside);
    return true;
  }

  void readSetting(const std::string& line)
  {
    const std::size_t equals = line.find('=');
    file_.refuseIf(equals == std::string::npos || block_ == Block::outside,
                   "line is neither a comment nor a block nor a keyword: not a Simpack profile");
    const std::string key = trim(line.substr(0, equals));
    // Keywords without influence on the profile.
    static const std::set<std::string> remarks{"file", "file.mtime", "comment", "type", "units.len", "units.ang"};
    if (block_ == Block::spline && remarks.count(key) > 0)
    {
      return;
    }
    const std::optional<double> value = parseNumber(trim(line.substr(equals + 1)));
    file_.refuseIf(!value, "value of '" + key + "' is not a number");
    if (block_ == Block::header)
    {
      readHeader(key, *value);
      return;
    }
    const auto known = settings_.find(key);
    file_.refuseIf(known == settings_.end(),
                   "unknown keyword '" + key + "'; delete the line if it does not change the profile");
    known->second = *value;
  }

  void readHeader(const std::string& key, double value)
  {
    if (key == "version")
    {
      file_.refuseIf(value != 1.0, "format version is not 1");
      return;
    }
    file_.refuseIf(key != "type", "unknown keyword '" + key + "'");
    file_.refuseIf(value != 0.0 && value != 1.0, "type is neither 0 (rail) nor 1 (wheel)");
    file_.refuseIf((value == 1.0) != (kind_ == ProfileKind::wheel), value == 1.0
                                                                        ? "wheel profile; a rail profile is required"
                                                                        : "rail profile; a wheel profile is required");
    type_known_ = true;
  }

  void readPoint(const std::string& line)
  {
    const std::vector<std::string> words = splitWords(line);
    file_.refuseIf(words.size() < 2 || words.size() > 3,
                   "not a point: two coordinates and an optional weight are required");
    double values[3] = {0.0, 0.0, 1.0};
    for (std::size_t i = 0; i < words.size(); ++i)
    {
      values[i] = file_.numberIn(words[i]);
    }
    file_.refuseIf(values[2] < 0.0, "weight is negative");
    if (values[2] > 0.0)
    {
      addPoint(file_, content_, {values[0], values[1], values[2]}, words[1]);
    }
  }

  void checkComplete() const
  {
    file_.refuseIf(!type_known_, 0, "no header with a type: not a Simpack profile");
    file_.refuseIf(!points_ended_, "file ends before point.end: truncated");
    file_.refuseIf(!spline_ended_, "file ends before spline.end: truncated");
  }

  void checkSettings() const
  {
    for (const char* key : {"mirror.y", "mirror.z", "inversion"})
    {
      file_.refuseIf(setting(key) != 0.0 && setting(key) != 1.0, 0, std::string(key) + " is neither 0 nor 1");
    }
    for (const char* key : {"approx.smooth", "point.dist.min"})
    {
      file_.refuseIf(setting(key) < 0.0, 0, std::string(key) + " is negative");
    }
    for (const char* key : {"units.len.f", "units.ang.f"})
    {
      file_.refuseIf(!(setting(key) > 0.0), 0, std::string(key) + " is not positive");
    }
  }

  double setting(const std::string& key) const { return settings_.at(key); }

  TextFile& file_;
  ProfileKind kind_;
  SimpackSettings
      settings_{
          {"approx.smooth", 0.0}, {"point.dist.min", 0.0}, {"shift.y", 0.0},     {"shift.z", 0.0},
          {"rotate", 0.0},        {"bound.y.min", 1.0},    {"bound.y.max", 0.0}, {"bound.z.min", 1.0},
          {"bound.z.max", 0.0},   {"mirror.y", 0.0},       {"mirror.z", 0.0},    {"inversion", 0.0},
          {"units.len.f", 1.0},   {"units.ang.f", 1.0}};  ///< with the values that apply if a file does not state them
  Block block_ = Block::outside;
  bool type_known_ = false;
  bool points_ended_ = false;
  bool spline_ended_ = false;
  FileProfile content_;
};
}  // namespace

FileProfile readSimpack(TextFile& file, ProfileKind kind)
{
  return SimpackReader(file, kind).read();
}
}  // namespace wheel_rail_contact::core
