// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "examples/simulate_wheelset/contact_source.h"
#include "examples/simulate_wheelset/parameters.h"
#include "examples/simulate_wheelset/wheelset_dynamics.h"

namespace simulate_wheelset
{
/// Means over the whole waves of a run: between the first and the last upward zero crossing of the lateral
/// displacement.
class Waves
{
 public:
  /// Adds a step.
  /// @param distance place along the track [m]
  /// @param y        lateral displacement [m]
  void add(double distance, double y, const ContactReply& contact);

  /// Number of whole waves.
  int count() const { return count_; }
  /// Mean wavelength [m]; 0 without a whole wave.
  double wavelength() const;
  /// Largest lateral displacement of all steps, to either side [m].
  double largestY() const { return largest_y_; }
  /// Mean force that resists the running, backward positive [N]; 0 without a whole wave.
  double drag() const;
  /// Mean power of the friction [W]; 0 without a whole wave.
  double frictionPower() const;
  /// All of this in words.
  /// @param speed running speed [m/s]
  std::string text(double speed) const;

 private:
  /// Sums over steps.
  struct Sums
  {
    int steps = 0;
    double drag = 0, friction_power = 0;
  };

  int count_ = 0;
  double largest_y_ = 0;
  std::optional<double> first_crossing_;  ///< [m]
  double last_crossing_ = 0;              ///< [m]
  Sums whole_, begun_;                    ///< of the whole waves, and from the first crossing on
  bool has_last_ = false;
  double last_distance_ = 0, last_y_ = 0;
};

/// Table of a run (CSV): one row per step, SI units. The first line has the names and units of the columns.
class MotionTable
{
 public:
  /// @throw std::runtime_error if the file cannot be written: also from add() and close().
  explicit MotionTable(const std::string& file);

  /// Adds a step: the request at its start, and the contact in the step.
  void add(const ContactRequest& request, const ContactReply& contact, bool is_held);
  /// Writes what is buffered.
  void close();

 private:
  void check();

  std::string file_;
  std::ofstream stream_;
};

/// Wall times of the steps of a run.
class StepTimes
{
 public:
  /// Adds a step [s].
  void add(double seconds) { seconds_.push_back(seconds); }
  /// Steps per second, median, 95 % and longest step in words; empty without a step.
  std::string text() const;

 private:
  std::vector<double> seconds_;
};

/// What happened in a run.
struct RunSummary
{
  int steps = 0;      ///< number of steps
  int held = 0;       ///< steps with the contact of an earlier one, because there was no usable result
  int saturated = 0;  ///< steps in which the friction of a contact was at its limit
  Waves waves;        ///< of the last third of the run
  StepTimes times;    ///< wall times
};

/// Runs the loop: send pose, velocities and load, receive the contact, advance the motion by one step.
/// @param table rows of the steps; null: none
/// @throw std::runtime_error if the contact calculation cannot be reached, has no usable result in too many successive
/// steps (HeldContact), or the motion does not converge.
RunSummary runClosedLoop(const Parameters& parameters, ContactSource& source, MotionTable* table);
}  // namespace simulate_wheelset
