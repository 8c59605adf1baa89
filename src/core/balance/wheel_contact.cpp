// SPDX-License-Identifier: BSD-3-Clause
#include "core/balance/wheel_contact.h"

#include <algorithm>
#include <cmath>

#include "core/track/gap.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double touch_accuracy = 1e-8;  ///< of the height of first touch on a steep surface [m]
/// Overlap of a wheel on a rail under a load, over load^(2/3); a start [m/N^(2/3)].
constexpr double typical_overlap = 2.8e-8;

/// Movements whose openings are not multiples of one another.
constexpr std::array<Motion, 4> independent{wheel_up, wheel_roll, rail_lateral, rail_roll};

/// Turn of the wheel from one column to another [rad], small.
double wheelTurn(const SurfaceColumn& from, const SurfaceColumn& to)
{
  return to.turnFrom(from) + to.wheel_slope - from.wheel_slope;
}
}  // namespace

WheelContact::WheelContact(const ContactModelConfig& config, Side side, const PlacedRail& rail, NormalSolver& solver,
                           double longest_rail)
    : solver_(solver),
      grids_(config, side, rail, longest_rail),
      tangent_(tuning::rough_residual),
      first_reach_(usesOverlap(config.contact.method) ? OverlapGrids::Reach::whole : OverlapGrids::Reach::expected)
{
  solution_.status = SolveStatus::no_contact;
  problem_.modulus = contactModulus(config.wheel_material[side], config.rail_material[side]);
}

/// Removes the last solution.
WheelStatus WheelContact::none(WheelStatus status)
{
  solution_.patches.clear();
  solution_.approach = 0;
  solution_.status = SolveStatus::no_contact;
  forces_.setZero();
  column_forces_.clear();
  energy_ = 0;
  return status;
}

void WheelContact::setGrid(std::size_t level, const GridSize& size)
{
  size_ = size;
  reach_ = first_reach_;
  if (level > level_)
  {
    grids_.follow(solution_.patches);
    if (!grids_.wouldBeComplete(size, problem_, solution_))
    {
      reach_ = OverlapGrids::Reach::whole;
    }
  }
  else
  {
    grids_.unfollow();
  }
  start_reach_ = reach_;
  if (level != level_)
  {
    kept_.resize(std::max(kept_.size(), std::max(level, level_) + 1));
    std::swap(kept_[level_], solution_);
    std::swap(kept_[level], solution_);
    level_ = level;
    solution_.status = SolveStatus::no_contact;
    column_forces_.clear();
  }
}

void WheelContact::forget()
{
  none(WheelStatus::no_contact);
  grids_.unfollow();
  for (NormalSolution& solution : kept_)
  {
    solution.patches.clear();
  }
}

WheelStatus WheelContact::touch(const WheelsetPose& pose)
{
  pose_ = pose;
  double separation = 0;
  for (int i = 0; i < tuning::most_solutions; ++i)
  {
    if (build(first_reach_) == OverlapGrids::Overlap::beside)
    {
      return none(WheelStatus::beside_rail);
    }
    separation = grids_.touch().separation;
    pose_.z -= separation;
    // The separation falls with the height as it does itself, unless the flange back touches a check rail.
    if (std::abs(separation) < touch_accuracy || !RailSearch::isSteep(grids_.touch()))
    {
      break;
    }
  }
  return none(WheelStatus::no_contact);
}

WheelStatus WheelContact::solveAt(const WheelsetPose& pose)
{
  pose_ = pose;
  switch (build(reach_))
  {
    case OverlapGrids::Overlap::beside:
      return none(WheelStatus::beside_rail);
    case OverlapGrids::Overlap::none:
      return none(WheelStatus::no_contact);
    default:
      return solve(NormalProblem::Control::approach, 0);
  }
}

double WheelContact::typicalOverlap(double load)
{
  return typical_overlap * std::cbrt(load * load);
}

WheelStatus WheelContact::solveLoad(const WheelsetPose& pose, double load)
{
  pose_ = pose;
  for (int i = 0; i < tuning::most_solutions; ++i)
  {
    switch (build(reach_))
    {
      case OverlapGrids::Overlap::beside:
        return none(WheelStatus::beside_rail);
      case OverlapGrids::Overlap::none:
        pose_.z -= grids_.touch().separation + typicalOverlap(load);
        break;
      default:
        return solve(NormalProblem::Control::load, load);
    }
  }
  return none(WheelStatus::unbalanced);
}

OverlapGrids::Overlap WheelContact::build(OverlapGrids::Reach reach)
{
  return grids_.build(pose_, size_, choice_, reach, problem_);
}

/// Solves the problem, from the last solution if that is possible.
void WheelContact::solveProblem()
{
  const bool warm = solution_.patches.size() == problem_.patches.size();
  solver_.solveCurved(problem_, warm, solution_);
  if (warm && !isUsable(solution_.status))
  {
    solver_.solveCurved(problem_, false, solution_);
  }
  ++solutions_;
}

