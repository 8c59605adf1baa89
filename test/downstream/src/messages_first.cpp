// SPDX-License-Identifier: BSD-3-Clause
// Message headers first, core headers second.
#include <wheel_rail_contact/RailDeflection.h>
#include <wheel_rail_contact/WheelsetContact.h>
#define COPY_INTO_MESSAGE messageBeforeCore

#include "core_first.cpp"
