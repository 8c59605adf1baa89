// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

#include "../manchester_scene.h"
#include "wheel_rail_contact/balance/wheel_contact.h"
#include "wheel_rail_contact/normal/conjugate_gradients.h"

/// Parts of contact_benchmark. S1002 on UIC60, 100 kN a wheel, one core.
namespace wheel_rail_contact
{
/// The whole chain, by tolerance, cold and warm; jitter.
void registerWheelsets();
/// Each step of the chain.
void registerSteps();
/// How time grows with cells, patches and wheelsets.
void registerGrowth();
/// contact_replay from bag to bag against the evaluations alone.
void registerReplay();
/// Other solvers against conjugate gradients, and rails that bend against rails that do not, timed in turns.
void registerRatios();

/// How long some work takes [s].
template <typename Work>
double seconds(Work work)
{
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

inline std::string nameOf(const GridSize& size)
{
  return std::to_string(size.along) + "x" + std::to_string(size.across);
}

/// States of a sweep from y = -6 mm to 6 mm and back in steps of 0.05 mm, again and again.
class Sweep
{
 public:
  const WheelsetState& next()
  {
    constexpr int half_sweep = 120;   // steps from the middle to either end
    constexpr double step = 0.05e-3;  // [m]
    constexpr int period = 4 * half_sweep;
    const int place = count_++ % period;
    const int k = place < 2 * half_sweep ? place : period - place;
    state_.y = (k - half_sweep) * step;
    return state_;
  }

 private:
  WheelsetState state_{0, 0, 0, 0, -200e3, 0, {}};
  int count_ = 0;
};

/// One wheel on one rail, to be stepped through by hand.
struct OneWheel
{
  ContactModelConfig config = manchesterScene();
  PlacedRail rail{config.rail_profile, config.track};
  ConjugateGradients solver;
  WheelContact wheel{config, solver};

  OneWheel() { wheel.setRail(rail); }

  /// Its normal problem in the middle of the track, under 100 kN.
  const NormalProblem& problemOn(const GridSize& size)
  {
    wheel.solveLoad(wheel.touch({0, 0, 0, 0}), 100e3, size);
    return wheel.problem();
  }
};
}  // namespace wheel_rail_contact
