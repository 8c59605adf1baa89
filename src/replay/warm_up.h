// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

#include "replay/replay_options.h"
#include "ros/evaluation/contact_input.h"

namespace wheel_rail_contact
{
/// Recording time [ns] at which reading must begin. The results in `options.span` are then those of a replay of the
/// whole bag: ReplaySource::isWarmedUp() is true at the beginning of the span.
///
/// Returns 0, the beginning of the bag, where a part of the bag is not sufficient to verify this:
/// - with transforms, because their buffer depends on all earlier messages;
/// - with a slop, because an earlier message may change which messages are matched;
/// - without an index.
/// @throw BagError if the bag cannot be read.
std::uint64_t warmUpStart(const ReplayOptions& options, const NodeConfig& config);

/// The last inputs of one wheelset before the output begins: the last slice (ResetRule), and as many before it as are
/// required for a number of results. The oldest input is the first of its slice.
class WarmUpInputs
{
 public:
  /// @param results number of results of which the inputs are kept, if there are as many, >= 0
  explicit WarmUpInputs(std::size_t results) : results_(results) {}

  /// Adds the next input. Drops the oldest slices that are not required.
  void add(PreparedInput input)
  {
    if (input.resets)
    {
      dropSlices();
    }
    inputs_.push_back(std::move(input));
  }

  /// The inputs, in their order.
  std::deque<PreparedInput>& inputs() { return inputs_; }

 private:
  void dropSlices()
  {
    std::size_t second = 1;  // first input of the second slice
    while (inputs_.size() >= results_ + second && second < inputs_.size())
    {
      if (inputs_[second].resets)
      {
        inputs_.erase(inputs_.begin(), inputs_.begin() + static_cast<std::ptrdiff_t>(second));
        second = 0;
      }
      ++second;
    }
  }

  std::size_t results_;
  std::deque<PreparedInput> inputs_;
};
}  // namespace wheel_rail_contact
