// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What most tests use of GoogleTest, Eigen and the standard library. It is precompiled.
#include <gtest/gtest.h>

#include "standard_headers.h"
