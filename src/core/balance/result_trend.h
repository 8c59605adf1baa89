// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core
{
/// How a wheel's contact has changed from one answer to the next, for steps to the side that follow one another: the
/// next answer is then close to where the last two point.
class ResultTrend
{
 public:
  /// Forgets all answers.
  void reset() { *this = ResultTrend(); }

  /// Sets out for a state `moved` beside the last answer [m].
  void begin(double moved)
  {
    const bool alike = last_.moved != 0 && std::abs(moved) <= longest_step * std::abs(last_.moved);
    share_ = alike ? moved / last_.moved : 0;
    moved_ = moved;
  }

  /// Factor of the descent to be expected [-].
  double penetration() const { return std::exp(std::clamp(share_ * last_.growth, -most_growth, most_growth)); }
  /// Turn of the plane against its stretch to be expected [rad].
  double turn() const { return std::clamp(share_ * last_.turn, -most_turn, most_turn); }

  /// Takes in an answer: its descent at unit load [m], and the plane's angle against its stretch [rad].
  void finish(double penetration, double angle)
  {
    const bool both = penetration_ > 0;
    last_ = both ? Step{moved_, std::log(penetration / penetration_), angle - angle_} : Step();
    penetration_ = penetration;
    angle_ = angle;
  }

 private:
  struct Step
  {
    double moved = 0;   ///< to the side [m]; 0: not known
    double growth = 0;  ///< logarithm of the descents' ratio [-]
    double turn = 0;    ///< [rad]
  };

  static constexpr double longest_step = 1.5;  ///< over the step before [-]
  static constexpr double most_growth = 0.1;
  static constexpr double most_turn = 0.02;  ///< [rad]

  Step last_;
  double share_ = 0;        ///< of the last step's changes to be expected in this one [-]
  double moved_ = 0;        ///< step to the present state [m]
  double penetration_ = 0;  ///< of the last answer; 0: none [m]
  double angle_ = 0;        ///< likewise [rad]
};
}  // namespace wheel_rail_contact::core
