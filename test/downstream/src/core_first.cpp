// SPDX-License-Identifier: BSD-3-Clause
// Core headers first, message headers second: both can be used in one file. messages_first.cpp includes them before.
#include <type_traits>

// clang-format off
#include "wheel_rail_contact/core/wheelset_contact.h"
#include <wheel_rail_contact/RailDeflection.h>
#include <wheel_rail_contact/WheelsetContact.h>
// clang-format on

#ifndef COPY_INTO_MESSAGE
#define COPY_INTO_MESSAGE messageAfterCore
#endif

// The message and the solver have the same name in different namespaces.
static_assert(!std::is_same<wheel_rail_contact::WheelsetContact, wheel_rail_contact::core::WheelsetContact>::value,
              "message and solver are different types");
static_assert(!std::is_same<wheel_rail_contact::RailDeflection, wheel_rail_contact::core::RailDeflection>::value,
              "message and core type are different types");

/// Copies a deflection of the core into its message.
wheel_rail_contact::RailDeflection COPY_INTO_MESSAGE(const wheel_rail_contact::core::RailResult& rail)
{
  wheel_rail_contact::RailDeflection message;
  message.lateral = rail.deflection.lateral;
  message.lateral_force = rail.lateral_force;
  return message;
}
