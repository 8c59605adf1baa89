// SPDX-License-Identifier: BSD-3-Clause
#include "core/stress/stress_search.h"

#include <algorithm>
#include <cmath>

namespace wheel_rail_contact::core
{
namespace
{
// Lengths in units of the shorter semi-axis, except steps along the logarithm of the depth.
constexpr double rough_spacing = 0.55;          ///< of the forces of the first search
constexpr double fine_spacing = 0.25;           ///< of the forces for the maxima
constexpr double near_depth = 1.3;              ///< forces are too coarse for a maximum at less than so many spacings
constexpr double least_depth = 1;               ///< least depth of the search, in spacings
constexpr double column_spacing = 0.6;          ///< longest distance of the columns of the first search
constexpr Eigen::Index column_count = 10;       ///< of the first search, at least, if so many are loaded
constexpr std::size_t below = point_batch / 2;  ///< points below the centre of a column; the others are for |xz|
/// Depths of the first search. Von Mises and shear stress have their maxima at 0.45 to 0.8 below ellipses, deeper below
/// a flat pressure, and less deep below a part of the patch; |xz| at 0.35 to 0.7.
constexpr std::array<double, below> first_depths{0.38, 0.46, 0.57, 0.72, 0.9, 1.15, 1.5, 1.9};
constexpr std::array<double, below / 2> orthogonal_depths{0.3, 0.42, 0.58, 0.8};
constexpr double orthogonal_x = 0.85;  ///< where |xz| is first searched for, in units of the half length of a column
constexpr double other_peak = 0.85;    ///< a local maximum of the first search is refined if it is so near the highest
constexpr double first_step = 0.2;     ///< of the parabolas along x and y, in units of the semi-axes
constexpr double depth_step = 0.2;     ///< of the parabolas in the logarithm of the depth
constexpr double last_step = 0.1;      ///< the same for the cells, in both
constexpr double most_moved = 0.3;     ///< distance over the depth from the place for which cells are divided
constexpr int most_rounds = 6;         ///< of parabolas
constexpr double least_gain = 0.003;   ///< the search ends where the top of the parabolas is hardly higher [-]

void setPlace(PointSources::Places& places, std::size_t k, double x, double y, double depth)
{
  places.x[k] = static_cast<float>(x);
  places.y[k] = static_cast<float>(y);
  places.depth[k] = static_cast<float>(depth);
}

void keepHigher(double value, const PointSources::Places& places, std::size_t k, StressPeak& peak)
{
  if (value > peak.value)
  {
    peak = {value, places.x[k], places.y[k], places.depth[k]};
  }
}

double alternating(const Stress& stress)
{
  return std::abs(stress.xz);
}

const double tension_over_shear = std::sqrt(3.0);  ///< of stresses with the same von Mises stress [-]
}  // namespace

void StressSearch::set(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, const ColumnRange& patch,
                       const SemiAxes& axes)
{
  unit_ = std::min(axes.along, axes.across);
  longer_x_ = axes.along / unit_;
  longer_y_ = axes.across / unit_;
  rough_.set(grid, pressure, unit_, rough_spacing, {});
  grid_ = &grid;
  pressure_ = &pressure;
  columns_.clear();
  const auto of_patch = pressure.middleCols(patch.begin, patch.count);
  const Eigen::Index loaded = (of_patch.colwise().maxCoeff() > 0).count();
  const auto step = std::max(Eigen::Index{1}, std::min((loaded + column_count - 1) / column_count,
                                                       static_cast<Eigen::Index>(column_spacing * unit_ / grid.dy)));
  Eigen::Index highest_row = 0, highest = 0;
  of_patch.maxCoeff(&highest_row, &highest);
  for (Eigen::Index j = highest % step; j < patch.count; j += step)
  {
    pressed_ = j == highest ? columns_.size() : pressed_;
    addColumn(grid, pressure, patch.begin + j);
  }
}

void StressSearch::addColumn(const PatchGrid& grid, const Eigen::ArrayXXd& pressure, Eigen::Index column)
{
  const PointSources::Line line = PointSources::lineOf(grid, pressure, column, column + 1, unit_);
  if (line.force > 0)
  {
    columns_.push_back({line.centre, line.y, line.half, {}, {}});
  }
}

HighestStresses StressSearch::find(double poisson)
{
  for (Column& column : columns_)
  {
    searchBelow(column, poisson);
  }
  tops_.clear();
  addTops(&Column::von_mises, vonMises);
  addTops(&Column::alternating, alternating);
  open_places_.clear();
  for (Top& top : tops_)
  {
    open_places_.push_back(top.centre.y());
    top.begin(first_step, depth_step, longer_x_, longer_y_);
  }
  fine_.set(*grid_, *pressure_, unit_, fine_spacing, open_places_);
  for (std::size_t k = 0; k < tops_.size(); k += 2)
  {
    refine(&tops_[k], std::min<std::size_t>(2, tops_.size() - k), fine_spacing, poisson);
  }
  HighestStresses highest;
  for (const Measure measure : {&vonMises, &alternating})
  {
    // Where the contact has few cells along the track, |xz| by forces is closer to that of a smooth pressure.
    const Top* best = nullptr;
    for (Top& top : tops_)
    {
      if (top.measure == measure && (measure == vonMises || top.peak.depth < near_depth * fine_spacing))
      {
        settle(top, poisson);
      }
      best = top.measure == measure && (best == nullptr || top.peak.value > best->peak.value) ? &top : best;
    }
    if (best != nullptr)
    {
      (measure == vonMises ? highest.von_mises : highest.orthogonal) = best->peak;
      highest.shear = measure == vonMises ? best->shear : highest.shear;
    }
  }
  return {scaled(highest.von_mises), scaled(highest.shear), scaled(highest.orthogonal)};
}

void StressSearch::searchBelow(Column& column, double poisson) const
{
  PointSources::Places places;
  for (std::size_t k = 0; k < below; ++k)
  {
    setPlace(places, k, column.x, column.y, first_depths[k]);
    const double side = k % 2 == 0 ? -orthogonal_x : orthogonal_x;
    setPlace(places, below + k, column.x + side * column.half, column.y, orthogonal_depths[k / 2]);
  }
  const std::array<Stress, point_batch> stresses = rough_.at(places, poisson);
  column.von_mises = column.alternating = {};
  for (std::size_t k = 0; k < below; ++k)
  {
    keepHigher(vonMises(stresses[k]), places, k, column.von_mises);
    keepHigher(alternating(stresses[below + k]), places, below + k, column.alternating);
  }
}

/// Adds the local maxima among the columns that may be the highest.
void StressSearch::addTops(StressPeak Column::*of, Measure measure)
{
  const auto at = [&](std::size_t k) { return k < columns_.size() ? (columns_[k].*of).value : 0; };
  double rough = 0;
  for (std::size_t k = 0; k < columns_.size(); ++k)
  {
    rough = std::max(rough, at(k));
  }
  const auto is_top = [&](std::size_t k)
  { return at(k) > other_peak * rough && at(k) >= at(k + 1) && (k == 0 || at(k) > at(k - 1)); };
  const bool is_near = is_top(pressed_) || is_top(pressed_ + 1) || (pressed_ > 0 && is_top(pressed_ - 1));
  for (std::size_t k = 0; k < columns_.size(); ++k)
  {
    // The highest stress below a narrow peak of the pressure may be closer to the surface than the first search looks.
    if (is_top(k) || (k == pressed_ && !is_near))
    {
      const StressPeak& start = columns_[k].*of;
      Top top;
      top.measure = measure;
      top.centre = {start.x, start.y, start.depth};
      tops_.push_back(top);
    }
  }
}

/// Moves up to two places to the tops of parabolas. Half of the points belong to each place.
void StressSearch::refine(Top* tops, std::size_t count, double spacing, double poisson) const
{
  for (int round = 0; round < most_rounds; ++round)
  {
    PointSources::Places places;
    for (std::size_t k = 0; k < point_batch; ++k)
    {
      const Eigen::Vector3d place = tops[std::min(k / star_size, count - 1)].place(k % star_size);
      setPlace(places, k, place.x(), place.y(), std::max(place.z(), least_depth * spacing));
    }
    const std::array<Stress, point_batch> stresses = fine_.at(places, poisson);
    bool ends = true;
    for (std::size_t k = 0; k < count; ++k)
    {
      ends = tops[k].advance(stresses.data() + k * star_size, least_depth * spacing) && ends;
    }
    if (ends)
    {
      return;
    }
  }
}

/// Moves a maximum to that of the pressure on the cells, which the forces only approximate.
void StressSearch::settle(Top& top, double poisson)
{
  bool is_near = false;
  for (int round = 0; round < most_rounds && !is_near; ++round)
  {
    const Eigen::Vector3d start(top.peak.x, top.peak.y, top.peak.depth);
    top.centre = start;
    top.begin(last_step, last_step, longer_x_, longer_y_);
    fine_.setCells(*grid_, *pressure_, unit_, start);
    refine(&top, 1, (1 - most_moved) / least_depth * start.z(), poisson);
    is_near = (Eigen::Vector3d(top.peak.x, top.peak.y, top.peak.depth) - start).norm() < most_moved * start.z();
  }
}

/// Starts the search for a maximum at the centre, with steps along the surface in units of the semi-axes.
void StressSearch::Top::begin(double along_surface, double along_depth, double longer_x, double longer_y)
{
  peak = {};
  steps = {std::min(along_surface * longer_x, centre.z()), std::min(along_surface * longer_y, centre.z()), along_depth};
}

/// Point of the star of a place: 0 and 7 are its centre, then two points along x, along y, and along the depth.
Eigen::Vector3d StressSearch::Top::place(std::size_t number) const
{
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  if (number > 0 && number + 1 < star_size)
  {
    offset[static_cast<Eigen::Index>((number - 1) / 2)] = number % 2 == 1 ? -1 : 1;
  }
  return moved(offset);
}

/// Centre of the star, moved by a number of steps. The steps of the depth are factors.
Eigen::Vector3d StressSearch::Top::moved(const Eigen::Vector3d& offset) const
{
  return {centre.x() + offset.x() * steps.x(), centre.y() + offset.y() * steps.y(),
          centre.z() * std::exp(offset.z() * steps.z())};
}

/// Top of the parabolas through the values of a star, at most one step from its centre.
StressSearch::Parabolas StressSearch::parabolas(const Stress* star, Measure measure)
{
  Parabolas result;
  const double middle = measure(star[0]);
  result.value = middle;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    const double low = measure(star[2 * axis + 1]), high = measure(star[2 * axis + 2]);
    const double bend = low + high - 2 * middle, slope = 0.5 * (high - low);
    const double top = bend < 0 ? std::clamp(-slope / bend, -1.0, 1.0) : (slope > 0 ? 1 : -1);
    result.offset[axis] = top;
    result.value += top * (slope + 0.5 * bend * top);
    result.inside = result.inside && std::abs(top) < 1;
  }
  return result;
}

