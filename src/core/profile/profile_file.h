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
/// Text file that is read line by line, with limits for its size. Every error message contains the file and the line.
class ProfileFile
{
 public:
  /// Reads the whole file.
  /// @throw ProfileError if it is not a readable text file, empty or too large.
  explicit ProfileFile(const std::string& path);

  /// Moves to the next line.
  /// @return false after the last line.
  /// @throw ProfileError if the line is too long.
  bool next();
  /// Current line, without white space at its ends.
  const std::string& line() const { return line_; }
  /// Number of the current line, from 1.
  std::size_t number() const { return number_; }

  /// Throws a ProfileError for the current line.
  [[noreturn]] void refuse(const std::string& reason) const;
  /// Throws a ProfileError for the line with the given number, from 1; 0: for the file as a whole.
  [[noreturn]] void refuse(std::size_t line, const std::string& reason) const;

 private:
  std::string path_;
  std::string text_;
  std::size_t position_ = 0;
  std::string line_;
  std::size_t number_ = 0;
};

/// Point as listed in a file, with the number of its line.
struct FilePoint
{
  SampledPoint point;
  std::size_t line;
};

/// Content of a file in the profile frame [m]. The points may run in either direction.
struct FileProfile
{
  std::vector<FilePoint> points;
  double noise = 0;               ///< expected standard deviation across the curve [m]
  double overlap = 0;             ///< largest distance over which a measurement may run back [m]
  bool height_from_tape = false;  ///< z is counted from the height of the profile itself at y = 0
};

/// Reads a Simpack file.
/// @throw ProfileError if it is malformed, truncated or of the other kind.
FileProfile readSimpack(ProfileFile& file, ProfileKind kind);
/// Reads a MiniProf file.
/// @throw ProfileError if it is malformed or truncated.
FileProfile readMiniProf(ProfileFile& file, ProfileKind kind);
/// Reads a CSV file.
/// @throw ProfileError if it is malformed.
FileProfile readCsv(ProfileFile& file);

/// Reads a file of two columns: y to the field side, z down; in metres if the curve is less than 1 wide, else in
/// millimetres. % begins a comment.
/// @throw ProfileError if it is malformed.
FileProfile readTwoColumns(ProfileFile& file);
/// Slice of a rail from a file.
struct FileSlice
{
  Profile profile;
  bool reversed;  ///< true if the profile begins at the last point of the file
};
/// Reads a slice of a rail: a file of readProfile(), or of two columns.
/// @throw ProfileError as readProfile().
FileSlice readSlice(const std::string& path, const ProfileReading& reading);

/// Checks that the content is a plausible profile of the given kind. Returns its points in order from the gauge
/// (flange) side to the field side, without points too close to the preceding one.
/// @throw ProfileError with the line and the broken rule.
std::vector<SampledPoint> orderedPoints(const ProfileFile& file, const FileProfile& content, ProfileKind kind);

/// Appends a point.
/// @throw ProfileError if the file has too many points.
void addPoint(const ProfileFile& file, FileProfile& content, const SampledPoint& point);

/// Converts a word to a finite number, with a decimal point in any locale; nothing if it is not one.
std::optional<double> parseNumber(const std::string& word);
/// Words of a line, separated by white space.
std::vector<std::string> splitWords(const std::string& line);
/// Fields of a line, without white space at their ends.
std::vector<std::string> splitFields(const std::string& line, char separator = ',');
/// Text without white space at its ends.
std::string trim(const std::string& text);
/// Text with the letters A to Z in lower case.
std::string lowerCase(std::string text);
}  // namespace wheel_rail_contact::core