WheelStatus WheelContact::solve(NormalProblem::Control control, double value)
{
  problem_.control = control;
  problem_.value = value;
  solveProblem();
  if (isUsable(solution_.status) && !grids_.isComplete(problem_, solution_))
  {
    if (build(OverlapGrids::Reach::whole) != OverlapGrids::Overlap::found)
    {
      return none(WheelStatus::unbalanced);  // the overlap is between the columns of the larger grid
    }
    solveProblem();
    reach_ = isDeepEnough() ? OverlapGrids::Reach::whole : reach_;
  }
  if (!isUsable(solution_.status))
  {
    const SolveStatus status = solution_.status;
    none(WheelStatus::normal_failed);
    solution_.status = status;
    return WheelStatus::normal_failed;
  }
  evaluate();
  if (solution_.status == SolveStatus::no_contact)
  {
    return none(WheelStatus::no_contact);
  }
  return WheelStatus::solved;
}

/// Computes the openings of a patch per unit of each coordinate.
void WheelContact::openings(std::size_t patch)
{
  const std::vector<SurfaceColumn>& columns = grids_.columns()[patch];
  Eigen::ArrayXXd& openings = openings_[patch];
  openings.resize(static_cast<Eigen::Index>(columns.size()), motions);
  const PlanePoint reference = rail().referencePoint();
  for (std::size_t j = 0; j < columns.size(); ++j)
  {
    const SurfaceColumn& column = columns[j];
    const double out = column.perOutward(), up = column.perUp();
    // A roll moves the wheel by -(z - z_axle) outward and by y - y_axle upwards.
    openings.row(static_cast<Eigen::Index>(j)) << up, -(column.z - pose_.z) * out + (column.y - pose_.y) * up, -out,
        -up, -(column.z - reference.z) * out + (column.y - reference.y) * up;
  }
}

/// Computes forces and energy of the last solution.
void WheelContact::evaluate()
{
  const std::size_t count = problem_.patches.size();
  openings_.resize(count);
  column_forces_.resize(count);
  forces_.setZero();
  energy_ = 0;
  for (std::size_t k = 0; k < count; ++k)
  {
    openings(k);
    const PatchGap& gap = problem_.patches[k];
    const Eigen::ArrayXXd& pressure = solution_.patches[k].pressure;
    column_forces_[k] = gap.grid.cellArea() * pressure.colwise().sum().transpose().matrix();
    forces_.noalias() += openings_[k].matrix().transpose() * column_forces_[k];
    energy_ -= 0.5 * gap.grid.cellArea() * (pressure * gap.gap).sum();
  }
  energy_ += 0.5 * forces_[wheel_up] * solution_.approach;
}

bool WheelContact::hasOwnGrids()
{
  const bool has_own = reach_ == start_reach_ || !grids_.wouldBeComplete(size_, problem_, solution_);
  reach_ = has_own ? reach_ : start_reach_;
  return has_own && grids_.fits(remaining());
}

bool WheelContact::reachesEnd() const
{
  const double wheel_end = grids_.wheelLength();
  for (std::size_t k = 0; k < column_forces_.size(); ++k)
  {
    const Eigen::VectorXd& forces = column_forces_[k];
    const std::vector<SurfaceColumn>& columns = grids_.columns()[k];
    const double width = problem_.patches[k].grid.dy;
    for (Eigen::Index j = 0; j < forces.size(); ++j)
    {
      const auto here = static_cast<std::size_t>(j);
      const bool beside_end = (j > 0 && !columns[here - 1].has_bodies) ||
                              (here + 1 < columns.size() && !columns[here + 1].has_bodies) ||
                              columns[here].wheel_u < width || columns[here].wheel_u > wheel_end - width;
      if (forces[j] > 0 && beside_end)
      {
        return true;
      }
    }
  }
  return grids_.missesOverlap();
}

double WheelContact::heightOverReference() const
{
  const double reference = rail().referencePoint().z;
  double force = 0, moment = 0;
  for (std::size_t k = 0; k < column_forces_.size(); ++k)
  {
    for (std::size_t j = 0; j < grids_.columns()[k].size(); ++j)
    {
      const double share = column_forces_[k][static_cast<Eigen::Index>(j)];
      force += share;
      moment += share * (grids_.columns()[k][j].z - reference);
    }
  }
  return force > 0 ? moment / force : 0;
}

double WheelContact::opening(const MotionVector& move) const
{
  double least = 0, most = 0;
  const bool under_load = problem_.control == NormalProblem::Control::load;
  const double rise = under_load ? -forces_.dot(move) / forces_[wheel_up] : 0;
  for (std::size_t k = 0; k < column_forces_.size(); ++k)
  {
    for (Eigen::Index j = 0; j < column_forces_[k].size(); ++j)
    {
      if (column_forces_[k][j] > 0)
      {
        const double opening = openings_[k].row(j).matrix().dot(move) + rise * openings_[k](j, wheel_up);
        least = std::min(least, opening);
        most = std::max(most, opening);
      }
    }
  }
  return std::max(most, -least);
}

