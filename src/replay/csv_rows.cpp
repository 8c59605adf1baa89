// SPDX-License-Identifier: BSD-3-Clause
#include "replay/csv_rows.h"

#include <algorithm>
#include <charconv>
#include <cinttypes>
#include <cmath>
#include <filesystem>
#include <system_error>

#include "config/result_fields.h"
#include "config/text.h"
#include "core/option_check.h"
#include "ros/evaluation/contact_statistics.h"

namespace wheel_rail_contact
{
namespace
{
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

/// One pass over the columns of the table: the line of their names, or a row.
class Line
{
 public:
  explicit Line(bool has_names) : has_names_(has_names) {}

  /// @param name with the unit, if there is one
  void add(const std::string& name, const std::string& cell)
  {
    text_ += (text_.empty() ? "" : ",") + (has_names_ ? name : cell);
  }
  void add(const std::string& name, const char* /*unit*/, const std::string& text) { add(name, text); }
  /// Cell with nine significant digits, which is finer than any tolerance.
  void add(const std::string& name, const char* unit, double value)
  {
    text_ += (text_.empty() ? "" : ",") + (has_names_ ? name + " [" + unit + "]" : formatted("%.9g", value));
  }

  const std::string& text() const { return text_; }

 private:
  bool has_names_;
  std::string text_;
};

void addRail(const std::string& side, const RailDeflection& rail, Line& line)
{
  visitRail(
      [&](const ResultField& field, auto /*core*/, auto message)
      {
        const std::string name = field.name;
        if (name != "moment")
        {
          const bool is_whole = name.find('_') == std::string::npos;  // a displacement, not its part or a force
          line.add(side + (is_whole ? "_rail_" : "_") + name, field.unit, message(rail));
        }
      });
}

void addWheel(const std::string& side, const WheelForces& wheel, Line& line)
{
  visitWheel([&](const ResultField& field, auto /*core*/, auto message)
             { line.add(side + "_wheel_" + field.name, field.unit, message(wheel)); });
}

void addVector(const std::string& name, const char* unit, const geometry_msgs::Vector3& vector, Line& line)
{
  line.add(name + "_x", unit, vector.x);
  line.add(name + "_y", unit, vector.y);
  line.add(name + "_z", unit, vector.z);
}

void addStress(const std::string& body, const PatchStress& stress, Line& line)
{
  line.add(body + "_von_mises", "Pa", stress.von_mises.value);
  line.add(body + "_von_mises_x", "m", stress.von_mises.x);
  line.add(body + "_von_mises_y", "m", stress.von_mises.y);
  line.add(body + "_von_mises_depth", "m", stress.von_mises.depth);
  line.add(body + "_shear", "Pa", stress.shear.value);
  line.add(body + "_shear_depth", "m", stress.shear.depth);
  visitStress([&](const ResultField& field, auto /*core*/, auto message)
              { line.add(body + "_" + field.name, field.unit, message(stress)); });
}

/// Columns of a patch, after those of the result.
void addPatch(const ContactPatch& patch, Line& line)
{
  line.add("side", patch.side == ContactPatch::LEFT ? "left" : "right");
  line.add("patch_y", "m", patch.pose.position.y);
  line.add("patch_z", "m", patch.pose.position.z);
  visitPatch([&](const ResultField& field, auto /*core*/, auto message)
             { line.add(field.name, field.unit, message(patch)); });
  visitCreep([&](const ResultField& field, auto /*core*/, auto message)
             { line.add(std::string("creep_") + field.name, field.unit, message(patch.creep)); });
  addStress("wheel", patch.wheel_stress, line);
  addStress("rail", patch.rail_stress, line);
}

void addResult(const WheelsetContact& result, std::uint64_t number, const std::string& wheelset, Line& line)
{
  const auto& position = result.wheelset.position;
  const auto& q = result.wheelset.orientation;  // without pitch: Rz(yaw) Rx(roll)
  line.add("result [-]", std::to_string(number));
  line.add("wheelset", wheelset);
  line.add("stamp [s]", stamp(result.header.stamp));
  line.add("status", statusName(result.status));
  line.add("reason", quoted(result.status_text));
  line.add("held [-]", result.held ? "1" : "0");
  line.add("implausible_force [-]", result.implausible_force ? "1" : "0");
  line.add("x", "m", position.x);
  line.add("y", "m", position.y);
  line.add("z", "m", position.z);
  line.add("roll", "rad", 2 * std::atan2(q.x, q.w));
  line.add("yaw", "rad", 2 * std::atan2(q.z, q.w));
  line.add("distance", "m", result.distance);
  line.add("speed", "m/s", result.speed);
  line.add("rotation", "rad/s", result.rotation);
  addRail("left", result.left_rail, line);
  addRail("right", result.right_rail, line);
  addWheel("left", result.left_wheel, line);
  addWheel("right", result.right_wheel, line);
  addVector("rail_force", "N", result.rail_wrench.force, line);
  addVector("rail_torque", "N m", result.rail_wrench.torque, line);
}

std::string patchText(const ContactPatch& patch, bool names)
{
  Line line(names);
  addPatch(patch, line);
  return "," + line.text() + "\n";
}

std::string header()
{
  Line line(true);
  addResult({}, 0, "", line);
  return line.text() + patchText({}, true);
}
}  // namespace

std::string csvRows(const WheelsetContact& result, std::uint64_t number, const std::string& wheelset)
{
  Line start(false);
  addResult(result, number, wheelset, start);
  if (result.patches.empty())
  {
    static const std::string names = patchText({}, true);
    static const auto columns = static_cast<std::size_t>(std::count(names.begin(), names.end(), ','));
    return start.text() + std::string(columns, ',') + "\n";
  }
  std::string rows;
  for (const ContactPatch& patch : result.patches)
  {
    rows += start.text() + patchText(patch, false);
  }
  return rows;
}

void CsvFile::requireUsablePath(const std::string& path, bool resume)
{
  core::refuseIf<std::runtime_error>(std::filesystem::exists(path) != resume,
                                     path + (resume ? ": does not exist; --resume requires the table of the first run"
                                                    : ": already exists and is not overwritten"));
}

CsvFile::CsvFile(const std::string& path, bool resume) : path_(path), truncation_pending_(resume)
{
  requireUsablePath(path, resume);
  if (!resume)
  {
    file_.open(path);
    file_ << header();
    flush();
  }
}

void CsvFile::write(std::uint64_t number, const std::string& rows)
{
  truncate(number);
  file_ << rows;
}

void CsvFile::flush()
{
  core::refuseIf<std::runtime_error>(!truncation_pending_ && !file_.flush(), path_ + ": cannot be written");
}

void CsvFile::finish(std::uint64_t results)
{
  truncate(results);
  flush();
}

/// When resuming, once: removes the rows of result `number` and of all later results, and opens the file for appending.
void CsvFile::truncate(std::uint64_t number)
{
  if (!truncation_pending_)
  {
    return;
  }
  std::ifstream before(path_);
  std::string line;
  std::getline(before, line);
  core::refuseIf<std::runtime_error>(line + "\n" != header(), path_ + ": is not a table written by contact_replay");
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
  core::refuseIf<std::runtime_error>(results != number, path_ + ": rows of results that are in the bag are missing");
  std::filesystem::resize_file(path_, length);
  file_.open(path_, std::ios::app);
  truncation_pending_ = false;
}

std::uint64_t CsvFile::resultOf(const std::string& row) const
{
  std::uint64_t number = 0;
  core::refuseIf<std::runtime_error>(std::from_chars(row.data(), row.data() + row.size(), number).ec != std::errc(),
                                     path_ + ": a row does not begin with the number of a result: " + row);
  return number;
}
}  // namespace wheel_rail_contact
