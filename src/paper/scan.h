// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "paper/printed_figures.h"
#include "wheel_rail_contact/core/config.h"
#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core::paper
{
/// One setting of the evaluated wheel, with its results.
struct ScanRow
{
  std::string part;            ///< part of the scan, see the functions of Scan
  std::string rail;            ///< name of the rail profile
  double inclination;          ///< inclination of the undeflected rail towards the track centre [rad]
  double load;                 ///< vertical load of each wheel [N]
  double y;                    ///< lateral position of the wheelset, towards the flange positive [m]
  double roll;                 ///< roll of the wheelset, this wheel up positive [rad]
  RailDeflection crown;        ///< displacement of the crown of this rail
  RailDeflection other_crown;  ///< displacement of the crown of the other rail; used in the part "rails" only
  Figures without;             ///< for the undeflected rail at the same position; zero if the part has no pairs
  Figures figures;             ///< results of this wheel; zero if there is no solution

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

/// Names of the profiles that "UIC60" in the paper may mean.
inline const std::vector<std::string> studied_rails{"UIC60_manchester", "60E1"};

/// Ranges and steps of the scans. The defaults are those of `paper_study`.
struct ScanRanges
{
  std::vector<std::string> rails = studied_rails;
  std::vector<double> inclinations{0, 1.0 / 40, 1.0 / 20};                                                  ///< [rad]
  std::vector<double> loads{100e3, 50e3};                                                                   ///< [N]
  Range position{-6e-3, 6.4e-3, 124};                                                                       ///< [m]
  Range position_around_start{-0.06e-3, 0.06e-3, 6};                                                        ///< [m]
  Range pure_shift{-5e-3, 4e-3, 180};                                                                       ///< [m]
  std::vector<double> shift{-1e-3, -0.5e-3, -printed_displacement, 0, printed_displacement, 0.5e-3, 1e-3};  ///< [m]
  Range turn{-20e-3, 20e-3, 40};                                                                            ///< [rad]
  Range free_position{-6e-3, 5.2e-3, 28};                                                                   ///< [m]
  Range free_turn{-26e-3, 26e-3, 52};                                                                       ///< [rad]
  Range roll{-1e-3, 1e-3, 20};                                                                              ///< [rad]
  Range free_inclination{14e-3, 50e-3, 36};                                                                 ///< [rad]
};

/// Runs the scans. All solutions use one grid of 32 × 64 cells and a cold start.
class Scan
{
 public:
  /// Uses track, wheelset and materials of `config`; rail profile and rail inclination are replaced. `solver` must
  /// outlive this.
  Scan(ContactModelConfig config, NormalSolver& solver, ScanRanges ranges);

  /// Part "start": settings for the results without bending: rail profiles, inclinations, loads, positions.
  std::vector<ScanRow> start() const;
  /// Part "shift": from a start, the rail displaced laterally only.
  std::vector<ScanRow> shift(const ScanRow& start) const;
  /// Part "pair": at positions around a start, the rail displaced and turned about its crown.
  std::vector<ScanRow> pair(const ScanRow& start) const;
  /// Part "inclination": all inclinations and positions whose results without bending are close to the printed ones.
  /// The rail is displaced outward as printed, and turned. Refined around the best pairs with an inward and an outward
  /// turn.
  std::vector<ScanRow> inclination(const std::string& rail) const;
  /// Part "alone": settings for the results with bending only: all positions, all turns of the rail.
  std::vector<ScanRow> alone(const std::string& rail) const;
  /// Part "roll": from a start, the wheelset rolled, and the rail displaced by the printed amount outward, inward or
  /// not at all.
  std::vector<ScanRow> roll(const ScanRow& start) const;
  /// Part "rails": from a start, the wheelset balanced on two rails with different displacements.
  std::vector<ScanRow> rails(const ScanRow& start) const;

  /// From the rows of the part "start" at the printed load: for each rail profile and inclination, the row closest to
  /// the printed results without bending, if its deviation is below `limit` [-]. Sorted by the deviation. Positions are
  /// refined to 0.01 mm.
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
