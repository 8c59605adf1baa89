// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "paper/printed_figures.h"
#include "wheel_rail_contact/core/config.h"
#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core::paper
{
/// One setting of the wheel looked at, and what it gives.
struct ScanRow
{
  std::string part;            ///< what the scan was for, see the functions below
  std::string rail;            ///< name of its profile
  double inclination;                 ///< inclination of the unturned rail towards the track's centre [rad]
  double load;                 ///< vertical, of each wheel [N]
  double y;                    ///< wheelset's position, towards the flange [m]
  double roll;                 ///< wheelset's, this wheel up positive [rad]
  RailDeflection crown;        ///< displacement of this rail's crown
  RailDeflection other_crown;  ///< of the other rail's; counts only in the part "rails"
  Figures without;  ///< of this wheel on the undeflected rail at the same position; zero where no pair is looked for
  Figures figures;  ///< of this wheel; zero where there is no solution

  /// Relative deviation of the pair (without, figures) from the printed one [-].
  double pairDeviation() const
  {
    return std::max(deviation(without, printed_without_bending), deviation(figures, printed_with_bending));
  }
};

class OneWheel;

/// Equidistant values, both ends included.
struct Range
{
  double first, last;
  int steps;  ///< >= 1

  std::vector<double> values() const
  {
    std::vector<double> all;
    for (int i = 0; i <= steps; ++i)
    {
      all.push_back(first + (last - first) * i / steps);
    }
    return all;
  }
};

/// Names of the profiles that the paper's "UIC60" may mean.
inline const std::vector<std::string> studied_rails{"UIC60_manchester", "60E1"};

/// How widely and finely the scans go. The values that stand here are those of `paper_study`.
struct ScanRanges
{
  std::vector<std::string> rails = studied_rails;
  std::vector<double> inclinations{0, 1.0 / 40, 1.0 / 20};                                                         ///< [rad]
  std::vector<double> loads{100e3, 50e3};                                                                   ///< [N]
  Range position{-6e-3, 6.4e-3, 124};                                                                       ///< [m]
  Range position_around_start{-0.06e-3, 0.06e-3, 6};                                                        ///< [m]
  Range pure_shift{-5e-3, 4e-3, 180};                                                                       ///< [m]
  std::vector<double> shift{-1e-3, -0.5e-3, -printed_displacement, 0, printed_displacement, 0.5e-3, 1e-3};  ///< [m]
  Range turn{-20e-3, 20e-3, 40};                                                                            ///< [rad]
  Range free_position{-6e-3, 5.2e-3, 28};                                                                   ///< [m]
  Range free_turn{-26e-3, 26e-3, 52};                                                                       ///< [rad]
  Range roll{-1e-3, 1e-3, 20};                                                                              ///< [rad]
  Range free_inclination{14e-3, 50e-3, 36};                                                                        ///< [rad]
};

/// Runs the scans. All solutions on one grid of 32 × 64 cells, from cold.
class Scan
{
 public:
  /// Track, wheelset and materials are taken from `config`; its profile of the rail and its inclination are replaced.
  /// `solver` must outlive it.
  Scan(ContactModelConfig config, NormalSolver& solver, ScanRanges ranges);

  /// Part "start": where the figures without bending could come from: rails, inclinations, loads, positions.
  std::vector<ScanRow> start() const;
  /// Part "shift": from a start, the rail displaced across the track only.
  std::vector<ScanRow> shift(const ScanRow& start) const;
  /// Part "pair": at positions around a start, the rail displaced and turned about its crown.
  std::vector<ScanRow> pair(const ScanRow& start) const;
  /// Part "inclination": any inclination and position whose figures without bending are near the printed ones; the rail
  /// displaced outward as printed, and turned. Refined around the best pairs with an inward and an outward turn.
  std::vector<ScanRow> inclination(const std::string& rail) const;
  /// Part "alone": the figures with bending by themselves: any position, any inclination of the rail.
  std::vector<ScanRow> alone(const std::string& rail) const;
  /// Part "roll": from a start, the wheelset rolled, the rail displaced as printed either way or not.
  std::vector<ScanRow> roll(const ScanRow& start) const;
  /// Part "rails": from a start, the wheelset balanced on two rails that are displaced differently.
  std::vector<ScanRow> rails(const ScanRow& start) const;

  /// Of rows of the part "start", for each rail and inclination at loads as printed, the one nearest to the figures without
  /// bending, if nearer than `limit` [-]; nearest of all first. Positions are refined to 0.01 mm.
  std::vector<ScanRow> nearestStarts(const std::vector<ScanRow>& rows, double limit) const;

 private:
  void addPairs(OneWheel& wheel, ScanRow row, const Range& turns, std::vector<ScanRow>& rows) const;
  void refine(const ScanRow& best, std::vector<ScanRow>& rows) const;
  ContactModelConfig configFor(const std::string& rail, double inclination) const;

  ContactModelConfig config_;
  NormalSolver& solver_;
  ScanRanges ranges_;
};
}  // namespace wheel_rail_contact::core::paper
