// SPDX-License-Identifier: BSD-3-Clause
// Slices files of the reference code.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>

#include "core/profile/profile_file.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double largest_count = 20000;  ///< of slices or features
constexpr double per_mm = 1e-3;          ///< [m]

/// Values of a slices file, word by word, without its comments.
class SlicesFile
{
 public:
  explicit SlicesFile(const std::string& path) : file_(path) {}

  /// Reads the words of the next line that has any.
  /// @param least  least number of words
  std::vector<std::string> line(std::size_t least, const std::string& content)
  {
    while (file_.next())
    {
      std::vector<std::string> words = splitWords(file_.line().substr(0, file_.line().find('%')));
      if (words.empty())
      {
        continue;
      }
      if (words.size() < least)
      {
        file_.refuse("must contain " + content);
      }
      return words;
    }
    file_.refuse("ends before " + content);
  }

  double number(const std::string& word) const
  {
    const std::optional<double> value = parseNumber(word);
    if (!value)
    {
      file_.refuse("'" + word + "' is not a number");
    }
    return *value;
  }

  std::size_t count(const std::string& word) const
  {
    const double value = number(word);
    if (!(value >= 0 && value <= largest_count) || value != std::floor(value))
    {
      file_.refuse("'" + word + "' is not a number of slices or features");
    }
    return static_cast<std::size_t>(value);
  }

  const ProfileFile& file() const { return file_; }

 private:
  ProfileFile file_;
};

/// Place and file name of a slice.
struct Slice
{
  double x;
  std::string name;
};

Slice sliceOf(SlicesFile& file, double scale)
{
  const std::vector<std::string> words = file.line(2, "a place and a file name in quotes");
  const std::string& line = file.file().line();
  const std::size_t open = line.find('\''), close = line.rfind('\'');
  if (open == close)
  {
    file.file().refuse("the name of a file must be in quotes");
  }
  return {scale * file.number(words[0]), line.substr(open + 1, close - open - 1)};
}

/// Positions of the features of a slice along its curve [m]; NaN where it has none.
std::vector<double> featuresOf(SlicesFile& file, std::size_t count, double x, double scale)
{
  const std::vector<std::string> words = file.line(count + 1, "a place and the position of each feature");
  if (std::abs(scale * file.number(words[0]) - x) > per_mm)
  {
    file.file().refuse("the places of the features must be those of the slices, in the same order");
  }
  std::vector<double> features;
  for (std::size_t k = 1; k <= count; ++k)
  {
    const double position = per_mm * file.number(words[k]);
    features.push_back(position >= 0 ? position : std::numeric_limits<double>::quiet_NaN());
  }
  return features;
}

/// Features as parameters of the profile that was read.
std::vector<double> placesOn(const Profile& profile, const std::vector<double>& features, bool mirrored)
{
  std::vector<double> places;
  for (const double feature : features)
  {
    const double u = std::isfinite(feature) ? std::min(feature, profile.length()) : feature;
    places.push_back(mirrored ? profile.length() - u : u);
  }
  if (mirrored)
  {
    std::reverse(places.begin(), places.end());
  }
  return places;
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
}  // namespace

RailSeries readRailSlices(const std::string& path, const ProfileReading& reading)
{
  SlicesFile file(path);
  const std::vector<std::string> scaling = file.line(2, "U_OFFSET and the scale of the places [mm]");
  if (file.number(scaling[0]) != 0)
  {
    file.file().refuse("U_OFFSET = " + scaling[0] + ": must be 0; add it to the places");
  }
  const double scale = per_mm * file.number(scaling[1]);
  const std::size_t count = file.count(file.line(1, "the number of slices")[0]);
  const std::vector<std::string> counts = file.line(3, "the numbers of features, kinks and accelerations");
  const std::size_t features = file.count(counts[0]);
  file.line(1, "the method of interpolation");
  std::vector<Slice> slices;
  for (std::size_t i = 0; i < count; ++i)
  {
    slices.push_back(sliceOf(file, scale));
  }
  for (const std::size_t unused : {file.count(counts[1]), file.count(counts[2])})
  {
    if (unused > 0)
    {
      file.line(unused, "part numbers");
    }
  }
  RailSeries series;
  std::map<std::string, std::shared_ptr<const Profile>> read;
  for (const Slice& slice : slices)
  {
    std::shared_ptr<const Profile>& profile = read[slice.name];
    if (!profile)
    {
      const std::string own = (std::filesystem::path(path).parent_path() / slice.name).string();
      profile = std::make_shared<const Profile>(readSlice(own, reading));
    }
    if (!series.empty() && isSame(*profile, *series.back().profile))
    {
      profile = series.back().profile;  // no change between equal slices
    }
    series.push_back({slice.x, profile, {}});
  }
  for (std::size_t i = 0; i < count && features > 0; ++i)
  {
    series[i].places = placesOn(*series[i].profile, featuresOf(file, features, series[i].x, scale), reading.mirror);
  }
  return series;
}
}  // namespace wheel_rail_contact::core