/// Moves the centre of the star to the top of the parabolas. If this is inside the star, the next star is half as
/// large.
/// @return true if the maximum is found: the top of the parabolas, hardly higher than the centre
bool StressSearch::Top::advance(const Stress* star, double least)
{
  const Parabolas next = parabolas(star, measure);
  const double middle = measure(star[0]);
  const bool found = next.inside && next.value < (1 + least_gain) * middle;
  const Eigen::Vector3d top = moved(next.offset);
  if (found)
  {
    peak = {next.value, top.x(), top.y(), top.z()};
  }
  else if (middle > peak.value)
  {
    peak = {middle, centre.x(), centre.y(), centre.z()};
  }
  if (measure == vonMises)
  {
    const Parabolas of_shear = parabolas(star, maxShear);
    const Eigen::Vector3d place = of_shear.inside ? moved(of_shear.offset) : centre;
    shear = {of_shear.inside ? of_shear.value : maxShear(star[0]), place.x(), place.y(), place.z()};
  }
  centre = {top.x(), top.y(), std::max(top.z(), least)};
  steps *= next.inside ? 0.5 : 1;
  return found;
}

double loadFactor(double max_pressure, double yield)
{
  return yield > 0 ? max_pressure * tension_over_shear / yield : 0;
}

double shakedownLimit(double max_pressure, double orthogonal, double von_mises)
{
  // Half of two changes of the stress during a passage: of xz, which changes its sign, and of a stress that comes and
  // goes.
  const double range = std::max(orthogonal, 0.5 * von_mises / tension_over_shear);
  return range > 0 ? max_pressure / range : 0;
}
}  // namespace wheel_rail_contact::core
