// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "config/body_parameters.h"
#include "config/compliance_table_file.h"
#include "config/model_files.h"
#include "config/text.h"
#include "core/option_check.h"
#include "core/profile/curve/measures.h"
#include "core/text/text_table.h"
#include "core/text/words.h"
#include "python/bindings.h"
#include "python/contact_model.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace py = pybind11;

namespace wheel_rail_contact
{
namespace
{
/// Kind by its name: "wheel", "rail" or "rail_section".
/// @throw std::invalid_argument for another name.
core::ProfileKind kindOf(const std::string& name)
{
  using core::ProfileKind;
  const std::vector<std::pair<const char*, ProfileKind>> kinds{
      {"wheel", ProfileKind::wheel}, {"rail", ProfileKind::rail}, {"rail_section", ProfileKind::rail_section}};
  for (const auto& [known, kind] : kinds)
  {
    if (name == known)
    {
      return kind;
    }
  }
  throw std::invalid_argument("kind = '" + name + "': must be 'wheel', 'rail' or 'rail_section'");
}

ReadProfile readNamedProfile(const std::string& name, const std::string& kind, const std::string& options)
{
  const core::ProfileReading reading = readProfileOptions(parameterTree(YAML::Load(options)));
  core::DescribedProfile described = openProfile(name, kindOf(kind), reading, fileSearch());
  return {std::make_shared<const core::Profile>(std::move(described.profile)), described.report.text};
}

core::CurvePoint pointAt(const core::Profile& profile, double u)
{
  if (!(u >= 0 && u <= profile.length()))
  {
    throw std::invalid_argument("u = " + std::to_string(u) + ": must be within the profile, 0 to " +
                                std::to_string(profile.length()) + " m");
  }
  return profile.at(u);
}

/// A quantity of a profile at each number of an array of any shape.
template <typename Quantity>
py::object along(const ReadProfile& read, const py::array_t<double>& u, const Quantity& quantity)
{
  return py::vectorize([&](double each) { return quantity(pointAt(*read.profile, each)); })(u);
}

py::tuple at(const ReadProfile& read, const py::array_t<double>& u)
{
  return py::make_tuple(along(read, u, [](const core::CurvePoint& point) { return point.y; }),
                        along(read, u, [](const core::CurvePoint& point) { return point.z; }));
}

void bindProfile(py::module& module)
{
  py::class_<ReadProfile>(
      module, "Profile",
      "Profile of a wheel or a rail, in the profile frame: y to the field side, z up, the origin on "
      "the running circle or the crown.")
      .def_property_readonly(
          "name", [](const ReadProfile& read) { return read.profile->name(); }, "of the standard profile or the file")
      .def_readonly("report", &ReadProfile::report, "what was understood of the file, in one line")
      .def_property_readonly(
          "length", [](const ReadProfile& read) { return read.profile->length(); },
          "largest value of the parameter u of the curve [m]; the smallest is 0")
      .def_property_readonly(
          "parts",
          [](const ReadProfile& read)
          {
            std::vector<std::pair<double, double>> parts;
            for (const core::ParameterRange& part : read.profile->parts())
            {
              parts.emplace_back(part.begin, part.end);
            }
            return parts;
          },
          "list of (first u, last u) of the separate parts [m]")
      .def("at", &at, py::arg("u"), "y and z [m] at the parameter u [m], as arrays of its shape")
      .def(
          "slope",
          [](const ReadProfile& read, const py::array_t<double>& u)
          { return along(read, u, [](const core::CurvePoint& point) { return point.slope(); }); },
          py::arg("u"), "dz/dy [-] at the parameter u [m]")
      .def(
          "curvature",
          [](const ReadProfile& read, const py::array_t<double>& u)
          { return along(read, u, [](const core::CurvePoint& point) { return point.curvature(); }); },
          py::arg("u"), "curvature at the parameter u [m], positive where the curve bends up for growing y [1/m]")
      .def("__repr__", [](const ReadProfile& read) { return "<Profile " + read.profile->name() + ">"; });
  module.def("read_profile", &readNamedProfile);
}

void bindTable(py::module& module)
{
  using Moved = core::RailDeflection;
  py::class_<Moved>(module, "RailDisplacement", "Displacement of a rail head at its reference point.")
      .def_readonly("lateral", &Moved::lateral, "outward positive [m]")
      .def_readonly("vertical", &Moved::vertical, "up positive [m]")
      .def_readonly("roll", &Moved::roll, "rotation, positive if the crown moves outward [rad]")
      .def("__repr__",
           [](const Moved& rail)
           {
             return formatted("<RailDisplacement: lateral %.4f mm, vertical %.4f mm, roll %.4f mrad>",
                              rail.lateral * 1e3, rail.vertical * 1e3, rail.roll * 1e3);
           });
  using Table = ComplianceTableFile;
  py::class_<Table>(module, "ComplianceTable", "Compliance of a rail head; see doc/rail_bending.md.")
      .def_readonly("name", &Table::name, "of the rail and its supports")
      .def_readonly("linear_range", &Table::linear_range, "largest |Y|/Q for which the table is valid [-]")
      .def_property_readonly(
          "lateral_lateral", [](const Table& file) { return file.table.lateral_lateral; },
          "lateral displacement per lateral force [m/N]")
      .def_property_readonly(
          "lateral_roll", [](const Table& file) { return file.table.lateral_roll; }, "roll per lateral force [rad/N]")
      .def_property_readonly(
          "roll_roll", [](const Table& file) { return file.table.roll_roll; }, "roll per moment [rad/(N m)]")
      .def_property_readonly(
          "vertical_vertical", [](const Table& file) { return file.table.vertical_vertical; },
          "downward displacement per vertical force [m/N]")
      .def(
          "displacement",
          [](const Table& file, double lateral_force, double vertical_force, double moment, double inclination)
          {
            core::refuseIf(!std::isfinite(lateral_force + vertical_force + moment + inclination),
                           "displacement: forces, moment and inclination must be finite");
            return core::deflectionInTrack(file.table, {lateral_force, vertical_force, moment}, inclination);
          },
          py::arg("lateral_force") = 0.0, py::arg("vertical_force") = 0.0, py::arg("moment") = 0.0,
          py::arg("inclination") = 0.0,
          "RailDisplacement by a lateral force (outward positive) [N], a vertical force (down positive) [N] and their "
          "moment about the reference point (outward roll positive) [N m], of a rail with an inclination [rad]")
      .def("__repr__", [](const Table& file) { return "<ComplianceTable " + file.name + ">"; });
  module.def("read_compliance_table",
             [](const std::string& file) { return readComplianceTable(fileSearch().find(file)); });
}

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
  return {{std::make_shared<const core::Profile>(std::move(read.profile)), read.report.text},
          points,
          read.report.smoothing};
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

py::object placeOf(const std::optional<core::ProfilePlace>& place)
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

/// Adds what the command check_profile requires.
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

/// Table of any cells, with its file.
struct CellFile
{
  core::TextFile file;
  core::CellTable table;

