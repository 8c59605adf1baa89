// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/conversions.h"

#include <algorithm>

#include "config/result_fields.h"
#include "core/option_check.h"

namespace wheel_rail_contact
{
namespace
{
/// Assigns a field of a message from one of the core, or back.
template <typename To, typename From>
void assign(const From& from, To& to)
{
  to = static_cast<To>(from);
}

/// Method of a patch. `auto` is refused: a patch has the method that auto chose.
void assign(const std::string& from, std::string_view& to)
{
  const core::NormalMethod method = core::methodNamed(from);
  core::refuseIf(method == core::NormalMethod::automatic, "method = 'auto': not the method of a patch");
  to = toString(method);
}

/// Visitor of fields that copies each from the core to the message.
template <typename Core, typename Message>
auto writing(const Core& from, Message& to)
{
  return [&from, &to](const ResultField& /*field*/, auto core, auto message) { assign(core(from), message(to)); };
}

/// Visitor of fields that copies each from the message to the core.
template <typename Message, typename Core>
auto reading(const Message& from, Core& to)
{
  return [&from, &to](const ResultField& /*field*/, auto core, auto message) { assign(message(from), core(to)); };
}

Eigen::Vector3d fromMessage(const geometry_msgs::Vector3& message)
{
  return {message.x, message.y, message.z};
}

void addField(const std::vector<core::StressLayer>& field, PatchStress& message)
{
  for (const core::StressLayer& layer : field)
  {
    message.depths.push_back(layer.depth);
    for (const Eigen::ArrayXXd& component : layer.components)
    {
      const std::size_t begin = message.stress.size();
      message.stress.resize(begin + static_cast<std::size_t>(component.size()));
      Eigen::Map<Eigen::ArrayXXf>(message.stress.data() + begin, component.rows(), component.cols()) =
          component.cast<float>();
    }
  }
}

PatchStress stressMessage(const core::PatchStress& stress, bool with_field)
{
  PatchStress message;
  visitStress(writing(stress, message));
  visitPeak(writing(stress.von_mises, message.von_mises));
  visitPeak(writing(stress.shear, message.shear));
  if (with_field)
  {
    addField(stress.field, message);
  }
  return message;
}

core::PatchStress fromMessage(const PatchStress& message, const core::PatchGrid& grid)
{
  core::PatchStress stress;
  visitStress(reading(message, stress));
  visitPeak(reading(message.von_mises, stress.von_mises));
  visitPeak(reading(message.shear, stress.shear));
  const std::size_t components = std::tuple_size<decltype(core::StressLayer::components)>::value;
  const std::size_t cells = static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(grid.ny);
  core::refuseIf(message.stress.size() != message.depths.size() * components * cells,
                 "stress field: ", message.stress.size(), " values for ", message.depths.size(),
                 " depths and a grid of ", grid.nx, " x ", grid.ny);
  const float* values = message.stress.data();
  for (const double depth : message.depths)
  {
    core::StressLayer& layer = stress.field.emplace_back();
    layer.depth = depth;
    for (Eigen::ArrayXXd& component : layer.components)
    {
      component = Eigen::Map<const Eigen::ArrayXXf>(values, grid.nx, grid.ny).cast<double>();
      values += cells;
    }
  }
  return stress;
}

/// Tractions of a message on a grid; empty if it has none.
Eigen::ArrayXXd tractions(const std::vector<float>& values, const core::PatchGrid& grid, const char* name)
{
  if (values.empty())
  {
    return {};
  }
  const std::size_t cells = static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(grid.ny);
  core::refuseIf(values.size() != cells, name, ": ", values.size(), " values for a grid of ", grid.nx, " x ", grid.ny);
  return Eigen::Map<const Eigen::ArrayXXf>(values.data(), grid.nx, grid.ny).cast<double>();
}

std::vector<float> tractionMessage(const Eigen::ArrayXXd& tractions)
{
  std::vector<float> values(static_cast<std::size_t>(tractions.size()));
  Eigen::Map<Eigen::ArrayXXf>(values.data(), tractions.rows(), tractions.cols()) = tractions.cast<float>();
  return values;
}

/// Entries of a matrix, row by row.
template <typename Matrix>
std::vector<double> entriesOf(const Matrix& matrix)
{
  static_assert(Matrix::IsRowMajor);
  return {matrix.data(), matrix.data() + matrix.size()};
}

template <typename Matrix>
void readEntries(const std::vector<double>& values, const char* name, Matrix& matrix)
{
  constexpr std::size_t rows = Matrix::RowsAtCompileTime, most = Matrix::MaxSizeAtCompileTime;
  core::refuseIf(values.size() % rows != 0 || values.size() > most, name, ": ", values.size(), " values for ", rows,
                 " rows of at most ", most / rows);
  matrix = Eigen::Map<const Matrix>(values.data(), rows, static_cast<Eigen::Index>(values.size() / rows));
}

/// Wheelset pose of a message; zero without a pose (hasPose()).
core::WheelsetPose wheelsetPoseFromMessage(const geometry_msgs::Pose& pose)
{
  if (!hasPose(pose))
  {
    return {};
  }
  const auto& p = pose.position;
  const auto& o = pose.orientation;
  return toWheelsetPose(Eigen::Translation3d(p.x, p.y, p.z) * Eigen::Quaterniond(o.w, o.x, o.y, o.z).normalized());
}

/// Pose of a patch frame relative to `x`.
core::PatchPose patchPoseFromMessage(const geometry_msgs::Pose& pose, double x)
{
  core::PatchPose result;
  result.x = pose.position.x - x;
  result.y = pose.position.y;
  result.z = pose.position.z;
  result.angle = 2 * std::atan2(pose.orientation.x, pose.orientation.w);
  result.pitch = 2 * std::atan2(pose.orientation.y, pose.orientation.w);
  return result;
}
}  // namespace

geometry_msgs::Vector3 vectorMessage(const Eigen::Vector3d& v)
{
  geometry_msgs::Vector3 message;
  message.x = v.x();
  message.y = v.y();
  message.z = v.z();
  return message;
}

geometry_msgs::Quaternion toMessage(const Eigen::Quaterniond& q)
{
  geometry_msgs::Quaternion message;
  message.x = q.x();
  message.y = q.y();
  message.z = q.z();
  message.w = q.w();
  return message;
}

std::uint8_t toMessage(core::ContactStatus status)
{
  return static_cast<std::uint8_t>(status);
}

core::ContactStatus statusFromMessage(std::uint8_t status)
{
  core::refuseIf(status > WheelsetContact::TOO_DEEP,
                 "wheelset contact: status " + std::to_string(status) + " is unknown");
  return status == WheelsetContact::NO_TRANSFORM ? core::ContactStatus::invalid_input
                                                 : static_cast<core::ContactStatus>(status);
}

bool isUsable(std::uint8_t status)
{
  return status == WheelsetContact::OK || status == WheelsetContact::LIFT_OFF;
}

core::WheelsetPose toWheelsetPose(const Eigen::Isometry3d& pose)
{
  const Eigen::Vector3d axle = pose.linear().col(1);
  return {pose.translation().y(), pose.translation().z(), std::atan2(-axle.x(), axle.y()),
          std::asin(std::clamp(axle.z(), -1.0, 1.0))};
}

double pitchOf(const Eigen::Isometry3d& pose, const core::WheelsetPose& wheelset)
{
  const Eigen::Vector3d forward(std::cos(wheelset.yaw), std::sin(wheelset.yaw), 0);
  return std::atan2(forward.dot(pose.linear().col(2)), forward.dot(pose.linear().col(0)));
}

bool hasPose(const geometry_msgs::Pose& pose)
{
  const auto& o = pose.orientation;
  return o.x != 0 || o.y != 0 || o.z != 0 || o.w != 0;
}

geometry_msgs::Pose toMessage(const core::WheelsetPose& pose, double x)
{
  geometry_msgs::Pose message;
  message.position.x = x;
  message.position.y = pose.y;
  message.position.z = pose.z;
  message.orientation = toMessage(Eigen::AngleAxisd(pose.yaw, Eigen::Vector3d::UnitZ()) *
                                  Eigen::AngleAxisd(pose.roll, Eigen::Vector3d::UnitX()));
  return message;
}

geometry_msgs::Pose toMessage(const core::PatchPose& pose, double x)
{
  geometry_msgs::Pose message;
  message.position.x = x + pose.x;
  message.position.y = pose.y;
  message.position.z = pose.z;
  message.orientation = toMessage(pose.rotation());
  return message;
}

PressureGrid toMessage(const core::PatchGrid& grid, const Eigen::ArrayXXd& pressure)
{
  core::refuseIf(grid.nx < 0 || grid.ny < 0 || pressure.rows() != grid.nx || pressure.cols() != grid.ny,
                 "pressure grid: ", pressure.rows(), " x ", pressure.cols(), " values for a grid of ", grid.nx, " x ",
                 grid.ny);
  PressureGrid message;
  visitGrid(writing(grid, message));
  message.pressure.resize(static_cast<std::size_t>(pressure.size()));
  Eigen::Map<Eigen::ArrayXXf>(message.pressure.data(), grid.nx, grid.ny) = pressure.cast<float>();
  return message;
}

void fromMessage(const PressureGrid& message, core::PatchGrid& grid, Eigen::ArrayXXd& pressure)
{
  constexpr std::uint32_t largest = 1U << 15U;  // of nx and ny, so that their product does not overflow
  const bool fits = message.nx <= largest && message.ny <= largest;
  core::refuseIf(!fits || message.pressure.size() != std::size_t{message.nx} * message.ny,
                 "pressure grid: ", message.pressure.size(), " values for a grid of ", message.nx, " x ", message.ny);
  visitGrid(reading(message, grid));
  pressure = Eigen::Map<const Eigen::ArrayXXf>(message.pressure.data(), grid.nx, grid.ny).cast<double>();
}

ContactPatch toMessage(const core::PatchResult& patch, double x, bool with_grid)
{
  ContactPatch message;
  message.side = patch.side == core::Side::left ? ContactPatch::LEFT : ContactPatch::RIGHT;
  message.pose = toMessage(patch.pose, x);
  visitPatch(writing(patch, message));
  visitCreep(writing(patch.creep, message.creep));
  message.wheel_stress = stressMessage(patch.wheel_stress, with_grid);
  message.rail_stress = stressMessage(patch.rail_stress, with_grid);
  if (with_grid)
  {
    message.grid = toMessage(patch.grid, patch.pressure);
    message.creep.traction_x = tractionMessage(patch.creep.traction_x);
    message.creep.traction_y = tractionMessage(patch.creep.traction_y);
  }
  return message;
}

core::PatchResult fromMessage(const ContactPatch& message, double x)
{
  core::refuseIf(message.side != ContactPatch::LEFT && message.side != ContactPatch::RIGHT,
                 "contact patch: side " + std::to_string(message.side) + " is unknown");
  core::PatchResult patch;
  patch.side = message.side == ContactPatch::LEFT ? core::Side::left : core::Side::right;
  patch.pose = patchPoseFromMessage(message.pose, x);
  visitPatch(reading(message, patch));
  fromMessage(message.grid, patch.grid, patch.pressure);
  visitCreep(reading(message.creep, patch.creep));
  patch.creep.traction_x = tractions(message.creep.traction_x, patch.grid, "traction_x");
  patch.creep.traction_y = tractions(message.creep.traction_y, patch.grid, "traction_y");
  patch.wheel_stress = fromMessage(message.wheel_stress, patch.grid);
  patch.rail_stress = fromMessage(message.rail_stress, patch.grid);
  return patch;
}

WheelsetContact toMessage(const core::WheelsetResult& result, double x, bool with_grids)
{
  WheelsetContact message;
  message.status = toMessage(result.status);
  message.status_text = result.reason;
  message.distance = result.distance;
  message.wheelset = toMessage(core::WheelsetPose{result.y, result.z, result.yaw, result.roll}, x);
  visitWheel(writing(result.wheel.left, message.left_wheel));
  visitWheel(writing(result.wheel.right, message.right_wheel));
  message.rail_wrench.force = vectorMessage(result.rail_wrench.force);
  message.rail_wrench.torque = vectorMessage(result.rail_wrench.moment);
  message.speed = result.speed;
  message.rotation = result.rotation;
  message.implausible_force = result.implausible_force;
  message.derivatives.forces = entriesOf(result.derivatives.forces);
  message.derivatives.solution = entriesOf(result.derivatives.solution);
  visitRail(writing(result.rail.left, message.left_rail));
  visitRail(writing(result.rail.right, message.right_rail));
  message.patches.reserve(result.patches.size());
  for (const core::PatchResult& patch : result.patches)
  {
    message.patches.push_back(toMessage(patch, x, with_grids));
  }
  return message;
}

core::WheelsetResult fromMessage(const WheelsetContact& message)
{
  core::WheelsetResult result;
  result.status = statusFromMessage(message.status);
  result.reason = message.status_text;
  result.distance = message.distance;
  const core::WheelsetPose pose = wheelsetPoseFromMessage(message.wheelset);
  result.y = pose.y;
  result.z = pose.z;
  result.yaw = pose.yaw;
  result.roll = pose.roll;
  visitWheel(reading(message.left_wheel, result.wheel.left));
  visitWheel(reading(message.right_wheel, result.wheel.right));
  result.rail_wrench = {fromMessage(message.rail_wrench.force), fromMessage(message.rail_wrench.torque)};
  result.speed = message.speed;
  result.rotation = message.rotation;
  result.implausible_force = message.implausible_force;
  readEntries(message.derivatives.forces, "derivatives: forces", result.derivatives.forces);
  readEntries(message.derivatives.solution, "derivatives: solution", result.derivatives.solution);
  visitRail(reading(message.left_rail, result.rail.left));
  visitRail(reading(message.right_rail, result.rail.right));
  for (const ContactPatch& patch : message.patches)
  {
    result.patches.push_back(fromMessage(patch, message.wheelset.position.x));
  }
  return result;
}
}  // namespace wheel_rail_contact
