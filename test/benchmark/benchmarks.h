// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../manchester_scene.h"
#include "../thread_time.h"
#include "core/balance/rail_support.h"
#include "core/balance/wheel_contact.h"
#include "core/normal/solvers/conjugate_gradients.h"

/// Parts of contact_benchmark. Wheels S1002 on rails UIC60, 100 kN per wheel, one core unless stated.
namespace wheel_rail_contact
{
/// Complete evaluations of a wheelset by tolerance, from a cold and from a warm start.
void registerWheelsets();
/// A wheelset that runs over a line with and without irregularities, compared with the ideal track.
void registerLines();
/// Each step of an evaluation.
void registerSteps();
/// contact_replay from bag to bag, compared with the evaluations alone.
void registerReplay();

inline std::string nameOf(const core::GridSize& size)
{
  return std::to_string(size.along) + "x" + std::to_string(size.across);
}

/// Endless series of states: lateral displacement from -6 mm to 6 mm and back in steps of 0.05 mm.
class Sweep
{
 public:
  const core::WheelsetState& next()
  {
    constexpr int steps = 240;
    constexpr double step = 0.05e-3;  // [m]
    const int place = count_++ % (2 * steps);
    state_.motion.speed = 20;
    state_.y = ((place < steps ? place : 2 * steps - place) - steps / 2) * step;
    return state_;
  }

 private:
  core::WheelsetState state_{0, 0, 0, 0, -200e3, 0, {}};
  int count_ = 0;
};

/// One wheel on one rail, for timing the steps of an evaluation.
struct OneWheel
{
  core::ContactModelConfig config = core::manchesterScene();
  core::PlacedRail rail = core::restingRail(config, core::Side::left);
  core::ConjugateGradients solver;
  core::WheelContact wheel{config, core::Side::left, rail, solver};

  OneWheel() { wheel.setRail(rail); }

  /// A wheel that is solved with the wheelset in the centre of the track, under 100 kN. Its gap has the height of the
  /// result.
  explicit OneWheel(const core::GridSize& size) : OneWheel()
  {
    constexpr int passes = 4;
    wheel.setGrid(0, size);
    pose.z = config.wheelset.rolling_radius.left;
    for (int pass = 0; pass < passes; ++pass)
    {
      wheel.solveLoad(pose, 100e3);
      pose.z = wheel.height();
    }
  }

  core::WheelsetPose pose{};  ///< of the last solution
};
}  // namespace wheel_rail_contact
