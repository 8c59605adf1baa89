// SPDX-License-Identifier: BSD-3-Clause
// Evaluates one wheelset standing centred on the track, without ROS.
#include <iostream>
#include <memory>

#include "wheel_rail_contact/geometry/standard_profiles.h"
#include "wheel_rail_contact/wheelset_contact.h"

int main()
{
  using namespace wheel_rail_contact;

  ContactModelConfig config;
  config.wheel_profile = std::make_shared<const Profile>(s1002Wheel());
  config.rail_profile = std::make_shared<const Profile>(rail60E1());
  WheelsetContact contact(config);

  WheelsetState state;
  state.force_z = -98'100;
  const WheelsetResult& result = contact.evaluate(state);
  for (const PatchResult& patch : result.patches)
  {
    std::cout << (patch.side == Side::left ? "left " : "right ") << patch.max_pressure << " Pa on " << patch.area
              << " m^2\n";
  }
  const bool good = result.status == ContactStatus::ok && result.patches.size() == 2;
  return good ? 0 : 1;
}
