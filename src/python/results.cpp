// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "config/text.h"
#include "core/constants.h"
#include "python/bindings.h"
#include "wheel_rail_contact/core/wheelset_result.h"

namespace py = pybind11;

namespace wheel_rail_contact
{
namespace
{
using core::WheelsetResult;

/// Patch of a result, which it keeps alive.
struct Patch
{
  std::shared_ptr<const WheelsetResult> result;
  const core::PatchResult* patch;
};

/// Pose in the track frame.
struct Pose
{
  Eigen::Vector3d position;  ///< [m]
  double yaw, roll;          ///< [rad]
  double axle_x;             ///< x of the axle centre [m]
  double pitch = 0;          ///< of a patch frame [rad]
};

/// Numbers x, y, z (and w) as an array with these names.
template <typename... Numbers>
py::object vectorOf(Numbers... numbers)
{
  return py::module::import("wheel_rail_contact.core.vector").attr("vector")(numbers...);
}

py::object vectorOf(const Eigen::Vector3d& v)
{
  return vectorOf(v.x(), v.y(), v.z());
}

std::string textOf(const core::PatchResult& patch)
{
  return formatted("<PatchResult %s: %.0f MPa, %.2f kN, %.1f mm², %.2f°>", nameOf(patch.side), patch.max_pressure / 1e6,
                   patch.normal_force / 1e3, patch.area * 1e6, patch.contact_angle / core::degree);
}

std::string textOf(const WheelsetResult& result)
{
  const char* status = nameOf(result.status);
  if (!isUsable(result.status))
  {
    return std::string("<WheelsetResult ") + status + ": " + result.reason + ">";
  }
  double highest = 0;
  for (const core::PatchResult& patch : result.patches)
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

std::string textOf(const core::RailResult& rail)
{
  return formatted("<RailDeflection: lateral %.4f mm, vertical %.4f mm, roll %.4f mrad, Q %.2f kN, Y %.2f kN>",
                   rail.deflection.lateral * 1e3, rail.deflection.vertical * 1e3, rail.deflection.roll * 1e3,
                   rail.vertical_force / 1e3, rail.lateral_force / 1e3);
}

void bindForces(py::module& module)
{
  using core::RailResult;
  using core::WheelForces;
  using core::Wrench;
  py::class_<WheelForces> wheel(module, "WheelForces",
                                "Contact forces of a wheel on its rail, of normal pressure and friction.");
  visitWheel(propertiesOf(wheel));
  wheel.def("__repr__", [](const WheelForces& forces)
            { return formatted("<WheelForces: Q %.2f kN, Y %.2f kN>", forces.vertical / 1e3, forces.lateral / 1e3); });
  py::class_<Wrench>(module, "Wrench", "Force and moment, track axes.")
      .def_property_readonly(
          "force", [](const Wrench& wrench) { return vectorOf(wrench.force); }, "force along x, y, z; (3,) [N]")
      .def_property_readonly(
          "torque", [](const Wrench& wrench) { return vectorOf(wrench.moment); },
          "moment about the axle centre; (3,) [N m]")
      .def("__repr__",
           [](const Wrench& wrench)
           {
             const Eigen::Vector3d force = wrench.force / 1e3, moment = wrench.moment / 1e3;
             return formatted("<Wrench: force (%.2f, %.2f, %.2f) kN, torque (%.2f, %.2f, %.2f) kN m>", force.x(),
                              force.y(), force.z(), moment.x(), moment.y(), moment.z());
           });
  py::class_<RailResult> rail(module, "RailDeflection", "Displacement of a rail, and the forces on it.");
  visitRail(propertiesOf(rail));
  rail.def("__repr__", [](const RailResult& result) { return textOf(result); });
}

void bindPose(py::module& module)
{
  py::class_<Pose>(module, "Pose", "Pose in the track frame.")
      .def_property_readonly(
          "position", [](const Pose& pose) { return vectorOf(pose.position); }, "x, y, z; (3,) [m]")
      .def_property_readonly(
          "orientation",
          [](const Pose& pose)
          {
            const Eigen::Quaterniond q = Eigen::AngleAxisd(pose.yaw, Eigen::Vector3d::UnitZ()) *
                                         Eigen::AngleAxisd(pose.roll, Eigen::Vector3d::UnitX()) *
                                         Eigen::AngleAxisd(pose.pitch, Eigen::Vector3d::UnitY());
            return vectorOf(q.x(), q.y(), q.z(), q.w());
          },
          "quaternion x, y, z, w; (4,)")
      .def_readonly("yaw", &Pose::yaw, "rotation about z, positive to the left [rad]")
      .def_readonly("roll", &Pose::roll, "rotation about x, before the yaw [rad]")
      .def_readonly("_axle_x", &Pose::axle_x)
      .def("__repr__",
           [](const Pose& pose)
           {
             const Eigen::Vector3d p = pose.position * 1e3;
             return formatted("<Pose: x %.3f mm, y %.3f mm, z %.3f mm, yaw %.3f mrad, roll %.3f mrad>", p.x(), p.y(),
                              p.z(), pose.yaw * 1e3, pose.roll * 1e3);
           });
}

void bindCreep(py::module& module)
{
  using core::PatchCreep;
  py::class_<PatchCreep> creep(
      module, "PatchCreep",
      "Friction of a rolling patch, in the patch frame: x forward, y left in the tangent plane, "
      "z out of the rail. All values are 0 without creep forces.");
  visitCreep(propertiesOf(creep));
  creep
      .def_readonly(
          "traction_x", &PatchCreep::traction_x,
          "(nx, ny) traction on the wheel along x in the cells of the pressure, read-only [Pa]; (0, 0) unless "
          "creep/field is set and creep/method is exact")
      .def_readonly("traction_y", &PatchCreep::traction_y, "the same along y [Pa]")
      .def("__repr__",
           [](const PatchCreep& c)
           {
             return formatted("<PatchCreep: creepage (%.3g, %.3g), spin %.3g 1/m, force (%.2f, %.2f) kN, share %.2f>",
                              c.creepage.x, c.creepage.y, c.creepage.spin, c.force.x / 1e3, c.force.y / 1e3,
                              c.adhesion_share);
           });
}

void bindPatch(py::module& module)
{
  const auto of = [](const Patch& of_result) -> const core::PatchResult& { return *of_result.patch; };
  py::class_<Patch> bound(module, "PatchResult", "A contact patch: a separate loaded region between wheel and rail.");
  visitPatch(propertiesOf(bound, of));
  bound
      .def_property_readonly(
          "side", [](const Patch& p) { return nameOf(p.patch->side); }, "left or right")
      .def_property_readonly(
          "pose",
          [](const Patch& p)
          {
            const double x = p.result->x;
            const core::PatchPose& pose = p.patch->pose;
            return Pose{{x + pose.x, pose.y, pose.z}, 0, pose.angle, x, pose.pitch};
          },
          "patch frame; its origin is the centre of pressure")
      .def_property_readonly(
          "left_out", [](const Patch& p) { return p.patch->left_out; },
          "what the method leaves out of the contact of curved surfaces: 'column normals', 'patch coupling'")
      .def_property_readonly(
          "creep", [](const Patch& p) -> const core::PatchCreep& { return p.patch->creep; },
          "PatchCreep, the friction of the rolling wheel")
      .def_property_readonly(
          "wheel_stress", [](const Patch& p) -> const core::PatchStress& { return p.patch->wheel_stress; },
          "PatchStress in the wheel")
      .def_property_readonly(
          "rail_stress", [](const Patch& p) -> const core::PatchStress& { return p.patch->rail_stress; },
          "PatchStress in the rail")
      .def_property_readonly(
          "pressure", [](const Patch& p) -> const Eigen::ArrayXXd& { return p.patch->pressure; },
          "(nx, ny) pressures of the cells, read-only [Pa]")
      .def_property_readonly(
          "x", [of](const Patch& p) { return centres(of(p).grid.nx, of(p).grid.x0, of(p).grid.dx); },
          "(nx,) centres of the cells along the track, forward, in the patch frame [m]")
      .def_property_readonly(
          "y", [of](const Patch& p) { return centres(of(p).grid.ny, of(p).grid.y0, of(p).grid.dy); },
          "(ny,) centres of the cells across the track, left, along the arc of the rail's section [m]")
      .def_property_readonly(
          "dx", [](const Patch& p) { return p.patch->grid.dx; }, "length of a cell along the track [m]")
      .def_property_readonly(
          "dy", [](const Patch& p) { return p.patch->grid.dy; }, "width of a cell across the track [m]")
      .def("__repr__", [](const Patch& p) { return textOf(*p.patch); });
}

std::vector<Patch> patchesIn(const std::shared_ptr<WheelsetResult>& result)
{
  std::vector<Patch> patches;
  for (const core::PatchResult& patch : result->patches)
  {
    patches.push_back({result, &patch});
  }
  return patches;
}
}  // namespace

void bindResults(py::module& module)
{
  using Shared = std::shared_ptr<WheelsetResult>;
  bindForces(module);
  bindPose(module);
  bindCreep(module);
  bindPatch(module);
  py::class_<WheelsetResult, Shared>(module, "WheelsetResult", "Contact of a wheelset with both rails in one state.")
      .def_property_readonly(
          "status", [](const WheelsetResult& result) { return nameOf(result.status); },
          "name of the status, as in the message WheelsetContact: OK, LIFT_OFF, ...")
      .def_property_readonly(
          "usable", [](const WheelsetResult& result) { return isUsable(result.status); },
          "True if the status is OK or LIFT_OFF; otherwise forces and rails are not valid, and there is no patch")
      .def_readonly("status_text", &WheelsetResult::reason,
                    "reason for the status, or a warning; empty if there is none")
      .def_property_readonly(
          "held", [](const WheelsetResult& /*result*/) { return false; }, "False: only the node holds results")
      .def_readonly("above_tolerance", &WheelsetResult::above_tolerance,
                    "the estimated error of a wheel is above contact/tolerance")
      .def_readonly("points_missing", &WheelsetResult::points_missing,
                    "a contact is where points of a profile file are missing")
      .def_readonly("near_branch", &WheelsetResult::near_branch, "another equilibrium of the state was found")
      .def_readonly("implausible_force", &WheelsetResult::implausible_force,
                    "the contact force of a wheel is beyond a plausible bound")
      .def_property_readonly(
          "wheelset",
          [](const WheelsetResult& r) {
            return Pose{{r.x, r.y, r.z}, r.yaw, r.roll, r.x};
          },
          "Pose of the axle centre; height and roll are the solved (or given) ones")
      .def_readonly("distance", &WheelsetResult::distance, "place of the wheelset on the line [m]")
      .def_property_readonly(
          "left_wheel", [](const WheelsetResult& result) { return result.wheel.left; }, "forces of the left wheel")
      .def_property_readonly(
          "right_wheel", [](const WheelsetResult& result) { return result.wheel.right; }, "forces of the right wheel")
      .def_property_readonly(
          "left_rail", [](const WheelsetResult& result) { return result.rail.left; }, "displacement of the left rail")
      .def_property_readonly(
          "right_rail", [](const WheelsetResult& result) { return result.rail.right; },
          "displacement of the right rail")
      .def_readonly("rail_wrench", &WheelsetResult::rail_wrench,
                    "of both rails on the wheelset, of normal pressure and friction")
      .def_readonly("speed", &WheelsetResult::speed,
                    "running speed along the track, forward positive [m/s]; 0 without creep forces")
      .def_readonly("rotation", &WheelsetResult::rotation,
                    "rotation about the axle, given or free, positive when it rolls forward [rad/s]; 0 without creep "
                    "forces")
      .def_property_readonly(
          "derivatives",
          [](const WheelsetResult& r)
          {
            return py::module::import("wheel_rail_contact.core.derivatives")
                .attr("Derivatives")(r.derivatives.forces, r.derivatives.solution);
          },
          "Derivatives of the forces, and of height and roll, with contact/derivatives")
      .def_property_readonly("patches", &patchesIn, "list of PatchResult, left side first")
      .def("__repr__", [](const WheelsetResult& result) { return textOf(result); });
}
}  // namespace wheel_rail_contact
