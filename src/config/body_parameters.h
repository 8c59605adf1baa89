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
}  // namespace wheel_rail_contact
