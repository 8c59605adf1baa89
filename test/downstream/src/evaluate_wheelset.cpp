// SPDX-License-Identifier: BSD-3-Clause
// Example of a package that uses the numerical core without ROS: evaluates one wheelset in the centre of the track.
#include <iostream>
#include <memory>

#include "wheel_rail_contact/core/profile_reader.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

int main()
{
  using namespace wheel_rail_contact;

  core::ContactModelConfig config;
  config.wheel_profile = std::make_shared<const core::Profile>(core::s1002Wheel());
  config.rail_profile = std::make_shared<const core::Profile>(core::rail60E1());
  core::WheelsetContact contact(config);

  core::WheelsetState state;
  state.force_z = -98'100;
  const core::WheelsetResult& result = contact.evaluate(state);
  for (const core::PatchResult& patch : result.patches)
  {
    std::cout << (patch.side == core::Side::left ? "left " : "right ") << patch.max_pressure << " Pa on " << patch.area
              << " m^2\n";
  }
  const bool good = result.status == core::ContactStatus::ok && result.patches.size() == 2;
  return good ? 0 : 1;
}
