// SPDX-License-Identifier: BSD-3-Clause
// Slices files of the reference code.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>

#include "core/profile/files/steps.h"
#include "core/text/words.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double largest_count = 20000;  ///< of slices or features
constexpr double per_mm = 1e-3;          ///< [m]

/// Values of a slices file, word by word, without its comments.
class SlicesFile : public TextFile
{
 public:
  using TextFile::TextFile;

  /// Reads the words of the next line that has any.
  /// @param least  least number of words
  std::vector<std::string> words(std::size_t least, const std::string& content)
  {
    while (next())
    {
      std::vector<std::string> found = splitWords(text());
      if (found.empty())
      {
        continue;
      }
      refuseIf(found.size() < least, "must contain " + content);
      return found;
    }
    refuse("ends before " + content);
  }

  std::size_t count(const std::string& word) const
  {
    const double value = numberIn(word);
    refuseIf(!(value >= 0 && value <= largest_count) || value != std::floor(value),
             "'" + word + "' is not a number of slices or features");
    return static_cast<std::size_t>(value);
  }

  /// Current line without its comment.
  std::string text() const { return line().substr(0, line().find('%')); }
};

/// Slice of a rail from a file.
struct FileSlice
{
  Profile profile;
  bool reversed;     ///< true if the profile begins at the last point of the file
  std::string text;  ///< what was understood, in one line
};

/// Reads a slice of a rail: a file of readProfile(). A table without titles has y to the field side and z down; it is
/// in metres if it is less than 1 wide, else in millimetres.
/// @throw FileError as readProfile().
FileSlice readSlice(const std::string& path, const ProfileReading& reading)
{
  constexpr ProfileKind kind = ProfileKind::rail_section;
  TextFile file(path);
  FileProfile content = readContent(file, kind);
  const auto [left, right] = std::minmax_element(content.points.begin(), content.points.end(), isFartherInward);
  file.refuseIf(content.points.empty(), 0, "has no points");
  if (!content.unit)
  {
    content.unit = right->y - left->y < 1 ? 1 : 1e-3;
  }
  content.y = content.y.value_or(ProfileReading::Y::outward);
  content.z = content.z.value_or(ProfileReading::Z::down);
  const bool runs_outward = (content.points.front().y < content.points.back().y) ==
                            (reading.y.value_or(*content.y) == ProfileReading::Y::outward);
  DescribedProfile described = profileOf(file, content, kind, reading);
  return {std::move(described.profile), runs_outward == reading.mirror, described.report.text};
}

/// Place and file name of a slice.
struct Slice
{
  double x;
  std::string name;
  bool reversed;  ///< see FileSlice
};

Slice sliceOf(SlicesFile& file, double scale)
{
  const std::vector<std::string> words = file.words(2, "a place and a file name in quotes");
  const std::string line = file.text();
  const std::size_t open = line.find('\''), close = line.rfind('\'');
  file.refuseIf(open == close, "the name of a file must be in quotes");
  return {scale * file.numberIn(words[0]), line.substr(open + 1, close - open - 1), false};
}

std::vector<Slice> slicesOf(SlicesFile& file, std::size_t count, double scale)
{
  std::vector<Slice> slices;
  for (std::size_t i = 0; i < count; ++i)
  {
    slices.push_back(sliceOf(file, scale));
    file.refuseIf(i > 0 && !(slices[i].x > slices[i - 1].x), "the places of the slices must increase");
  }
  return slices;
}

/// Parameters of the features on the profile of a slice; NaN where it has none.
std::vector<double> featuresOf(SlicesFile& file, std::size_t count, double scale, const Slice& slice, double length)
{
  const std::vector<std::string> words = file.words(count + 1, "a place and the position of each feature");
  file.refuseIf(std::abs(scale * file.numberIn(words[0]) - slice.x) > per_mm,
                "the places of the features must be those of the slices, in the same order");
  std::vector<double> features;
  double before = -1;
  for (std::size_t k = 1; k <= count; ++k)
  {
    const double position = per_mm * file.numberIn(words[k]);
    if (position < 0)
    {
      features.push_back(std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    file.refuseIf(!(position > before) || position > length + per_mm,
                  "'" + words[k] + "': the positions of the features must increase, up to the length of the curve");
    before = position;
    const double u = std::min(position, length);
    features.push_back(slice.reversed ? length - u : u);
  }
  if (slice.reversed)
  {
    std::reverse(features.begin(), features.end());
  }
  return features;
}

bool isSame(const Profile& a, const Profile& b)
{
  const auto at_same_points = [&](double u)
  {
    const CurvePoint p = a.at(u), q = b.at(u);
    return p.y == q.y && p.z == q.z;
  };
  return a.discontinuities() == b.discontinuities() &&
         std::all_of(a.discontinuities().begin(), a.discontinuities().end(), at_same_points);
}

/// Reads the files of the slices. Equal slices share one profile: the rail does not change between them.
RailSeries seriesOf(std::vector<Slice>& slices, const std::string& path, const ProfileReading& reading,
                    std::vector<std::string>& notes)
{
  RailSeries series;
  std::map<std::string, std::pair<std::shared_ptr<const Profile>, bool>> read;
  for (Slice& slice : slices)
  {
    auto& [profile, reversed] = read[slice.name];
    if (!profile)
    {
      FileSlice own = readSlice((std::filesystem::path(path).parent_path() / slice.name).string(), reading);
      profile = std::make_shared<const Profile>(std::move(own.profile));
      reversed = own.reversed;
      notes.push_back(slice.name + ": " + own.text);
    }
    if (!series.empty() && isSame(*profile, *series.back().profile))
    {
      profile = series.back().profile;
    }
    slice.reversed = reversed;
    series.push_back({slice.x, profile, {}});
  }
  return series;
}
}  // namespace

RailSeries readRailSlices(const std::string& path, const ProfileReading& reading)
{
  std::vector<std::string> notes;
  return readRailSlices(path, reading, notes);
}

RailSeries readRailSlices(const std::string& path, const ProfileReading& reading, std::vector<std::string>& notes)
{
  SlicesFile file(path);
  const std::vector<std::string> scaling = file.words(2, "U_OFFSET and the scale of the places [mm]");
  file.refuseIf(file.numberIn(scaling[0]) != 0, "U_OFFSET = " + scaling[0] + ": must be 0; add it to the places");
  const double scale = per_mm * file.numberIn(scaling[1]);
  file.refuseIf(!(scale > 0), "scale of the places = " + scaling[1] + ": must be positive");
  const std::size_t count = file.count(file.words(1, "the number of slices")[0]);
  file.refuseIf(count == 0, "the number of slices must not be 0");
  const std::vector<std::string> counts = file.words(3, "the numbers of features, kinks and accelerations");
  const std::size_t features = file.count(counts[0]);
  file.words(1, "the method of interpolation");
  std::vector<Slice> slices = slicesOf(file, count, scale);
  for (std::size_t kind = 1; kind <= 2; ++kind)  // kinks and accelerations, which are not used
  {
    if (const std::size_t parts = file.count(counts[kind]); parts > 0)
    {
      file.words(parts, "part numbers");
    }
  }
  RailSeries series = seriesOf(slices, path, reading, notes);
  for (std::size_t i = 0; i < count && features > 0; ++i)
  {
    series[i].places = featuresOf(file, features, scale, slices[i], series[i].profile->length());
  }
  while (file.next())
  {
    file.refuseIf(!splitWords(file.text()).empty(), "more lines than the stated numbers of slices and features");
  }
  return series;
}
}  // namespace wheel_rail_contact::core
