// SPDX-License-Identifier: BSD-3-Clause
// Evaluates one wheelset with the parameters of config/default.yaml and a text. The argument is the folder of the
// package wheel_rail_contact: a program with ROS gives ros::package::getPath instead.
#include <iostream>
#include <string>

#include "wheel_rail_contact/config_file.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

int main(int argc, char** argv)
{
  using namespace wheel_rail_contact;

  const std::string folder = argc > 1 ? argv[1] : "";
  const ContactParameters parameters = readContactParameters(
      {{ParameterSource::file, default_parameters}, {ParameterSource::text, "contact: {method: hertz}"}},
      {".", [&](const std::string& package) { return package == "wheel_rail_contact" ? folder : ""; }});
  core::WheelsetContact contact(parameters.model);
  core::WheelsetState state;
  state.force_z = -98'100;
  const core::WheelsetResult& result = contact.evaluate(state);
  std::cout << "z = " << result.z << " m\n";
  return core::isUsable(result.status) && parameters.model.contact.method == core::NormalMethod::hertz ? 0 : 1;
}
