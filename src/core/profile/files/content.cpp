// SPDX-License-Identifier: BSD-3-Clause
#include "core/profile/files/content.h"

#include <algorithm>
#include <filesystem>

#include "core/text/words.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr std::size_t most_points = 200000;

enum class Format
{
  simpack,
  miniprof,
  table
};

/// Name of a key=value line, in lower case; empty if it is none.
std::string keyOf(const std::string& line)
{
  const std::size_t begin = line.find_first_not_of("\" \t"), equals = line.find('=');
  return begin < equals && equals != std::string::npos ? lowerCase(trim(line.substr(begin, equals - begin))) : "";
}

/// Format that the content shows; nothing if it could be any.
std::optional<Format> shownFormat(TextFile& file)
{
  std::optional<Format> format;
  while (!format && file.next())
  {
    const std::string word = splitWords(withoutComment(file.line()) + " -")[0], key = keyOf(file.line());
    if (word == "header.begin" || word == "spline.begin" || word == "point.begin")
    {
      format = Format::simpack;
    }
    else if (key == "columndef" || key == "xypoints" || (file.number() == 1 && beginsOldMiniProf(file.line())))
    {
      format = Format::miniprof;
    }
    else if (namesCoordinates(file.line()))
    {
      format = Format::table;
    }
    else if (parseNumber(word))
    {
      break;
    }
  }
  file.rewind();
  return format;
}

/// Format of a file of numbers: its name shows a MiniProf file whose header is missing or has other keys.
Format formatByName(const TextFile& file, ProfileKind kind)
{
  const std::string extension = lowerCase(std::filesystem::path(file.path()).extension().string());
  const bool of_wheel = extension == ".whl", of_rail = extension == ".ban";
  if (!of_wheel && !of_rail)
  {
    return Format::table;
  }
  file.refuseIf(of_wheel != (kind == ProfileKind::wheel), 0,
                "extension " + extension + " does not belong to a " + (of_wheel ? "rail" : "wheel") + " profile");
  return Format::miniprof;
}
}  // namespace

bool beginsOldMiniProf(const std::string& line)
{
  const std::string text = lowerCase(line);
  return text.compare(0, 5, "#mini") == 0 || text.compare(0, 8, "miniprof") == 0;
}

FileProfile readContent(TextFile& file, ProfileKind kind)
{
  const std::optional<Format> shown = shownFormat(file);
  switch (shown ? *shown : formatByName(file, kind))
  {
    case Format::simpack:
      return readSimpack(file, kind);
    case Format::miniprof:
      return readMiniProf(file, kind);
    default:
      return readProfileTable(file);
  }
}

void addPoint(const TextFile& file, FileProfile& content, SampledPoint point, const std::string& z_text)
{
  file.refuseIf(content.points.size() >= most_points, file.number(), "more than ", most_points, " points");
  point.line = file.number();
  content.points.push_back(point);
  content.decimals = std::max(content.decimals.value_or(decimalPlaces(z_text)), decimalPlaces(z_text));
}

std::vector<SampledPoint> thinnedOut(const std::vector<SampledPoint>& points, double least)
{
  std::vector<SampledPoint> kept;
  for (const SampledPoint& p : points)
  {
    if (kept.empty() || distance(kept.back(), p) >= least)
    {
      kept.push_back(p);
    }
  }
  return kept;
}

void rotate(double angle, std::vector<SampledPoint>& points)
{
  const double c = std::cos(angle), s = std::sin(angle);
  for (SampledPoint& p : points)
  {
    p = {c * p.y - s * p.z, s * p.y + c * p.z, p.weight, p.line};
  }
}
}  // namespace wheel_rail_contact::core
