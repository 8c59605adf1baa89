// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

#include "../manchester_scene.h"
#include "core/balance/wheel_contact.h"
#include "core/normal/solvers/conjugate_gradients.h"

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

inline std::string nameOf(const core::GridSize& size)
{
  return std::to_string(size.along) + "x" + std::to_string(size.across);
}

/// States to and fro about a place across the track in steps of 0.05 mm, again and again.
class ToAndFro
{
 public:
  /// @param y  middle [m]
  /// @param reach  steps from there to either end
  ToAndFro(double y, int reach) : y_(y), reach_(reach) {}

  const core::WheelsetState& next()
  {
    constexpr double step = 0.05e-3;  // [m]
    const int period = 4 * reach_;
    const int place = count_++ % period;
    const int k = place < 2 * reach_ ? place : period - place;
    state_.y = y_ + (k - reach_) * step;
    return state_;
  }

 private:
  double y_;
  int reach_;
  core::WheelsetState state_{0, 0, 0, 0, -200e3, 0, {}};
  int count_ = 0;
};

/// From y = -6 mm to 6 mm and back.
struct Sweep : ToAndFro
{
  Sweep() : ToAndFro(0, 120) {}
};

/// One wheel on one rail, to be stepped through by hand.
struct OneWheel
{
  core::ContactModelConfig config = core::manchesterScene();
  core::PlacedRail rail{config.rail_profile, config.track};
  core::ConjugateGradients solver;
  core::WheelContact wheel{config, solver};

  OneWheel() { wheel.setRail(rail); }

  /// Its normal problem in the middle of the track, under 100 kN.
  const core::NormalProblem& problemOn(const core::GridSize& size)
  {
    wheel.solveLoad(wheel.touch({0, 0, 0, 0}), 100e3, size);
    return wheel.problem();
  }
};
}  // namespace wheel_rail_contact
