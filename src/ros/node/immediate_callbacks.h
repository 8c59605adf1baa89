// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue_interface.h>

namespace wheel_rail_contact
{
/// A callback queue of roscpp that is none: it calls each callback at once, in the thread in which the message arrived.
/// For short callbacks that must see every message: nothing waits in roscpp, so roscpp has nothing to drop. Those of
/// one subscription never run side by side, those of several may.
class ImmediateCallbacks : public ros::CallbackQueueInterface
{
 public:
  /// Calls it.
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t /*owner_id*/) override { callback->call(); }
  /// There are none to remove.
  void removeByID(std::uint64_t /*owner_id*/) override {}
};
}  // namespace wheel_rail_contact
