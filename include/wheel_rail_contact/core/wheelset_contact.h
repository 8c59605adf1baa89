// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "wheel_rail_contact/core/config.h"
#include "wheel_rail_contact/core/wheelset_result.h"
#include "wheel_rail_contact/core/wheelset_state.h"

namespace wheel_rail_contact::core
{
/// The whole chain: pose and load -> placement -> search -> gap -> normal solution -> balance.
///
/// Keeps the last answer as a starting point; not thread-safe, one object per wheelset.
class WheelsetContact
{
 public:
  /// @throw std::invalid_argument naming the option, its value and the broken rule.
  explicit WheelsetContact(ContactModelConfig config);
  ~WheelsetContact();
  WheelsetContact(WheelsetContact&&) noexcept;
  WheelsetContact& operator=(WheelsetContact&&) noexcept;

  /// Answers one state. Never throws for bad states or numerical failure: the status tells.
  const WheelsetResult& evaluate(const WheelsetState& state);

  /// Forgets the last answer: the next evaluation starts cold.
  void reset();

  /// As given when it was made.
  const ContactModelConfig& config() const;

 private:
  class Chain;
  std::unique_ptr<Chain> chain_;
};
}  // namespace wheel_rail_contact::core
