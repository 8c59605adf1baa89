// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/contact_source.h"

#include <stdexcept>
#include <utility>

namespace simulate_wheelset
{
const ContactReply& HeldContact::evaluate(const ContactRequest& request)
{
  ContactReply reply = source_.evaluate(request);
  if (reply.is_usable)
  {
    in_a_row_ = 0;
    last_ = std::move(reply);
    return last_;
  }
  ++in_a_row_;
  if (!last_.is_usable || in_a_row_ > most_)
  {
    throw std::runtime_error("no usable contact in " + std::to_string(in_a_row_) + " successive steps, at " +
                             std::to_string(1e-9 * static_cast<double>(request.time)) +
                             " s, y = " + std::to_string(1e3 * request.y) + " mm: " + reply.status);
  }
  ++held_;
  return last_;
}
}  // namespace simulate_wheelset
