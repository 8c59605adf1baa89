// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "config/profile_parameters.h"
#include "core/profile/curve/measures.h"
#include "python/bindings.h"
#include "python/read_profile.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace py = pybind11;

namespace wheel_rail_contact
{
namespace
{
using core::Profile;
using core::ProfilePlace;

/// One row per point or parameter.
using ProfileTable = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Profile, the used points of its file (y, z), and the noise for which it was smoothed [m].
using Described = std::tuple<ReadProfile, ProfileTable, double>;

Described described(core::DescribedProfile&& read)
{
  ProfileTable points(static_cast<Eigen::Index>(read.points.size()), 2);
  for (std::size_t i = 0; i < read.points.size(); ++i)
  {
    points.row(static_cast<Eigen::Index>(i)) << read.points[i].y, read.points[i].z;
  }
  return {{std::make_shared<const Profile>(std::move(read.profile)), read.report.text}, points, read.report.smoothing};
}

/// A standard profile or the profile of a file; or the reason why there is none, without the name of the file.
/// @throw std::invalid_argument if an option is out of range.
py::object describeProfile(const std::string& name, const std::string& kind, const std::string& options)
{
  const core::ProfileReading reading = readProfileOptions(parameterTree(YAML::Load(options)));
  const bool is_file = std::filesystem::exists(name);
  try
  {
    return py::cast(described(core::describedProfile(name, kindOf(kind), reading)));
  }
  catch (const core::FileError& error)
  {
    return py::cast((error.line() > 0 ? "line " + std::to_string(error.line()) + ": " : "") + error.reason());
  }
  catch (const std::invalid_argument& error)
  {
    if (is_file)
    {
      throw;
    }
    return py::cast(std::string(error.what()));
  }
}

/// Point and derivatives at each parameter: y, z, dy, dz, ddy, ddz.
ProfileTable curveOf(const ReadProfile& read, const Eigen::ArrayXd& u)
{
  ProfileTable table(u.size(), 6);
  for (Eigen::Index i = 0; i < u.size(); ++i)
  {
    const core::CurvePoint p = read.profile->at(u(i));
    table.row(i) << p.y, p.z, p.dy, p.dz, p.ddy, p.ddz;
  }
  return table;
}

/// Standard deviations across the curve [m] and of the curvature [1/m] at each parameter, and 1 where points are
/// missing.
ProfileTable errorsOf(const ReadProfile& read, const Eigen::ArrayXd& u)
{
  ProfileTable table(u.size(), 3);
  for (Eigen::Index i = 0; i < u.size(); ++i)
  {
    const core::ShapeError& error = read.profile->errorAt(u(i));
    table.row(i) << error.position, error.curvature, error.missing ? 1 : 0;
  }
  return table;
}

py::object placeOf(const std::optional<ProfilePlace>& place)
{
  return place ? py::object(py::make_tuple(place->y, place->z)) : py::none();
}

py::dict wheelMeasuresOf(const ReadProfile& read)
{
  using py::literals::operator""_a;
  const core::WheelMeasures wheel = core::wheelMeasures(*read.profile);
  return py::dict("running_circle"_a = placeOf(wheel.running_circle), "flange_tip"_a = placeOf(wheel.flange_tip),
                  "front"_a = placeOf(wheel.front), "flange_back"_a = placeOf(wheel.flange_back),
                  "upper"_a = placeOf(wheel.upper), "flange_height"_a = wheel.flange_height,
                  "flange_thickness"_a = wheel.flange_thickness, "flange_gradient"_a = wheel.flange_gradient);
}

py::dict railMeasuresOf(const ReadProfile& read)
{
  using py::literals::operator""_a;
  const core::RailMeasures rail = core::railMeasures(*read.profile);
  return py::dict("top"_a = placeOf(rail.top), "gauge_point"_a = placeOf(rail.gauge_point),
                  "gauge_side"_a = placeOf(rail.gauge_side), "field_side"_a = placeOf(rail.field_side),
                  "head_width"_a = rail.head_width, "gauge_side_lean"_a = rail.gauge_side_lean,
                  "field_side_lean"_a = rail.field_side_lean, "inclination"_a = rail.inclination());
}
}  // namespace

void bindProfileCheck(py::module& module)
{
  module.def("describe_profile", &describeProfile);
  module.def("standard_profile_names",
             [](const std::string& kind) { return core::standardProfileNames(kindOf(kind)); });
  module.def("profile_curve", &curveOf);
  module.def("profile_errors", &errorsOf);
  module.def("profile_boundaries", [](const ReadProfile& read) { return read.profile->discontinuities(); });
  module.def("running_surface",
             [](const ReadProfile& read, const std::string& kind)
             {
               const core::ParameterRange range = core::runningSurface(*read.profile, kindOf(kind));
               return py::make_tuple(range.begin, range.end);
             });
  module.def("wheel_measures", &wheelMeasuresOf);
  module.def("rail_measures", &railMeasuresOf);
}
}  // namespace wheel_rail_contact