  explicit CellFile(const std::string& path) : file(path, std::size_t{1} << 30U, 100000), table(file, false) {}

  core::TableRow next()
  {
    core::TableRow row;
    return table.next(row) ? row : throw py::stop_iteration();
  }
};

/// Adds the tables that the command contact_states reads.
void bindCells(py::module& module)
{
  py::class_<core::TableRow>(module, "TableRow")
      .def_readonly("line", &core::TableRow::line)
      .def_readonly("cells", &core::TableRow::cells);
  const auto pair_of = [](const core::TableTitle& title) { return std::make_pair(title.name, title.unit); };
  module.def("title_of", [=](const std::string& title) { return pair_of(core::titleOf(title, false)); });
  module.def("unit_named",
             [](const std::string& text)
             {
               const core::NamedUnit* unit = core::unitNamed(text);
               return unit != nullptr ? unit->name : "";
             });
  py::dict kinds;
  for (const core::UnitKind& kind : core::unit_kinds)
  {
    for (const core::NamedUnit& unit : kind.units)
    {
      kinds.attr("setdefault")(kind.name, py::dict())[unit.name] = unit.value;
    }
  }
  module.attr("table_units") = kinds;
  py::class_<CellFile>(module, "CellTable")
      .def(py::init<const std::string&>())
      .def_property_readonly("path", [](const CellFile& cells) { return cells.file.path(); })
      .def_property_readonly("head", [](const CellFile& cells) { return cells.table.head(); })
      .def_property_readonly("comments", [](const CellFile& cells) { return cells.table.comments(); })
      .def_property_readonly("titles",
                             [=](const CellFile& cells)
                             {
                               const auto& head = cells.table.head();
                               cells.file.refuseIf(head.empty(), 0, "has no titles");
                               const auto found = core::titlesWithUnits(cells.file, head, head.size() - 1, false);
                               std::vector<std::pair<std::string, std::string>> titles;
                               std::transform(found.titles.begin(), found.titles.end(), std::back_inserter(titles),
                                              pair_of);
                               return std::make_pair(titles, found.row);
                             })
      .def("rewind", [](CellFile& cells) { cells.table.rewind(); })
      .def("__iter__", [](const py::object& cells) { return cells; })
      .def("__next__", &CellFile::next);
  module.def("is_missing", &core::isMissing);
  module.def("plain_number",
             [](const std::string& cell)
             {
               const std::string number = core::withPoint(cell);
               return core::parseNumber(number) ? std::optional(number) : std::nullopt;
             });
}
}  // namespace

void bindProfiles(py::module& module)
{
  bindProfile(module);
  bindTable(module);
  bindProfileCheck(module);
  bindCells(module);
}
}  // namespace wheel_rail_contact
