// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/normal/measures/pressure_measures.h"
#include "core/stress/point_sources.h"

namespace wheel_rail_contact::core
{
/// Columns of a grid that belong to a patch.
struct ColumnRange
{
  Eigen::Index begin = 0, count = 0;
};

/// Highest stresses beneath a patch.
struct HighestStresses
{
  StressPeak von_mises;   ///< von Mises stress
  StressPeak shear;       ///< maxShear()
  StressPeak orthogonal;  ///< |xz|, the shear stress that alternates when the patch rolls along x
};

/// Searches for the highest stresses beneath a patch.
///
/// First the stress is computed at some depths below some columns of the patch, under their centres of pressure, and
/// |xz| beside them. From the best places, parabolas along each direction lead to the maximum. PointSources give the
/// stress.
class StressSearch
{
 public:
  /// Takes the pressure of a grid [Pa], and keeps references to both. Cells outside of the patch count as well.
  /// @param axes  semi-axes of the patch; depths and distances of the search are multiples of the shorter one
  void set(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, const ColumnRange& patch, const SemiAxes& axes);

  /// Searches in a body with this Poisson's ratio.
  HighestStresses find(double poisson);

 private:
  /// A kind of stress.
  using Measure = double (*)(const Stress&);
  static constexpr std::size_t star_size = point_batch / 2;  ///< points of a star, see Top::place()
  /// Place under a column, in units of the shorter semi-axis.
  struct Column
  {
    double x = 0, y = 0;     ///< centre of pressure of the column
    double half = 0;         ///< half its loaded length: that of a semi-ellipse with its variance
    StressPeak von_mises;    ///< found below it in the first search
    StressPeak alternating;  ///< |xz| found beside it
  };
  /// Top of parabolas through the points of a star.
  struct Parabolas
  {
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< from the centre, in steps of the star, at most 1
    double value = 0;
    bool inside = true;  ///< no offset is limited
  };
  /// A maximum that is refined, in the same unit, with the star of points around it.
  struct Top
  {
    Measure measure = nullptr;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(), steps = Eigen::Vector3d::Zero();
    StressPeak peak;   ///< highest value so far
    StressPeak shear;  ///< highest shear stress close to a maximum of the von Mises stress

    void begin(double along_surface, double along_depth, double longer_x, double longer_y);
    Eigen::Vector3d place(std::size_t number) const;
    Eigen::Vector3d moved(const Eigen::Vector3d& offset) const;
    bool advance(const Stress* star, double least);
  };

  void addColumn(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, Eigen::Index column);
  void searchBelow(Column& column, double poisson) const;
  void addTops(StressPeak Column::*of, Measure measure);
  void refine(Top* tops, std::size_t count, double spacing, double poisson) const;
  void settle(Top& top, double poisson);
  static Parabolas parabolas(const Stress* star, Measure measure);
  StressPeak scaled(const StressPeak& peak) const
  {
    return {peak.value, unit_ * peak.x, unit_ * peak.y, unit_ * peak.depth};
  }

  double unit_ = 1;                     ///< shorter semi-axis [m]
  double longer_x_ = 1, longer_y_ = 1;  ///< semi-axes in this unit [-]
  PointSources rough_, fine_;
  std::vector<Column> columns_;
  std::size_t pressed_ = 0;  ///< the column with the highest pressure
  std::vector<Top> tops_;
  std::vector<double> open_places_;  ///< their places across the track
  const PatchGrid* grid_ = nullptr;
  const Eigen::ArrayXXd* pressure_ = nullptr;
};

/// Highest pressure [Pa] over the yield stress in shear, yield / sqrt 3 (von Mises) [-]; 0 if the yield stress in
/// tension [Pa] is 0.
double loadFactor(double max_pressure, double yield);

/// Bound of the load factor for shakedown, see PatchStress::shakedown_limit [-]; 0 without stress.
/// @param orthogonal  highest |xz| [Pa]
/// @param von_mises   highest von Mises stress [Pa]
double shakedownLimit(double max_pressure, double orthogonal, double von_mises);
}  // namespace wheel_rail_contact::core
