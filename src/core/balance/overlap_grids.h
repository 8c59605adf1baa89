// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/balance/grid_layout.h"
#include "core/balance/outside_contact.h"
#include "core/balance/rail_region.h"
#include "core/track/gap.h"
#include "core/track/rail_search.h"
#include "wheel_rail_contact/core/config.h"
#include "wheel_rail_contact/core/normal_problem.h"

namespace wheel_rail_contact::core
{
/// True for the methods that take the shape of the whole overlap.
inline bool usesOverlap(NormalMethod method)
{
  return method == NormalMethod::hertz || method == NormalMethod::kik_piotrowski;
}

/// Grids on the surface of a rail over its overlap with a wheel, and the normal problem on them. Side axes.
///
/// The contact lies inside the overlap of the undeformed bodies, because the surfaces only move apart under a pressure.
/// Where the separation has one minimum, a grid covers the contact of paraboloids with the same overlap and a margin
/// (Reach::expected). If the pressure reaches its edge, or the rest of the overlap may touch (isComplete()), a grid
/// over the whole overlap must follow. Intervals of the overlap that are closer to one another than the wider of them
/// is wide are in one grid. Each grid is a patch of the problem. The forces in one grid displace the others
/// (CurvedProblem::coupling).
class OverlapGrids
{
 public:
  /// Relation of the undeformed bodies at a pose.
  enum class Overlap
  {
    none,    ///< they do not overlap
    found,   ///< they overlap, and the problem was built
    beside,  ///< the wheel is beside the rail, or has no column over it
  };

  /// Which grids are used. Those of the last call keep the solutions of one search smooth.
  enum class Choice
  {
    own,  ///< those of the pose
    kept  ///< those of the last call where they still cover the overlap
  };

  /// How much of the overlap the grids cover.
  enum class Reach
  {
    expected,  ///< the expected contact, where the separation has one minimum
    whole      ///< all of it
  };

  /// Keeps a reference to `config`, which must outlive this.
  /// @param rail  its profile is the first one of the rail
  /// @param longest_rail  length of the longest profile of the rail [m]
  OverlapGrids(const ContactModelConfig& config, Side side, const PlacedRail& rail, double longest_rail = 0);
  OverlapGrids(const OverlapGrids&) = delete;  // outside_ refers to other members
  OverlapGrids& operator=(const OverlapGrids&) = delete;

  /// Length of the wheel profile [m].
  double wheelLength() const { return config_.wheel_profile[side_]->length(); }
  /// True if bodies overlap where no cell of the last grids has points of both: beyond the end of a profile.
  bool missesOverlap() const { return misses_overlap_; }
  /// Sets the position of the rail, as ContactSearch.
  void setRail(const PlacedRail& rail, bool reshaped = false);
  const PlacedRail& rail() const { return *rail_; }

  /// Finds the overlap at a pose. Sets patches and coupling of the problem, whose modulus must be set, if there is one.
  Overlap build(const WheelsetPose& pose, const GridSize& size, Choice choice, Reach reach, CurvedProblem& problem);

  /// The next grids cover this pressure of the last problem and a cell more on each side, instead of the overlap.
  void follow(const std::vector<PatchPressure>& pressure);
  /// True after follow().
  bool follows() const { return !pressed_.empty(); }
  /// The next grids are laid over the overlap again.
  void unfollow() { pressed_.clear(); }

  /// Position of the smallest separation at the last pose. Valid unless the wheel was beside the rail.
  const InitialContact& touch() const { return touch_; }
  /// The wheel of the last pose at another height of the axle centre [m].
  PlacedWheel wheelAt(double z) const;
  /// Columns of each patch of the problem.
  const std::vector<std::vector<SurfaceColumn>>& columns() const { return columns_; }
  /// Origin of the grid of a patch.
  const SurfaceOrigin& originOf(std::size_t patch) const { return placed_[patch].layout.origin; }
  /// True if the grids contain the whole contact: no pressure reaches the edge of a grid that the overlap exceeds, and
  /// the surfaces outside of the grids, displaced by the forces in them, do not touch.
  bool isComplete(const NormalProblem& problem, const NormalSolution& solution);
  /// The same for grids with Reach::expected and this number of cells at the last pose.
  bool wouldBeComplete(const GridSize& size, const NormalProblem& problem, const NormalSolution& solution);
  /// True if the grids are those that the wheel would get `lower` below the last pose [m].
  bool fits(double lower);

 private:
  /// A grid as it was planned for its overlap, and as it was used after the overlap had been found to be larger.
  struct GroupGrid
  {
    GridLayout planned, used;
    Reach reach = Reach::whole;
    bool has_patch = true;           ///< there are columns that overlap
    std::size_t first = 0, end = 0;  ///< its intervals
  };

  /// True if gap and pressure are symmetric about the place of the axle.
  bool isSymmetric() const { return placed_wheel_->pose().yaw == 0 && !rail_->changes(); }
  bool findPressed(double u_begin, double u_end, RailRegion& all) const;
  SurfaceArea areaOf(const OverlapInterval* begin, const OverlapInterval* end, double lower, Reach reach) const;
  std::size_t endOfGroup(const std::vector<OverlapInterval>& intervals, std::size_t first) const;
  const GroupGrid* earlierGrid(const SurfaceArea& area, const GridSize& size) const;
  void join(bool keep);
  void addGrid(std::size_t first, std::size_t last, const GridSize& size, Choice choice, Reach reach,
               CurvedProblem& problem);
  bool fillGrid(const GridSize& size, SurfaceArea area, GridLayout& layout, std::vector<SurfaceColumn>& columns,
                PatchGap& patch, ColumnNormals& normals);
  void resize(std::size_t count, CurvedProblem& problem);

  const ContactModelConfig& config_;
  Side side_;
  std::optional<PlacedRail> rail_;
  RailSearch search_;
  InitialContact touch_;
  std::vector<OverlapInterval> intervals_, lower_intervals_;
  std::vector<std::vector<SurfaceColumn>> columns_;
  std::vector<GroupGrid> group_grids_, earlier_grids_;  ///< of each group of intervals, in this and in the last call
  std::vector<PlacedGrid> placed_, planned_;            ///< of each patch; see wouldBeComplete()
  std::vector<RailRegion> pressed_;                     ///< see follow()
  std::vector<std::pair<double, double>> joined_;       ///< see join()
  OutsideContact outside_;
  std::optional<PlacedWheel> placed_wheel_;
  bool misses_overlap_ = false;
  Eigen::ArrayXXd slope_;  ///< of the cells of a grid, see buildSurfaceGap()
};
}  // namespace wheel_rail_contact::core
