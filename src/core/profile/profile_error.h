// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/text/text_file.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core
{
/// Calls a function that reads a file. A TextError becomes a ProfileError.
template <typename Read>
auto withProfileError(const Read& read)
{
  try
  {
    return read();
  }
  catch (const TextError& error)
  {
    throw ProfileError(error.file(), error.line(), error.reason());
  }
}
}  // namespace wheel_rail_contact::core
