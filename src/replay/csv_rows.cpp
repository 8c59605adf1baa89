// SPDX-License-Identifier: BSD-3-Clause
#include "replay/csv_rows.h"

#include <charconv>
#include <cinttypes>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "ros/evaluation/contact_statistics.h"
#include "ros/evaluation/text.h"

namespace wheel_rail_contact
{
namespace
{
/// Column names with units: first the columns of the result, then those of the patch.
constexpr const char* header =
    "result [-],wheelset,stamp [s],status,reason,held [-],implausible_force [-],x [m],y [m],z [m],roll [rad],yaw "
    "[rad],distance [m],"
    "left_rail_lateral [m],left_rail_vertical [m],left_rail_roll [rad],left_lateral_force [N],left_vertical_force [N],"
    "left_given_lateral [m],left_given_vertical [m],left_given_roll [rad],"
    "right_rail_lateral [m],right_rail_vertical [m],right_rail_roll [rad],right_lateral_force [N],"
    "right_vertical_force [N],right_given_lateral [m],right_given_vertical [m],right_given_roll [rad],"
    "left_wheel_vertical_force [N],left_wheel_lateral_force [N],right_wheel_vertical_force [N],"
    "right_wheel_lateral_force [N],rail_force_x [N],rail_force_y [N],rail_force_z [N],rail_torque_x [N m],"
    "rail_torque_y [N m],rail_torque_z [N m],"
    "side,patch_y [m],patch_z [m],contact_angle [rad],normal_force [N],approach [m],area [m^2],max_pressure [Pa],"
    "error_estimate [-],iterations [-],residual [-],method,half_space_ratio [rad],"
    "model_error [-],vertical_force [N],lateral_force [N],semi_axis_along [m],semi_axis_across [m],rolling_radius "
    "[m],wheel_s [m],"
    "wheel_angle [rad],rail_s [m],curvature_along [1/m],curvature_across [1/m],normal_stiffness [N/m],"
    "wheel_von_mises [Pa],wheel_von_mises_x [m],wheel_von_mises_y [m],wheel_von_mises_depth [m],wheel_shear [Pa],"
    "wheel_shear_depth [m],wheel_load_factor [-],wheel_shakedown_limit [-],"
    "rail_von_mises [Pa],rail_von_mises_x [m],rail_von_mises_y [m],rail_von_mises_depth [m],rail_shear [Pa],"
    "rail_shear_depth [m],rail_load_factor [-],rail_shakedown_limit [-]\n";
constexpr const char* no_patch = ",,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,";

/// Cell with nine significant digits, which is finer than any tolerance.
std::string cell(double value)
{
  return formatted("%.9g,", value);
}

std::string quoted(const std::string& text)
{
  std::string result = "\"";
  for (const char c : text)
  {
    result += c == '"' ? "\"\"" : std::string(1, c == '\n' ? ' ' : c);
  }
  return result + '"';
}

std::string stamp(const ros::Time& time)
{
  return formatted("%" PRIu32 ".%09" PRIu32, time.sec, time.nsec);
}

std::string cells(const RailDeflection& rail)
{
  return cell(rail.lateral) + cell(rail.vertical) + cell(rail.roll) + cell(rail.lateral_force) +
         cell(rail.vertical_force) + cell(rail.given_lateral) + cell(rail.given_vertical) + cell(rail.given_roll);
}

std::string cells(const WheelForces& wheel)
{
  return cell(wheel.vertical_force) + cell(wheel.lateral_force);
}

std::string cells(const geometry_msgs::Wrench& wrench)
{
  return cell(wrench.force.x) + cell(wrench.force.y) + cell(wrench.force.z) + cell(wrench.torque.x) +
         cell(wrench.torque.y) + cell(wrench.torque.z);
}

std::string cells(const PatchStress& stress)
{
  return cell(stress.von_mises.value) + cell(stress.von_mises.x) + cell(stress.von_mises.y) +
         cell(stress.von_mises.depth) + cell(stress.shear.value) + cell(stress.shear.depth) + cell(stress.load_factor) +
         cell(stress.shakedown_limit);
}

/// All cells of a patch; the last one ends without a comma.
std::string cells(const ContactPatch& patch)
{
  std::string row = (patch.side == ContactPatch::LEFT ? "left," : "right,") + cell(patch.pose.position.y) +
                    cell(patch.pose.position.z) + cell(patch.contact_angle) + cell(patch.normal_force) +
                    cell(patch.approach) + cell(patch.area) + cell(patch.max_pressure) + cell(patch.error_estimate) +
                    cell(patch.iterations) + cell(patch.residual) + patch.method + "," + cell(patch.half_space_ratio) +
                    cell(patch.model_error) + cell(patch.vertical_force) + cell(patch.lateral_force) +
                    cell(patch.semi_axis_along) + cell(patch.semi_axis_across) + cell(patch.rolling_radius) +
                    cell(patch.wheel_s) + cell(patch.wheel_angle) + cell(patch.rail_s) + cell(patch.curvature_along) +
                    cell(patch.curvature_across) + cell(patch.normal_stiffness) + cells(patch.wheel_stress) +
                    cells(patch.rail_stress);
  row.pop_back();
  return row;
}

/// Cells of roll and yaw [rad] of an orientation without pitch, Rz(yaw) Rx(roll).
std::string angles(const geometry_msgs::Quaternion& q)
{
  return cell(2 * std::atan2(q.x, q.w)) + cell(2 * std::atan2(q.z, q.w));
}
}  // namespace

std::string csvRows(const WheelsetContact& result, std::uint64_t number, const std::string& wheelset)
{
  const auto& position = result.wheelset.position;
  const std::string start =
      std::to_string(number) + "," + wheelset + "," + stamp(result.header.stamp) + "," + statusName(result.status) +
      "," + quoted(result.status_text) + (result.held ? ",1," : ",0,") + (result.implausible_force ? "1," : "0,") +
      cell(position.x) + cell(position.y) + cell(position.z) + angles(result.wheelset.orientation) +
      cell(result.distance) + cells(result.left_rail) + cells(result.right_rail) + cells(result.left_wheel) +
      cells(result.right_wheel) + cells(result.rail_wrench);
  if (result.patches.empty())
  {
    return start + no_patch + "\n";
  }
  std::string rows;
  for (const ContactPatch& patch : result.patches)
  {
    rows += start + cells(patch) + "\n";
  }
  return rows;
}

void CsvFile::requireUsablePath(const std::string& path, bool resume)
{
  if (std::filesystem::exists(path) != resume)
  {
    throw std::runtime_error(path + (resume ? ": does not exist; --resume requires the table of the first run"
                                            : ": already exists and is not overwritten"));
  }
}

CsvFile::CsvFile(const std::string& path, bool resume) : path_(path), truncation_pending_(resume)
{
  requireUsablePath(path, resume);
  if (!resume)
  {
    file_.open(path);
    file_ << header;
    flush();
  }
}

void CsvFile::write(std::uint64_t number, const std::string& rows)
{
  if (truncation_pending_)
  {
    truncate(number);
  }
  file_ << rows;
}

void CsvFile::flush()
{
  if (!truncation_pending_ && !file_.flush())
  {
    throw std::runtime_error(path_ + ": cannot be written");
  }
}

void CsvFile::finish(std::uint64_t results)
{
  if (truncation_pending_)
  {
    truncate(results);
  }
  flush();
}

/// Removes the rows of result `number` and of all later results. Opens the file for appending.
void CsvFile::truncate(std::uint64_t number)
{
  std::ifstream before(path_);
  std::string line;
  std::getline(before, line);
  if (line + "\n" != header)
  {
    throw std::runtime_error(path_ + ": is not a table written by contact_replay");
  }
  std::uint64_t length = line.size() + 1;
  std::uint64_t results = 0;
  while (std::getline(before, line) && !before.eof())
  {
    const std::uint64_t result = resultOf(line);
    if (result >= number)
    {
      break;
    }
    length += line.size() + 1;
    results = result + 1;
  }
  if (results != number)
  {
    throw std::runtime_error(path_ + ": rows of results that are in the bag are missing");
  }
  std::filesystem::resize_file(path_, length);
  file_.open(path_, std::ios::app);
  truncation_pending_ = false;
}

std::uint64_t CsvFile::resultOf(const std::string& row) const
{
  std::uint64_t number = 0;
  if (std::from_chars(row.data(), row.data() + row.size(), number).ec != std::errc())
  {
    throw std::runtime_error(path_ + ": a row does not begin with the number of a result: " + row);
  }
  return number;
}
}  // namespace wheel_rail_contact
