// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core
{
/// Change of a wheel's contact from one result to the next. For consecutive lateral steps, the next result is
/// extrapolated from the last two.
class ResultTrend
{
 public:
  /// Discards all results.
  void reset() { *this = ResultTrend(); }

  /// Prepares a state that lies `moved` to the side of the last result [m].
  void begin(double moved)
  {
    const bool alike = last_.moved != 0 && std::abs(moved) <= longest_step * std::abs(last_.moved);
    share_ = alike ? moved / last_.moved : 0;
    moved_ = moved;
  }

  /// Expected factor of the penetration [-].
  double penetration() const { return std::exp(std::clamp(share_ * last_.growth, -most_growth, most_growth)); }
  /// Expected turn of the plane relative to its overlap interval [rad].
  double turn() const { return std::clamp(share_ * last_.turn, -most_turn, most_turn); }

  /// Records a result.
  /// @param penetration  penetration at unit load, with its exponent 2/3 [m/N^(2/3)]
  /// @param angle        angle of the plane relative to its overlap interval [rad]
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
    double moved = 0;   ///< lateral step [m]; 0: unknown
    double growth = 0;  ///< logarithm of the ratio of the penetrations [-]
    double turn = 0;    ///< [rad]
  };

  static constexpr double longest_step = 1.5;  ///< largest ratio to the previous step [-]
  static constexpr double most_growth = 0.1;
  static constexpr double most_turn = 0.02;  ///< [rad]

  Step last_;
  double share_ = 0;        ///< expected share of the changes of the last step [-]
  double moved_ = 0;        ///< step to the present state [m]
  double penetration_ = 0;  ///< of the last result [m/N^(2/3)]; 0: none
  double angle_ = 0;        ///< of the last result [rad]
};
}  // namespace wheel_rail_contact::core
