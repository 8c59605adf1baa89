// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "examples/simulate_wheelset/contact_source.h"

namespace simulate_wheelset
{
/// Contact of each step, or the last usable one while there is none: without forces the wheelset would fall and drift
/// as after a lift-off, and nothing would show it.
class HeldContact
{
 public:
  /// @param most largest number of successive steps with the last usable contact
  HeldContact(ContactSource& source, int most) : source_(source), most_(most) {}

  /// Contact for the request.
  /// @throw std::runtime_error if more than `most` successive states, or the first one, have no usable result.
  const ContactReply& evaluate(const ContactRequest& request);

  /// Number of steps with a held contact.
  int held() const { return held_; }
  /// Whether the last contact is held.
  bool isHeld() const { return in_a_row_ > 0; }

 private:
  ContactSource& source_;
  const int most_;
  ContactReply last_;
  int held_ = 0, in_a_row_ = 0;
};
}  // namespace simulate_wheelset
