// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/balance/patch_result.h"
#include "core/balance/rail_support.h"
#include "core/balance/wheel_contact.h"
#include "core/normal/estimate/islands.h"
#include "core/normal/solvers/conjugate_gradients.h"
#include "core/normal/solvers/seidel.h"
#include "core/option_check.h"
#include "core/stress/stress_search.h"
#include "core/track/gap.h"
#include "python/bindings.h"
#include "python/contact_model.h"

namespace py = pybind11;

namespace wheel_rail_contact
{
namespace
{
using namespace py::literals;
using core::SurfaceColumn;

constexpr double clear_height = 0.1;       ///< above the rolling radius: the wheel is above the rail there [m]
constexpr int most_passes = 20;            ///< solutions at heights that approach the final one
constexpr int most_products = 2000;        ///< of conjugate gradients
constexpr double plane_half_width = 0.05;  ///< of a plane that replaces the rail, more than any contact [m]

/// @param stop  residual, or change for seidel_printed, at which the method stops [-]
std::unique_ptr<core::NormalSolver> solverOf(const std::string& method, double stop)
{
  if (method == "conjugate_gradient")
  {
    return std::make_unique<core::ConjugateGradients>(core::ConjugateGradientsOptions{stop, most_products});
  }
  core::SeidelOptions options;
  if (method == "seidel")
  {
    options.residual = stop;
  }
  else if (method == "seidel_printed")
  {
    options.form = core::SeidelOptions::Form::printed;
    options.change = stop;
    options.load_error = std::max(options.load_error, stop);
  }
  else
  {
    throw std::invalid_argument("method = '" + method + "': must be conjugate_gradient, seidel or seidel_printed");
  }
  return std::make_unique<core::Seidel>(options);
}

/// A plane as a rail of its own. @param frame  y, z [m], cosine and sine of its angle about x
core::PlacedRail planeAt(const std::array<double, 4>& frame)
{
  const core::ProfileSection line{core::LineSection{-plane_half_width, 0, 1, 0}, 2 * plane_half_width};
  return {std::make_shared<const core::Profile>("plane", std::vector<core::ProfileSection>{line}),
          core::RailFrame{frame[0], frame[1], frame[2], frame[3]}};
}

/// The left wheel on its rail, alone, without yaw: the position, the roll of the wheelset and the load of the wheel are
/// given. Side axes, which are the track axes on the left.
class OneWheel
{
 public:
  OneWheel(const ContactModel& model, const core::GridSize& cells, const std::string& method, double stop)
      : config_(model.config().model),
        solver_(solverOf(method, stop)),
        rail_(restingRail(config_, core::Side::left)),
        contact_(config_, core::Side::left, rail_, *solver_)
  {
    contact_.setGrid(0, cells);
    contact_.setRail(rail_);
  }
  OneWheel(const OneWheel&) = delete;  // contact_ refers to other members
  OneWheel& operator=(const OneWheel&) = delete;

  /// Sets the rail with an inclination [rad] and a displacement of the reference point of its head.
  void setRail(double inclination, const core::RailDeflection& moved)
  {
    config_.track.rail_inclination.left = inclination;
    rail_ = restingRail(config_, core::Side::left).deflected(moved);
    contact_.setRail(rail_);
  }

  /// Solves the contact from a cold start. @return false if there is no solution
  /// @param remaining  allowed difference from the height of the gap, over the overlap [-]
  bool solve(double y, double roll, double load, double remaining)
  {
    contact_.forget();
    pose_ = {y, config_.wheelset.rolling_radius.left + clear_height, 0, roll};
    for (int pass = 0; pass < most_passes; ++pass)
    {
      if (contact_.solveLoad(pose_, load) != core::WheelStatus::solved)
      {
        return false;
      }
      pose_.z = contact_.height();
      if (std::abs(contact_.remaining()) < remaining * contact_.overlap())
      {
        return true;
      }
    }
    return false;
  }

  /// Lowers the wheel to first touch. @return parameter of the rail profile there [m]
  double touch(double y, double roll)
  {
    pose_ = {y, config_.wheelset.rolling_radius.left, 0, roll};
    core::refuseIf(!isUsable(contact_.touch(pose_)), "y = " + std::to_string(y) + " m: the wheel is beside the rail");
    pose_.z = contact_.height();
    return contact_.grids().touch().rail_u;
  }

