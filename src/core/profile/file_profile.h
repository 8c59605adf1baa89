// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/profile/smoothing_spline.h"
#include "core/text/text_file.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core
{
/// Point as listed in a file, with the number of its line.
struct FilePoint
{
  SampledPoint point;
  std::size_t line;
};

/// Points of a file in its own unit and axes, and what the format or the file states about them. The points may run in
/// either direction.
struct FileProfile
{
  const char* format = "table";        ///< name of the format
  std::vector<FilePoint> points;       ///< y and z as listed, after the edits that are stated in the file
  std::optional<double> unit;          ///< [m]; nothing: not known
  bool unit_in_file = false;           ///< the file itself states the unit
  std::optional<ProfileReading::Y> y;  ///< direction of y; nothing: not known
  std::optional<ProfileReading::Z> z;  ///< direction of z; nothing: not known
  double running_circle = 0;           ///< y of the running circle of a wheel [m]; 0: y is counted from there
  std::optional<double> smoothing;     ///< noise that the file states [m]
  std::optional<int> decimals;         ///< largest number of decimal places of z
  std::string remark;                  ///< what was ignored; empty if nothing
};

/// Reads a Simpack file: format by the lines `header.begin` and `spline.begin`.
/// @throw TextError if it is malformed, truncated or of the other kind.
FileProfile readSimpack(TextFile& file, ProfileKind kind);
/// Reads a MiniProf file.
/// @throw TextError if it is malformed or truncated.
FileProfile readMiniProf(TextFile& file, ProfileKind kind);
/// Reads a table with a column of y and one of z.
/// @throw TextError if it is malformed.
FileProfile readProfileTable(TextFile& file);
/// Reads a file of any format, which its content determines.
/// @throw TextError as above.
FileProfile readContent(TextFile& file, ProfileKind kind);

/// Appends a point.
/// @param z_text  its z as written
/// @throw TextError if the file has too many points.
void addPoint(const TextFile& file, FileProfile& content, const SampledPoint& point, const std::string& z_text);

/// Slice of a rail from a file.
struct FileSlice
{
  Profile profile;
  bool reversed;     ///< true if the profile begins at the last point of the file
  std::string text;  ///< what was understood, in one line
};
/// Reads a slice of a rail: a file of readProfile(). A table without titles has y to the field side and z down; it is
/// in metres if it is less than 1 wide, else in millimetres.
/// @throw TextError as readProfile().
FileSlice readSlice(const std::string& path, const ProfileReading& reading);
}  // namespace wheel_rail_contact::core
