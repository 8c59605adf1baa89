// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/profile/smoothing_spline.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core
{
/// Text file read line by line within bounds; every refusal names the file and the line.
class ProfileFile
{
 public:
  /// Reads the whole file.
  /// @throw ProfileError if it is no readable text file or too large.
  explicit ProfileFile(const std::string& path);

  /// Moves to the next line; false behind the last.
  bool next();
  /// The present line without white space at its ends.
  const std::string& line() const { return line_; }
  std::size_t number() const { return number_; }

  /// Refuses the file because of the present line.
  [[noreturn]] void refuse(const std::string& reason) const;
  /// Refuses the file because of a line counted from 1, or as a whole for 0.
  [[noreturn]] void refuse(std::size_t line, const std::string& reason) const;

 private:
  std::string path_;
  std::string text_;
  std::size_t position_ = 0;
  std::string line_;
  std::size_t number_ = 0;
};

/// A point as the file gives it, with the line it stands in.
struct FilePoint
{
  SampledPoint point;
  std::size_t line;
};

/// Content of a file in the profile frame [m]; the points may run either way.
struct FileProfile
{
  std::vector<FilePoint> points;
  double noise = 0;               ///< expected standard deviation across the curve [m]
  double overlap = 0;             ///< by how much a measurement may run back [m]
  bool height_from_tape = false;  ///< z counts from the profile's own height at y = 0
};

FileProfile readSimpack(ProfileFile& file, ProfileKind kind);
FileProfile readMiniProf(ProfileFile& file, ProfileKind kind);
FileProfile readCsv(ProfileFile& file);

/// Checks that the content is a plausible profile of that kind, and returns its points in order from the gauge (flange)
/// side to the field side, without those that are too near the one before.
/// @throw ProfileError with the line and the rule that is broken.
std::vector<SampledPoint> orderedPoints(const ProfileFile& file, const FileProfile& content, ProfileKind kind);

/// Adds a point.
/// @throw ProfileError if the file has too many.
void addPoint(const ProfileFile& file, FileProfile& content, const SampledPoint& point);

/// The number a word consists of, or nothing; finite, with a decimal point whatever the locale.
std::optional<double> parseNumber(const std::string& word);
/// The words of a line, separated by white space.
std::vector<std::string> splitWords(const std::string& line);
/// The fields of a line, separated by commas, without white space at their ends.
std::vector<std::string> splitFields(const std::string& line);
/// Without white space at its ends.
std::string trim(const std::string& text);
/// With the letters A to Z in lower case.
std::string lowerCase(std::string text);
}  // namespace wheel_rail_contact::core
