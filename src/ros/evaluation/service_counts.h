// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace wheel_rail_contact
{
/// Numbers of service requests of a node since its start.
struct ServiceCounts
{
  std::uint64_t evaluate = 0;           ///< results of ~evaluate
  std::uint64_t static_start = 0;       ///< results of ~static_start
  std::uint64_t unusable = 0;           ///< results of both whose status is not usable
  std::uint64_t lacking_neighbour = 0;  ///< results of both without the forces of a neighbour
  std::uint64_t failed = 0;             ///< requests without a result, because of an internal error
};
}  // namespace wheel_rail_contact
