// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <string>

#include "python/bindings.h"
#include "ros/evaluation/contact_statistics.h"
#include "ros/evaluation/conversions.h"
#include "ros/evaluation/text.h"
#include "wheel_rail_contact/core/wheelset_result.h"

namespace py = pybind11;

namespace wheel_rail_contact
{
namespace
{
using core::PatchResult;
using core::WheelsetResult;

std::string textOf(const PatchResult& patch)
{
  constexpr double degree = 3.14159265358979323846 / 180;
  return formatted("<PatchResult %s: %.0f MPa, %.2f kN, %.1f mm², %.2f°>", nameOf(patch.side), patch.max_pressure / 1e6,
                   patch.normal_force / 1e3, patch.area * 1e6, patch.contact_angle / degree);
}

std::string textOf(const WheelsetResult& result)
{
  const char* status = statusName(toMessage(result.status));
  if (!isUsable(result.status))
  {
    return std::string("<WheelsetResult ") + status + ": " + result.reason + ">";
  }
  double highest = 0;
  for (const PatchResult& patch : result.patches)
  {
    highest = std::max(highest, patch.max_pressure);
  }
  return formatted("<WheelsetResult %s: y %.3f mm, z %.3f mm, roll %.3f mrad, %d patches, %.0f MPa>", status,
                   result.y * 1e3, result.z * 1e3, result.roll * 1e3, static_cast<int>(result.patches.size()),
                   highest / 1e6);
}

/// Centres of the cells along one direction [m].
Eigen::ArrayXd centres(int count, double first, double width)
{
  return first + width * Eigen::ArrayXd::LinSpaced(count, 0, count - 1);
}

void bindForces(py::module& module)
{
  using core::RailDeflection;
  using core::RailResult;
  using core::WheelForces;
  using core::Wrench;
  py::class_<WheelForces>(module, "WheelForces", "Contact forces of a wheel on its rail, by the normal pressure.")
      .def_readonly("vertical_force", &WheelForces::vertical, "Q, down positive [N]")
      .def_readonly("lateral_force", &WheelForces::lateral, "Y, outward positive [N]")
      .def("__repr__", [](const WheelForces& forces)
           { return formatted("<WheelForces: Q %.2f kN, Y %.2f kN>", forces.vertical / 1e3, forces.lateral / 1e3); });
  py::class_<Wrench>(module, "Wrench", "Force and moment, track axes.")
      .def_readonly("force", &Wrench::force, "force along x, y, z; (3,) [N]")
      .def_readonly("moment", &Wrench::moment, "moment about the axle centre; (3,) [N m]")
      .def("__repr__",
           [](const Wrench& wrench)
           {
             const Eigen::Vector3d force = wrench.force / 1e3, moment = wrench.moment / 1e3;
             return formatted("<Wrench: force (%.2f, %.2f, %.2f) kN, moment (%.2f, %.2f, %.2f) kN m>", force.x(),
                              force.y(), force.z(), moment.x(), moment.y(), moment.z());
           });
  py::class_<RailDeflection>(module, "RailDeflection", "Displacement of a rail head at its reference point.")
      .def_readonly("lateral", &RailDeflection::lateral, "outward positive [m]")
      .def_readonly("vertical", &RailDeflection::vertical, "up positive [m]")
      .def_readonly("roll", &RailDeflection::roll, "rotation, positive if the crown moves outward [rad]")
      .def("__repr__",
           [](const RailDeflection& rail)
           {
             return formatted("<RailDeflection: lateral %.4f mm, vertical %.4f mm, roll %.4f mrad>", rail.lateral * 1e3,
                              rail.vertical * 1e3, rail.roll * 1e3);
           });
  py::class_<RailResult>(module, "RailResult", "Displacement of a rail, and the forces on it.")
      .def_readonly("deflection", &RailResult::deflection, "whole displacement from its place in the ideal track")
      .def_readonly("given", &RailResult::given, "its part by the line and with the state")
      .def_readonly("lateral_force", &RailResult::lateral_force,
                    "lateral force that bends the rail, outward positive [N]")
      .def_readonly("vertical_force", &RailResult::vertical_force, "vertical force of the wheel, down positive [N]")
      .def_readonly("moment", &RailResult::moment,
                    "moment of both about the reference point of the head, outward roll positive [N m]")
      .def("__repr__",
           [](const RailResult& rail)
           {
             return formatted("<RailResult: lateral %.4f mm, vertical %.4f mm, roll %.4f mrad, Q %.2f kN, Y %.2f kN>",
                              rail.deflection.lateral * 1e3, rail.deflection.vertical * 1e3, rail.deflection.roll * 1e3,
                              rail.vertical_force / 1e3, rail.lateral_force / 1e3);
           });
}

void bindPatch(py::module& module)
{
  using core::PatchPose;
  py::class_<PatchPose>(module, "PatchPose", "Pose of a patch frame: x forward, y left in the tangent plane.")
      .def_readonly("x", &PatchPose::x, "along the track, from the axle centre [m]")
      .def_readonly("y", &PatchPose::y, "in the track frame [m]")
      .def_readonly("z", &PatchPose::z, "in the track frame [m]")
      .def_readonly("angle", &PatchPose::angle, "rotation about x, right-handed [rad]")
      .def("__repr__",
           [](const PatchPose& pose)
           {
             return formatted("<PatchPose: x %.3f mm, y %.3f mm, z %.3f mm, angle %.3f mrad>", pose.x * 1e3,
                              pose.y * 1e3, pose.z * 1e3, pose.angle * 1e3);
           });
  py::class_<PatchResult>(module, "PatchResult", "A contact patch: a separate loaded region between wheel and rail.")
      .def_property_readonly(
          "side", [](const PatchResult& patch) { return nameOf(patch.side); }, "left or right")
      .def_readonly("method", &PatchResult::method, "method that solved the patch")
      .def_readonly("pose", &PatchResult::pose, "patch frame; its origin is the centre of pressure")
      .def_readonly("contact_angle", &PatchResult::contact_angle,
                    "angle to the track plane, positive where the wheel presses the rail outward [rad]")
      .def_readonly("normal_force", &PatchResult::normal_force, "resultant of the pressure [N]")
      .def_readonly("vertical_force", &PatchResult::vertical_force, "its part Q on the rail, down positive [N]")
      .def_readonly("lateral_force", &PatchResult::lateral_force, "its part Y on the rail, outward positive [N]")
      .def_readonly("approach", &PatchResult::approach, "approach along the normal, from first touch [m]")
      .def_readonly("area", &PatchResult::area, "contact area [m²]")
      .def_readonly("max_pressure", &PatchResult::max_pressure, "highest pressure, found between the cells [Pa]")
      .def_readonly("error_estimate", &PatchResult::error_estimate,
                    "largest estimated relative error of max_pressure, area and approach [-]")
      .def_readonly("iterations", &PatchResult::iterations, "number of products with the influence matrix")
      .def_readonly("residual", &PatchResult::residual, "largest violation of the contact conditions, relative [-]")
      .def_readonly("half_space_ratio", &PatchResult::half_space_ratio,
                    "half the angle by which the section turns across the patch [rad]")
      .def_readonly("model_error", &PatchResult::model_error,
                    "bound of the relative error of max_pressure and area because of the half-spaces; 1: not known [-]")
      .def_readonly("left_out", &PatchResult::left_out,
                    "what the method leaves out of the contact of curved surfaces: 'column normals', 'patch coupling'")
      .def_readonly("semi_axis_along", &PatchResult::semi_axis_along, "of the equivalent ellipse, along x [m]")
      .def_readonly("semi_axis_across", &PatchResult::semi_axis_across, "of the equivalent ellipse, along y [m]")
      .def_readonly("rolling_radius", &PatchResult::rolling_radius, "of the centre of pressure, from the axle [m]")
      .def_readonly("wheel_s", &PatchResult::wheel_s, "arc length on the wheel profile, outward positive [m]")
      .def_readonly("wheel_angle", &PatchResult::wheel_angle, "place around the wheel, forward positive [rad]")
      .def_readonly("rail_s", &PatchResult::rail_s, "arc length on the rail profile, outward positive [m]")
      .def_readonly("curvature_along", &PatchResult::curvature_along, "combined, along x, convex positive [1/m]")
      .def_readonly("curvature_across", &PatchResult::curvature_across, "combined, across, convex positive [1/m]")
      .def_readonly("normal_stiffness", &PatchResult::normal_stiffness, "normal force per approach [N/m]")
      .def_readonly("wheel_stress", &PatchResult::wheel_stress, "PatchStress in the wheel")
      .def_readonly("rail_stress", &PatchResult::rail_stress, "PatchStress in the rail")
      .def_readonly("pressure", &PatchResult::pressure, "(nx, ny) pressures of the cells, read-only [Pa]")
      .def_property_readonly(
          "x", [](const PatchResult& patch) { return centres(patch.grid.nx, patch.grid.x0, patch.grid.dx); },
          "(nx,) centres of the cells along the track, forward, in the patch frame [m]")
      .def_property_readonly(
          "y", [](const PatchResult& patch) { return centres(patch.grid.ny, patch.grid.y0, patch.grid.dy); },
          "(ny,) centres of the cells across the track, left, along the arc of the rail's section [m]")
      .def_property_readonly(
          "dx", [](const PatchResult& patch) { return patch.grid.dx; }, "length of a cell along the track [m]")
      .def_property_readonly(
          "dy", [](const PatchResult& patch) { return patch.grid.dy; }, "width of a cell across the track [m]")
      .def("__repr__", [](const PatchResult& patch) { return textOf(patch); });
}
}  // namespace

void bindResults(py::module& module)
{
  bindForces(module);
  bindPatch(module);
  py::class_<WheelsetResult>(module, "WheelsetResult", "Contact of a wheelset with both rails in one state.")
      .def_property_readonly(
          "status", [](const WheelsetResult& result) { return statusName(toMessage(result.status)); },
          "name of the status, as in the message WheelsetContact: OK, LIFT_OFF, ...")
      .def_property_readonly(
          "usable", [](const WheelsetResult& result) { return isUsable(result.status); },
          "True if the status is OK or LIFT_OFF; otherwise forces and rails are not valid, and there is no patch")
      .def_readonly("reason", &WheelsetResult::reason, "reason for the status, or a warning; empty if there is none")
      .def_readonly("above_tolerance", &WheelsetResult::above_tolerance,
                    "the estimated error of a wheel is above contact/tolerance")
      .def_readonly("points_missing", &WheelsetResult::points_missing,
                    "a contact is where points of a profile file are missing")
      .def_readonly("near_branch", &WheelsetResult::near_branch, "another equilibrium of the state was found")
      .def_readonly("implausible_force", &WheelsetResult::implausible_force,
                    "the contact force of a wheel is beyond a plausible bound")
      .def_readonly("x", &WheelsetResult::x, "axle centre in the track frame [m]")
      .def_readonly("y", &WheelsetResult::y, "axle centre in the track frame [m]")
      .def_readonly("z", &WheelsetResult::z, "axle centre in the track frame; the solved (or given) height [m]")
      .def_readonly("yaw", &WheelsetResult::yaw, "rotation of the axle about z, positive to the left [rad]")
      .def_readonly("roll", &WheelsetResult::roll, "the solved (or given) rotation, positive if left is raised [rad]")
      .def_property_readonly(
          "left_wheel", [](const WheelsetResult& result) { return result.wheel.left; }, "forces of the left wheel")
      .def_property_readonly(
          "right_wheel", [](const WheelsetResult& result) { return result.wheel.right; }, "forces of the right wheel")
      .def_property_readonly(
          "left_rail", [](const WheelsetResult& result) { return result.rail.left; }, "displacement of the left rail")
      .def_property_readonly(
          "right_rail", [](const WheelsetResult& result) { return result.rail.right; },
          "displacement of the right rail")
      .def_readonly("rail_wrench", &WheelsetResult::rail_wrench, "of the pressure of both rails on the wheelset")
      .def_readonly("patches", &WheelsetResult::patches, "list of PatchResult, left side first")
      .def("__repr__", [](const WheelsetResult& result) { return textOf(result); });
}
}  // namespace wheel_rail_contact
