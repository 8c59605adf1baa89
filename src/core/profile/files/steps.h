// SPDX-License-Identifier: BSD-3-Clause
// The way from the content of a file to a profile. Each step follows the ones before it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/profile/files/content.h"

namespace wheel_rail_contact::core
{
/// Unit and directions of the coordinates of a file.
struct FileAxes
{
  double unit;  ///< [m]
  ProfileReading::Y y;
  ProfileReading::Z z;
};

/// Points of a file in the profile frame [m].
struct PlacedPoints
{
  std::vector<SampledPoint> points;
  double moved_y = 0, moved_z = 0;  ///< distances by which the origin was moved outward and up [m]
  std::string remark{};             ///< what was omitted; empty if nothing
};

/// Orders points by their height.
inline bool isLower(const SampledPoint& a, const SampledPoint& b)
{
  return a.z < b.z;
}

/// Orders points from the gauge side to the field side.
inline bool isFartherInward(const SampledPoint& a, const SampledPoint& b)
{
  return a.y < b.y;
}

/// Puts a cloud of more than 20000 points in order, and averages it along the curve [m]. @return what was done
/// @throw FileError if they are not one curve.
std::string averageCloud(const TextFile& file, ProfileKind kind, std::vector<SampledPoint>& points);
/// Range of y of the points at most `depth` below the highest one [m].
std::pair<double, double> widthAt(const std::vector<SampledPoint>& points, double depth);
/// Keeps the running head of a rail [m]: of a whole rail, of a head with its underside, and of several heads, such as
/// that of a grooved rail and its lip, the widest one on the field side. @return what was omitted beside it
/// @throw FileError if the running head of several is not clear.
std::string keepHead(const TextFile& file, std::vector<SampledPoint>& points);
/// Height of a curve at y = 0 [m], the nearest to 0 if there are several; infinite if it does not cross y = 0.
double heightAtOrigin(const std::vector<SampledPoint>& points);
/// Brings the points to the profile frame: unit, axes, origin, shift, rotation and mirror, in this order.
/// @throw FileError if the points have no such origin.
PlacedPoints placedPoints(const TextFile& file, const FileProfile& content, ProfileKind kind, const FileAxes& axes,
                          const ProfileReading& reading);

/// Checks number and extent of points [m].
/// @throw FileError
void checkSize(const TextFile& file, const std::vector<SampledPoint>& points);
/// Checks the shape of points in order: that of a wheel, of a rail, or of a section of one.
/// @throw FileError
void checkShape(const TextFile& file, const std::vector<SampledPoint>& points, ProfileKind kind);
/// Checks that points in the profile frame are a plausible profile of the given kind. Returns them in order from the
/// gauge (flange) side to the field side, without points too close to the preceding one, and without those at which a
/// measurement of two strokes runs back.
/// @throw FileError with the line and the broken rule.
std::vector<SampledPoint> orderedPoints(const TextFile& file, const std::vector<SampledPoint>& points,
                                        ProfileKind kind);

/// Points of a file in the profile frame and in order, and the axes that the file has.
struct FramedPoints
{
  FileAxes axes;
  PlacedPoints placed;
};

/// Places and orders the points, by the unit and the axes that `reading`, the file or its format states.
/// @throw FileError as the two steps, if `reading` contradicts the unit in the file, and if one of them is not known.
/// The reason gives the values by which the points are a profile.
FramedPoints framedPoints(const TextFile& file, const FileProfile& content, ProfileKind kind,
                          const ProfileReading& reading);

/// Curve through or near the points of a file, with what is not known of it.
/// @param unit    length unit of the file [m]
/// @param points  in order, in the profile frame; points that lie off the curve are omitted
/// @param report  its noise and smoothing are set; a remark on what was done with the points is added
/// @throw FileError if the points are no smooth curve, or if a stated smoothing is not possible.
std::vector<ProfileSection> curveThrough(const TextFile& file, const FileProfile& content, double unit,
                                         const ProfileReading& reading, std::vector<SampledPoint>& points,
                                         ProfileReport& report);

/// Profile of a file, with what was understood.
/// @throw FileError as above.
/// @throw std::invalid_argument if an option is out of range.
DescribedProfile profileOf(const TextFile& file, FileProfile content, ProfileKind kind, ProfileReading reading);
}  // namespace wheel_rail_contact::core