  core::PlacedWheel wheel() const { return {*config_.wheel_profile.left, config_.wheelset, core::Side::left, pose_}; }
  const core::PlacedRail& rail() const { return rail_; }
  const core::WheelsetPose& pose() const { return pose_; }
  core::WheelContact& contact() { return contact_; }
  const core::WheelContact& contact() const { return contact_; }

 private:
  core::ContactModelConfig config_;
  std::unique_ptr<core::NormalSolver> solver_;
  core::PlacedRail rail_;
  core::WheelContact contact_;
  core::WheelsetPose pose_;
};

/// Pressures of the solution. Grids are symmetric about x = 0, and only cells with x > 0 are in the array.
py::list patches(const OneWheel& wheel)
{
  py::list found;
  for (const core::PatchPressure& patch : wheel.contact().solution().patches)
  {
    found.append(py::dict("max_pressure"_a = patch.max_pressure, "area"_a = patch.area, "pressure"_a = patch.pressure,
                          "dx"_a = patch.grid.dx, "dy"_a = patch.grid.dy, "cell_area"_a = patch.grid.cellArea()));
  }
  return found;
}

double heightPerRoll(OneWheel& wheel)
{
  const core::MotionMatrix stiffness = wheel.contact().stiffness();
  return -stiffness(core::wheel_up, core::wheel_roll) / stiffness(core::wheel_up, core::wheel_up);
}

/// Half the length of the pressure along the track, at the end of its cells [m].
double halfLength(const core::PatchPressure& patch, Eigen::Index first, Eigen::Index last)
{
  for (int row = patch.grid.rows() - 1; row >= 0; --row)
  {
    if ((patch.pressure.row(row).segment(first, last - first + 1) > 0).any())
    {
      return patch.grid.x(row) + 0.5 * patch.grid.dx;
    }
  }
  return 0;
}

/// The separate contacts of the solution.
py::list contacts(const OneWheel& wheel)
{
  const core::WheelContact& contact = wheel.contact();
  core::Islands islands;
  islands.find(contact.problem(), contact.solution());
  py::list found;
  for (const core::Island& island : islands.islands())
  {
    const std::vector<SurfaceColumn>& columns = contact.grids().columns()[island.patch];
    const SurfaceColumn& first = columns[static_cast<std::size_t>(island.first)];
    found.append(py::dict(
        "first_u"_a = first.rail_u, "last_u"_a = columns[static_cast<std::size_t>(island.last)].rail_u,
        "wheel_u"_a = first.wheel_u,
        "half_length"_a = halfLength(contact.solution().patches[island.patch], island.first, island.last),
        "half_space_ratio"_a = core::halfSpaceRatio(contact.grids().columns()[island.patch], island.first, island.last),
        "turned"_a = contact.problem().normals[island.patch].areTurned()));
  }
  return found;
}

/// Gap of the bodies at the present pose, on cells with x > 0 on the surface of the rail.
/// @param rail_u, wheel_u  parameters of both profiles at y = 0 of the cells; that of the wheel approximately [m]
/// @param count            rows along the track, columns across it
/// @param size             dx, dy of a cell [m]
/// @param y0               centre of the first column, along the arc of the rail [m]
/// @param plane            frame of a plane in place of the rail; y = 0 is its origin
py::dict gapOn(const OneWheel& wheel, double rail_u, double wheel_u, const std::array<int, 2>& count,
               const std::array<double, 2>& size, double y0, const std::optional<std::array<double, 4>>& plane)
{
  core::Grid grid;
  grid.symmetric = true;
  grid.nx = 2 * count[0];
  grid.ny = count[1];
  grid.dx = size[0];
  grid.dy = size[1];
  grid.y0 = y0;
  Eigen::ArrayXXd gap, slope;
  std::vector<SurfaceColumn> columns(static_cast<std::size_t>(count[1]));
  buildSurfaceGap(wheel.wheel(), plane ? planeAt(*plane) : wheel.rail(),
                  {0, plane ? plane_half_width : rail_u, wheel_u}, grid, gap, slope, columns);
  const auto each = [&columns](const auto& value)
  {
    Eigen::ArrayXd values(static_cast<Eigen::Index>(columns.size()));
    std::transform(columns.begin(), columns.end(), values.data(), value);
    return values;
  };
  return py::dict("gap"_a = gap, "y"_a = each([](const SurfaceColumn& c) { return c.y; }),
                  "z"_a = each([](const SurfaceColumn& c) { return c.z; }),
                  "cosine"_a = each([](const SurfaceColumn& c) { return c.cosine; }),
                  "sine"_a = each([](const SurfaceColumn& c) { return c.sine; }),
                  "rail_u"_a = each([](const SurfaceColumn& c) { return c.rail_u; }),
                  "wheel_u"_a = each([](const SurfaceColumn& c) { return c.wheel_u; }),
                  "per_up"_a = each([](const SurfaceColumn& c) { return c.perUp(); }),
                  "per_outward"_a = each([](const SurfaceColumn& c) { return c.perOutward(); }),
                  "has_bodies"_a = each([](const SurfaceColumn& c) { return c.has_bodies ? 1.0 : 0.0; }));
}

/// Points of the rail: y, z [m], and their derivatives with respect to the parameter u [m].
Eigen::ArrayX4d railAt(const OneWheel& wheel, const Eigen::ArrayXd& u)
{
  Eigen::ArrayX4d points(u.size(), 4);
  for (Eigen::Index i = 0; i < u.size(); ++i)
  {
    const core::PlanePoint point = wheel.rail().at(u[i]);
    points.row(i) << point.y, point.z, point.dy, point.dz;
  }
  return points;
}

/// y and z [m] of the wheel at its lowest circle points, at the present pose; NaN where there is none.
Eigen::ArrayX2d wheelAt(const OneWheel& wheel, const Eigen::ArrayXd& u)
{
  const core::PlacedWheel placed = wheel.wheel();
  Eigen::ArrayX2d points(u.size(), 2);
  for (Eigen::Index i = 0; i < u.size(); ++i)
  {
    core::PlanePoint point{};
    points.row(i).setConstant(std::numeric_limits<double>::quiet_NaN());
    if (placed.section(placed.profile().at(u[i]), 0, point))
    {
      points.row(i) << point.y, point.z;
    }
  }
  return points;
}
}  // namespace

void bindOneWheel(py::module& module)
{
  using Released = py::call_guard<py::gil_scoped_release>;
  py::class_<OneWheel>(module, "OneWheel")
      .def(py::init(
          [](const ContactModel& model, int along, int across, const std::string& method, double stop) {
            return std::make_unique<OneWheel>(model, core::GridSize{along, across}, method, stop);
          }))
      .def("set_rail",
           [](OneWheel& wheel, double inclination, double lateral, double vertical, double roll) {
             wheel.setRail(inclination, {lateral, vertical, roll});
           })
      .def("solve", &OneWheel::solve, Released())
      .def("touch", &OneWheel::touch)
      .def_property_readonly("patches", &patches)
      .def_property_readonly("iterations", [](const OneWheel& wheel) { return wheel.contact().solution().iterations; })
      .def_property_readonly("modulus", [](const OneWheel& wheel) { return wheel.contact().problem().modulus; })
      .def_property_readonly("height", [](const OneWheel& wheel) { return wheel.pose().z; })
      .def_property_readonly("vertical_force",
                             [](const OneWheel& wheel) { return wheel.contact().solved().forces()[core::wheel_up]; })
      .def_property_readonly("height_per_roll", &heightPerRoll)
      .def_property_readonly("contacts", &contacts)
      .def("gap_on", &gapOn, "rail_u"_a, "wheel_u"_a, "count"_a, "size"_a, "y0"_a, "plane"_a = py::none())
      .def("rail_at", &railAt)
      .def("wheel_at", &wheelAt)
      .def_property_readonly("rail_length", [](const OneWheel& wheel) { return wheel.rail().profile().length(); })
      .def_property_readonly("wheel_length", [](const OneWheel& wheel) { return wheel.wheel().profile().length(); })
      .def("rail_arc", [](const OneWheel& wheel, double from, double to)
           { return core::arcLength(wheel.rail().profile(), from, to); });
  module.def("model_error", &core::modelError);
  module.def("load_factor", &core::loadFactor);
  module.def("shakedown_limit", &core::shakedownLimit);
}
}  // namespace wheel_rail_contact
