// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "half_space/loaded_wheel.h"

namespace wheel_rail_contact::core::half_space
{
/// The half-space models that the study compares.
enum class Model
{
  planar,  ///< one tangent plane for each grid
  curved,  ///< cells on the surface of the rail, influence of a plane
  turned   ///< the same, with the displacements projected onto turned normals
};

constexpr Model all_models[] = {Model::planar, Model::curved, Model::turned};

/// Name of a model in the tables.
const char* toString(Model model);

/// Result of a model for one contact of a wheel, on a fine grid.
struct ModelFigures
{
  double force = 0;         ///< normal force, as the sum over the columns along their normals [N]
  double max_pressure = 0;  ///< [Pa]
  double area = 0;          ///< [m²]
};

/// Solves a model for the load of a solved wheel. @return one entry for each grid of the wheel.
/// @throw std::runtime_error if the model has no solution
std::vector<ModelFigures> solveModel(const ContactModelConfig& config, const LoadedWheel& wheel, Model model);
}  // namespace wheel_rail_contact::core::half_space
