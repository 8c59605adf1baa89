// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "examples/simulate_wheelset/contact_source.h"
#include "wheel_rail_contact/core/wheelset_contact.h"

namespace simulate_wheelset
{
/// The core library in this process.
class InProcessContact : public ContactSource
{
 public:
  /// @throw std::invalid_argument with the name of the parameter, its value and the broken rule.
  explicit InProcessContact(wheel_rail_contact::core::ContactModelConfig config);

  double rollingRadius() const override { return rolling_radius_; }
  ContactReply evaluate(const ContactRequest& request) override;

 private:
  const double rolling_radius_;  ///< [m]
  wheel_rail_contact::core::WheelsetContact contact_;
};

/// Reads parameters of the contact node for use in this process.
/// @param file  YAML file, applied over config/default.yaml; empty: no further file
/// @throw std::invalid_argument with the name, the value and the broken rule; also for parameters that expect another
/// load or another state than the example has.
wheel_rail_contact::core::ContactModelConfig readContact(const std::string& file);
}  // namespace simulate_wheelset
