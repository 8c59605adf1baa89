// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue_interface.h>

namespace wheel_rail_contact
{
/// Callback queue interface that runs each callback immediately, in the thread that received the message.
///
/// For short callbacks that must receive every message: no message waits in roscpp, so roscpp drops none. The callbacks
/// of one subscription never run concurrently; those of different subscriptions may.
class ImmediateCallbacks : public ros::CallbackQueueInterface
{
 public:
  /// Runs the callback.
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t /*owner_id*/) override { callback->call(); }
  /// Does nothing, because no callback is stored.
  void removeByID(std::uint64_t /*owner_id*/) override {}
};
}  // namespace wheel_rail_contact
