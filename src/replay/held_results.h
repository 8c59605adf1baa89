// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "replay/output_queue.h"
#include "ros/evaluation/hold_last.h"

namespace wheel_rail_contact
{
/// HoldLast for the results of one wheelset as bytes, in their order. A usable result is only deserialised if the next
/// one is not usable.
class HeldResults
{
 public:
  /// Keeps no reference to `config`.
  explicit HeldResults(const NodeConfig& config) : hold_(config) {}

  /// Adds the next result, which is not changed.
  /// @param data bytes of the message
  void follow(std::uint8_t status, const std::string& data);
  /// Adds the next result, and changes it if it is not usable.
  /// @param wheelset name in the table; the rows of the table are changed as well if there are any
  void complete(OutputItem& item, const std::string& wheelset);

 private:
  boost::shared_ptr<WheelsetContact> complete(const std::string& data);

  HoldLast hold_;
  std::string last_;  ///< bytes of the last usable result, if it was not passed to `hold_`
};
}  // namespace wheel_rail_contact
