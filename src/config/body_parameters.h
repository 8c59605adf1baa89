// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "config/model_files.h"
#include "config/parameter_reader.h"

namespace wheel_rail_contact
{
/// Reads the parameters of both wheels: those for both, then those of each side.
void readWheels(ParameterReader& reader, core::ContactModelConfig& model, ModelFiles& files);
/// Reads the parameters of both rails: the same.
void readRails(ParameterReader& reader, core::ContactModelConfig& model, ModelFiles& files);
/// @throw std::invalid_argument unless each wheel and rail has a profile.
void requireProfiles(const ParameterReader& reader, const ModelFiles& files);

/// Reads the options of profile files that are members of a group:
///
///   unit                      m, cm, mm, um or in
///   y                         outward or inward
///   z                         up or down
///   origin                    running_circle, flange_back, crown, gauge_corner or foot
///   shift/{y, z}              [m]
///   rotate                    [rad]
///   mirror                    true or false
///   smoothing                 [um], 0 or from 0.01 to 100
/// @param prefix  before the names, with "/"; empty in a group of its own
/// @param reading  options that are not given stay unchanged
void readProfileOptions(ParameterReader& reader, const std::string& prefix, core::ProfileReading& reading);

/// Options of a profile file in a group of their own. It may contain the dimensions of the vehicle, too:
///
///   tape_circle               [m], above 0
///   scale                     of a model, above 0, at most 1
/// @throw std::invalid_argument with the name, the value and the violated rule; for an unknown name.
core::ProfileReading readProfileOptions(const ParameterTree& group);

/// True if one of the options is given.
bool hasProfileOptions(const ParameterReader& reader, const std::string& prefix);
}  // namespace wheel_rail_contact
