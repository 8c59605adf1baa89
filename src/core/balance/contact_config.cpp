// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/config.h"

#include "core/option_check.h"

namespace wheel_rail_contact::core
{
void validate(const ContactConfig& contact)
{
  require(contact.tolerance > 0 && contact.tolerance < 1, "contact/tolerance", contact.tolerance,
          "must be between 0 and 1");
  const bool by_hand = contact.cells_along != 0 || contact.cells_across != 0;
  const auto fits = [](int cells) { return cells >= 4 && cells <= 256 && cells % 2 == 0; };
  require(!by_hand || fits(contact.cells_along), "contact/grid/along", contact.cells_along,
          "must be an even number from 4 to 256 (or 0 both along and across)");
  require(!by_hand || fits(contact.cells_across), "contact/grid/across", contact.cells_across,
          "must be an even number from 4 to 256 (or 0 both along and across)");
}
}  // namespace wheel_rail_contact::core
