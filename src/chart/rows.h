// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>

#include "chart/comparison.h"

namespace wheel_rail_contact::core::chart
{
/// Writes the header line of the table.
void writeHeader(std::FILE* out);

/// Writes two rows, cold and warm, for every choice.
void writeRows(std::FILE* out, const Scene& scene, const Result& result);
}  // namespace wheel_rail_contact::core::chart
