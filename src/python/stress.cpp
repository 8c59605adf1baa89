// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <tuple>
#include <vector>

#include "config/text.h"
#include "python/bindings.h"
#include "wheel_rail_contact/core/normal_problem.h"
#include "wheel_rail_contact/core/wheelset_result.h"

namespace py = pybind11;

namespace wheel_rail_contact
{
namespace
{
using core::PatchGrid;
using core::Stress;

constexpr Eigen::Index components = std::tuple_size<decltype(core::StressLayer::components)>::value;

/// One stress per row: xx, yy, zz, yz, xz, xy [Pa]; or strains [-].
using StressTable = Eigen::Array<double, Eigen::Dynamic, components, Eigen::RowMajor>;
/// One point per row: x, y on the grid, depth [m].
using PointTable = Eigen::Array<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

PatchGrid gridOf(double x0, double y0, double dx, double dy, const Eigen::ArrayXXd& pressure)
{
  return {static_cast<int>(pressure.rows()), static_cast<int>(pressure.cols()), dx, dy, x0, y0};
}

Stress stressOf(const StressTable& table, Eigen::Index row)
{
  return {table(row, 0), table(row, 1), table(row, 2), table(row, 3), table(row, 4), table(row, 5)};
}

StressTable stressesAt(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, double poisson, const PointTable& points)
{
  StressTable table(points.rows(), components);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const Stress s = stressAt(grid, pressure, poisson, points.row(i).matrix().transpose());
    table.row(i) << s.xx, s.yy, s.zz, s.yz, s.xz, s.xy;
  }
  return table;
}

/// A number of each stress of a table.
template <typename Measure>
Eigen::ArrayXd measured(const StressTable& table, const Measure& measure)
{
  Eigen::ArrayXd numbers(table.rows());
  for (Eigen::Index i = 0; i < table.rows(); ++i)
  {
    numbers(i) = measure(stressOf(table, i));
  }
  return numbers;
}

Eigen::Array<double, Eigen::Dynamic, 3, Eigen::RowMajor> principalStressesOf(const StressTable& table)
{
  Eigen::Array<double, Eigen::Dynamic, 3, Eigen::RowMajor> numbers(table.rows(), 3);
  for (Eigen::Index i = 0; i < table.rows(); ++i)
  {
    const std::array<double, 3> principal = principalStresses(stressOf(table, i));
    numbers.row(i) << principal[0], principal[1], principal[2];
  }
  return numbers;
}

StressTable strainsOf(const StressTable& table, double young, double poisson)
{
  StressTable strains(table.rows(), components);
  for (Eigen::Index i = 0; i < table.rows(); ++i)
  {
    const core::Strain s = strainOf(stressOf(table, i), core::Material{young, poisson, 0});
    strains.row(i) << s.xx, s.yy, s.zz, s.yz, s.xz, s.xy;
  }
  return strains;
}

Eigen::ArrayXd depthsOf(const core::PatchStress& stress)
{
  Eigen::ArrayXd depths(static_cast<Eigen::Index>(stress.field.size()));
  for (std::size_t k = 0; k < stress.field.size(); ++k)
  {
    depths(static_cast<Eigen::Index>(k)) = stress.field[k].depth;
  }
  return depths;
}

/// Layers as an array (depths, components, nx, ny); without layers (0, components, 0, 0).
py::array_t<double> arrayOf(const std::vector<core::StressLayer>& layers)
{
  const Eigen::Index nx = layers.empty() ? 0 : layers.front().components.front().rows();
  const Eigen::Index ny = layers.empty() ? 0 : layers.front().components.front().cols();
  py::array_t<double> array(std::vector<Eigen::Index>{static_cast<Eigen::Index>(layers.size()), components, nx, ny});
  double* values = array.mutable_data();
  for (const core::StressLayer& layer : layers)
  {
    for (const Eigen::ArrayXXd& component : layer.components)
    {
      Eigen::Map<Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(values, nx, ny) = component;
      values += component.size();
    }
  }
  return array;
}

void bindClasses(py::module& module)
{
  py::class_<core::StressPeak> highest(module, "StressPeak", "A highest stress and its place.");
  visitPeak(propertiesOf(highest));
  highest.def("__repr__",
              [](const core::StressPeak& peak)
              {
                return formatted("<StressPeak: %.0f MPa at x %.3f mm, y %.3f mm, depth %.3f mm>", peak.value / 1e6,
                                 peak.x * 1e3, peak.y * 1e3, peak.depth * 1e3);
              });
  py::class_<core::PatchStress> beneath(
      module, "PatchStress",
      "Stress in a body beneath a patch, by the pressure on its grid, on a half-space. All numbers are 0 unless "
      "stress/depths is above 0.");
  visitStress(propertiesOf(beneath));
  beneath.def_readonly("von_mises", &core::PatchStress::von_mises, "StressPeak: highest von Mises stress")
      .def_readonly("shear", &core::PatchStress::shear,
                    "StressPeak: highest shear stress, half the difference of the largest and the smallest principal "
                    "stress")
      .def_property_readonly("depths", &depthsOf, "(n,) depths of the field [m]; empty without stress/field")
      .def_property_readonly(
          "field", [](const core::PatchStress& stress) { return arrayOf(stress.field); },
          "(n, 6, nx, ny) stress below the cells of the pressure [Pa], tension positive; "
          "components xx, yy, zz, yz, xz, xy in body axes: x, y of the grid, z into the body")
      .def("__repr__",
           [](const core::PatchStress& stress)
           {
             return formatted("<PatchStress: von Mises %.0f MPa at depth %.3f mm, load factor %.2f, limit %.2f>",
                              stress.von_mises.value / 1e6, stress.von_mises.depth * 1e3, stress.load_factor,
                              stress.shakedown_limit);
           });
}
}  // namespace

void bindStress(py::module& module)
{
  using Released = py::call_guard<py::gil_scoped_release>;
  bindClasses(module);
  module.attr("DEFAULT_POISSON") = core::Material{}.poisson;
  module.def(
      "stress_at",
      [](double x0, double y0, double dx, double dy, const Eigen::ArrayXXd& pressure, double poisson,
         const PointTable& points) { return stressesAt(gridOf(x0, y0, dx, dy, pressure), pressure, poisson, points); },
      Released());
  module.def("stress_layers",
             [](double x0, double y0, double dx, double dy, const Eigen::ArrayXXd& pressure, double poisson,
                const std::vector<double>& depths)
             {
               std::vector<core::StressLayer> layers;
               {
                 const py::gil_scoped_release released;
                 layers = stressLayers(gridOf(x0, y0, dx, dy, pressure), pressure, poisson, depths);
               }
               return arrayOf(layers);
             });
  module.def(
      "von_mises", [](const StressTable& table) { return measured(table, &core::vonMises); }, Released());
  module.def(
      "max_shear", [](const StressTable& table) { return measured(table, &core::maxShear); }, Released());
  module.def("principal_stresses", &principalStressesOf, Released());
  module.def("strain", &strainsOf, Released());
}
}  // namespace wheel_rail_contact
