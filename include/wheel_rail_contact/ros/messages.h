// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Two messages are called like types of the numerical core. Their C++ types get other names here, so that one source
// file can use both; nothing else of the messages changes.
#define WheelsetContact WheelsetContactMsg
#define RailDeflection RailDeflectionMsg
#include <wheel_rail_contact/RailDeflection.h>
#include <wheel_rail_contact/WheelsetContact.h>
#undef RailDeflection
#undef WheelsetContact
