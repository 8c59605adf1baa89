// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fstream>
#include <string>

#include "examples/simulate_wheelset/contact_source.h"
#include "examples/simulate_wheelset/wheelset_forces.h"

namespace simulate_wheelset
{
/// Table of a run (CSV): one row per step, SI units. The first line has the names and units of the columns.
class MotionTable
{
 public:
  /// @throw std::runtime_error if the file cannot be written: also from add() and close().
  explicit MotionTable(const std::string& file);

  /// Adds a step: the motion in which the contact was evaluated, and the forces in the step.
  void add(const ContactRequest& request, const Motion& motion, const ContactReply& contact, const RailForces& forces,
           bool is_held);
  /// Writes what is buffered.
  void close();

 private:
  void check();

  std::string file_;
  std::ofstream stream_;
};
}  // namespace simulate_wheelset
