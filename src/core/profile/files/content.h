// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/profile/curve/spline.h"
#include "core/text/text_file.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core
{
/// Points of a file in its own unit and axes, and what the format or the file states about them. The points may run in
/// either direction.
struct FileProfile
{
  const char* format = "table";        ///< name of the format
  std::vector<SampledPoint> points;    ///< y and z as listed, after the edits that are stated in the file
  std::optional<double> unit;          ///< [m]; nothing: not known
  bool unit_in_file = false;           ///< the file itself states the unit
  std::optional<ProfileReading::Y> y;  ///< direction of y; nothing: not known
  std::optional<ProfileReading::Z> z;  ///< direction of z; nothing: not known
  bool from_flange_back = false;       ///< y of a wheel is counted from its flange back, by the format
  double running_circle = 0;           ///< y of the running circle of a wheel that the file states [m]; 0: none
  std::optional<double> smoothing;     ///< noise that the file states [m]
  std::optional<int> decimals;         ///< largest number of decimal places of z
  double magnification = 1;            ///< of the points, relative to those of the file [-]
  std::string remark;                  ///< what was ignored; empty if nothing
};

/// Reads a Simpack file: format by the lines `header.begin` and `spline.begin`.
/// @throw FileError if it is malformed, truncated or of the other kind.
FileProfile readSimpack(TextFile& file, ProfileKind kind);
/// Reads a MiniProf file.
/// @throw FileError if it is malformed or truncated.
FileProfile readMiniProf(TextFile& file, ProfileKind kind);
/// Reads a table with a column of y and one of z.
/// @throw FileError if it is malformed.
FileProfile readProfileTable(TextFile& file);
/// Reads a file of any format, which its content determines.
/// @throw FileError as above.
FileProfile readContent(TextFile& file, ProfileKind kind);

/// Appends a point, with the number of the current line.
/// @param z_text  its z as written
/// @throw FileError if the file has too many points.
void addPoint(const TextFile& file, FileProfile& content, SampledPoint point, const std::string& z_text);
/// Points without those closer to the preceding kept one than a distance.
std::vector<SampledPoint> thinnedOut(const std::vector<SampledPoint>& points, double least);
/// Rotates points about the origin, from y towards z [rad].
void rotate(double angle, std::vector<SampledPoint>& points);
/// True if the first line of a file is that of an old MiniProf file, whose header is free text.
bool beginsOldMiniProf(const std::string& line);
/// True if a line contains the titles of a table with columns of y and z.
bool namesCoordinates(const std::string& line);
}  // namespace wheel_rail_contact::core
