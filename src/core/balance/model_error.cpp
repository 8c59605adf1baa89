// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/model_error.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double size_error = 0.012;     ///< [-]
constexpr double turned_factor = 0.12;   ///< [1/rad²]
constexpr double parallel_factor = 0.5;  ///< normals that turn are taken to be parallel [1/rad²]
constexpr double largest_ratio = 0.55;   ///< of the contacts that were compared, approximately [rad]
constexpr double not_known = 1;          ///< [-]
}  // namespace

double modelError(double half_space_ratio, bool is_turned)
{
  if (!(half_space_ratio <= largest_ratio))
  {
    return not_known;
  }
  return size_error + (is_turned ? turned_factor : parallel_factor) * half_space_ratio * half_space_ratio;
}
}  // namespace wheel_rail_contact::core