/// Copies the openings by the independent movements. The rail moving up opens the gap as the wheel moving down does.
void WheelContact::selectOpenings()
{
  tangent_openings_.resize(openings_.size());
  for (std::size_t k = 0; k < openings_.size(); ++k)
  {
    tangent_openings_[k].resize(openings_[k].rows(), independent.size());
    for (std::size_t m = 0; m < independent.size(); ++m)
    {
      tangent_openings_[k].col(static_cast<Eigen::Index>(m)) = openings_[k].col(independent[m]);
    }
  }
}

MotionVector WheelContact::verticalStiffness()
{
  MotionVector row = MotionVector::Zero();
  if (column_forces_.empty())
  {
    return row;
  }
  selectOpenings();
  tangent_.setResidual(tuning::rough_residual);
  const ContactTangent::Forces elastic = tangent_.stiffness(problem_, solution_, tangent_openings_, 0);
  for (std::size_t m = 0; m < independent.size(); ++m)
  {
    row[independent[m]] = elastic[static_cast<Eigen::Index>(m)];
  }
  row[rail_up] = -row[wheel_up];
  return row - geometricStiffness().col(wheel_up);
}

MotionMatrix WheelContact::stiffness(double residual)
{
  if (column_forces_.empty())
  {
    return MotionMatrix::Zero();
  }
  selectOpenings();
  tangent_.setResidual(residual);
  const ContactTangent::Stiffness elastic = tangent_.stiffness(problem_, solution_, tangent_openings_);
  MotionMatrix stiffness;
  for (std::size_t m = 0; m < independent.size(); ++m)
  {
    for (std::size_t n = 0; n < independent.size(); ++n)
    {
      stiffness(independent[m], independent[n]) = elastic(static_cast<Eigen::Index>(m), static_cast<Eigen::Index>(n));
    }
  }
  stiffness.row(rail_up) = -stiffness.row(wheel_up);
  stiffness.col(rail_up) = -stiffness.col(wheel_up);
  stiffness(rail_up, rail_up) = stiffness(wheel_up, wheel_up);
  return stiffness - geometricStiffness();
}

/// Integral of the pressure times the second derivatives of the gap. A column sees the wheel move by e along the rail
/// and turn by w: with the curvature c of the wheel, the second derivatives are c e_k e_l - e_k w_l - w_k e_l, and for
/// a roll about a point minus the height over this point along the normal.
MotionMatrix WheelContact::geometricStiffness() const
{
  MotionMatrix sum = MotionMatrix::Zero();
  const PlanePoint reference = rail().referencePoint();
  MotionVector turn = MotionVector::Zero();
  turn[wheel_roll] = turn[rail_roll] = 1;
  for (std::size_t k = 0; k < column_forces_.size(); ++k)
  {
    const std::vector<SurfaceColumn>& columns = grids_.columns()[k];
    const Eigen::Index last = column_forces_[k].size() - 1;
    for (Eigen::Index j = 0; j <= last; ++j)
    {
      const double force = column_forces_[k][j];
      if (!(force > 0))
      {
        continue;
      }
      const auto at = [&](Eigen::Index i) -> const SurfaceColumn& { return columns[static_cast<std::size_t>(i)]; };
      const Eigen::Index before = std::max<Eigen::Index>(j - 1, 0), after = std::min(j + 1, last);
      const double curvature =
          wheelTurn(at(before), at(after)) / (static_cast<double>(after - before) * problem_.patches[k].grid.dy);
      const SurfaceColumn& column = at(j);
      const double cosine = column.cosine, sine = column.sine;
      MotionVector along;
      along << sine, -(column.z - pose_.z) * cosine + (column.y - pose_.y) * sine, -cosine, -sine,
          -(column.z - reference.z) * cosine + (column.y - reference.y) * sine;
      sum += force * (curvature * along * along.transpose() - along * turn.transpose() - turn * along.transpose());
      const auto height = [&](double y, double z) { return -(column.y - y) * sine + (column.z - z) * cosine; };
      sum(wheel_roll, wheel_roll) -= force * height(pose_.y, pose_.z);
      sum(rail_roll, rail_roll) += force * height(reference.y, reference.z);
    }
  }
  return sum;
}

double WheelContact::halfSpaceRatio(std::size_t patch, Eigen::Index first, Eigen::Index last) const
{
  const std::vector<SurfaceColumn>& columns = grids_.columns()[patch];
  const SurfaceColumn& start = columns[static_cast<std::size_t>(first)];
  double rail_least = 0, rail_most = 0, wheel_least = start.wheel_slope,
         wheel_most = wheel_least;  // tangents of angles
  for (Eigen::Index j = first; j <= last; ++j)
  {
    const SurfaceColumn& column = columns[static_cast<std::size_t>(j)];
    const double turn = column.turnFrom(start);
    const double rail = turn / std::sqrt(1 - turn * turn);
    const double wheel = (rail + column.wheel_slope) / (1 - rail * column.wheel_slope);
    rail_least = std::min(rail_least, rail);
    rail_most = std::max(rail_most, rail);
    wheel_least = std::min(wheel_least, wheel);
    wheel_most = std::max(wheel_most, wheel);
  }
  return 0.5 * std::max(std::atan(rail_most) - std::atan(rail_least), std::atan(wheel_most) - std::atan(wheel_least));
}
}  // namespace wheel_rail_contact::core
