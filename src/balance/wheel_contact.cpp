// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/balance/wheel_contact.h"

#include <algorithm>
#include <cmath>

#include "wheel_rail_contact/normal/aspect_ladder.h"
#include "wheel_rail_contact/normal/hertz.h"

namespace wheel_rail_contact
{
namespace
{
constexpr double box_margin = 1.1;        ///< grid over pressure, lengthwise and across [-]
constexpr double box_growth = 0.3;        ///< by which a box grows at a side that the pressure touches, of its size [-]
constexpr int most_boxes = 6;             ///< grids tried in one call
constexpr double first_reach = 0.85;      ///< expected pressure against overlap at the first call [-]
constexpr int estimate_steps = 4;         ///< fixed-point steps of the descent's estimate
constexpr double missed_clearance = 0.1;  ///< width beside a box in which edges alone tell, of the box's width [-]
constexpr double missed_share = 0.05;     ///< overlap beyond a box that is let pass, of the descent [-]
constexpr double descent_allowance =
    1.02;  ///< descent above its estimate at which the stretches are looked at again [-]

/// Parameter of the rail's profile at place t of the patch frame, from the columns, carried on beyond them.
double railParameter(const Grid& grid, const std::vector<GapColumn>& columns, double t)
{
  const double place = (t - grid.y0) / grid.dy;
  const auto low = static_cast<std::size_t>(std::clamp(place, 0.0, grid.ny - 2.0));
  return columns[low].rail_u + (place - static_cast<double>(low)) * (columns[low + 1].rail_u - columns[low].rail_u);
}

/// Finds the pressure's centre, and its mean normal.
void findCenter(const Eigen::ArrayXXd& pressure, const Grid& grid, WheelPatch& patch)
{
  patch.slope = patch.center_x = patch.center_y = 0;
  const double sum = pressure.sum();
  if (!(sum > 0))
  {
    return;
  }
  for (int j = 0; j < grid.ny; ++j)
  {
    const double share = pressure.col(j).sum() / sum;
    patch.center_y += share * grid.y(j);
    patch.slope += share * patch.columns[static_cast<std::size_t>(j)].slope;
  }
  for (int i = 0; i < grid.rows() && !grid.symmetric; ++i)
  {
    patch.center_x += pressure.row(i).sum() / sum * grid.x(i);
  }
}

/// Grid on the ladder of cell aspects over `length` along and [begin, end] across, with a margin [m].
Grid coveringGrid(double length, double begin, double end, const GridSize& size)
{
  const aspect_ladder::Cell cell =
      aspect_ladder::coveringCell(box_margin * length, box_margin * (end - begin), size.along, size.across);
  return {size.along, size.across, cell.dx, cell.dy, 0.5 * (begin + end) - 0.5 * (size.across - 1) * cell.dy, false};
}

/// Place of a point along the plane [m].
double placeOnPlane(const ContactPlane& plane, const PlanePoint& point)
{
  return std::cos(plane.angle) * (point.y - plane.y) + std::sin(plane.angle) * (point.z - plane.z);
}

double wheelRadius(const ContactModelConfig& config, const InitialContact& contact)
{
  return config.wheelset.rolling_radius - config.wheel_profile->at(contact.wheel_u).z;
}
}  // namespace

WheelContact::WheelContact(const ContactModelConfig& config, NormalSolver& solver)
    : config_(config),
      solver_(solver),
      modulus_(contactModulus(config.wheel_material, config.rail_material)),
      search_(*config.wheel_profile, *config.rail_profile)
{
}

void WheelContact::setRail(const PlacedRail& rail)
{
  rail_ = rail;
  search_.setRail(rail);
}

void WheelContact::reset()
{
  memory_.clear();
  load_ = 0;
}

RigidTouch WheelContact::touch(const WheelsetPose& pose)
{
  RigidTouch touch;
  wheel_.emplace(*config_.wheel_profile, config_.wheelset, pose);
  search_.setWheel(*wheel_);
  touch.found = search_.nearest(touch.contact);
  if (touch.found)
  {
    touch.axle_height = pose.z - touch.contact.separation;
    const PlanePoint point = rail_->at(touch.contact.rail_u);
    touch.lever = point.y - pose.y + (point.z - touch.axle_height) * touch.contact.slope;
  }
  return touch;
}

double WheelContact::estimateDescent(const RigidTouch& touch, double load) const
{
  if (load_ > 0)
  {
    return solution_.approach * std::cbrt((load / load_) * (load / load_));
  }
  const double cosine = 1 / std::hypot(1, touch.contact.slope);
  const double along = 0.5 * cosine / wheelRadius(config_, touch.contact);
  double descent = 1e-4;
  for (int i = 0; i < estimate_steps; ++i)
  {
    const OverlapZone zone = search_.zoneAround(touch.contact, touch.contact.separation + descent);
    const double half = 0.5 * (zone.u_end - zone.u_begin);
    const double across = descent * cosine / (half * half);
    descent = hertzForForce({along, across}, modulus_, load / cosine).approach / cosine;
  }
  return descent;
}

WheelStatus WheelContact::solveLoad(const RigidTouch& touch, double load, const GridSize& size)
{
  problem_.control = NormalProblem::Control::load;
  problem_.value = load;
  solution_.approach = estimateDescent(touch, load);
  const WheelStatus status = solve(touch, size);
  load_ = status == WheelStatus::solved ? load : 0;
  return status;
}

WheelStatus WheelContact::solveDescent(const RigidTouch& touch, double descent, const GridSize& size)
{
  if (!(descent > 0))
  {
    reset();
    return WheelStatus::no_contact;
  }
  problem_.control = NormalProblem::Control::approach;
  problem_.value = descent;
  solution_.approach = descent;
  const WheelStatus status = solve(touch, size);
  load_ = status == WheelStatus::solved ? forces().vertical : 0;
  return status;
}

WheelStatus WheelContact::solve(const RigidTouch& touch, const GridSize& size)
{
  WheelsetPose pose = wheel_->pose();
  pose.z = touch.axle_height;
  wheel_.emplace(*config_.wheel_profile, config_.wheelset, pose);
  problem_.modulus = modulus_;
  for (int attempt = 0; attempt < most_boxes; ++attempt)
  {
    if (!layBoxes(touch, size))
    {
      return WheelStatus::off_profile;
    }
    solver_.solve(problem_, true, solution_);
    if (!isUsable(solution_.status))
    {
      solver_.solve(problem_, false, solution_);
    }
    ++solutions_;
    if (!isUsable(solution_.status))
    {
      reset();
      return WheelStatus::normal_failed;
    }
    measure();
    widened_ = widened_ && attempt > 0;
    if (boxesHold(touch))
    {
      return onProfiles() ? WheelStatus::solved : WheelStatus::off_profile;
    }
    learn();
  }
  reset();
  return WheelStatus::box_not_found;
}

/// Memory of the contact in this stretch, a guess if there is none.
WheelContact::Memory& WheelContact::recall(const OverlapZone& zone)
{
  Memory* nearest = nullptr;
  for (Memory& memory : memory_)
  {
    const bool inside = memory.rail_u >= zone.u_begin && memory.rail_u <= zone.u_end;
    if (inside && (nearest == nullptr ||
                   std::abs(memory.rail_u - zone.contact.rail_u) < std::abs(nearest->rail_u - zone.contact.rail_u)))
    {
      nearest = &memory;
    }
  }
  if (nearest == nullptr)
  {
    memory_.push_back({zone.contact.rail_u, 0, -first_reach, first_reach, first_reach, 0, 0, {}, 0, 0});
    nearest = &memory_.back();
  }
  return *nearest;
}

/// Lays plane and grid over the patch's stretch, as remembered.
void WheelContact::layBox(const GridSize& size, WheelPatch& patch, Grid& grid)
{
  const OverlapZone& zone = patch.zone;
  Memory& memory = recall(zone);
  const double middle = 0.5 * (zone.u_begin + zone.u_end);
  const double half = 0.5 * (zone.u_end - zone.u_begin);
  ContactPlane& plane = patch.plane;
  plane = tangentPlane(*wheel_, *rail_, zone.contact);
  plane.x += memory.shift_x;
  plane.angle += memory.turn;
  plane.rail_u = middle + memory.center * half;
  plane.wheel_u += plane.rail_u - zone.contact.rail_u;
  const PlanePoint origin = rail_->at(plane.rail_u);
  plane.y = origin.y;
  plane.z = origin.z;

  const bool symmetric = wheel_->pose().yaw == 0;
  if (memory.grid.nx == size.along && memory.grid.ny == size.across && memory.grid.symmetric == symmetric)
  {
    grid = memory.grid;
    patch.expected_width = memory.width;
    patch.expected_length = memory.length;
    return;
  }
  const double cosine = std::cos(plane.angle);
  const double sine = std::sin(plane.angle);
  const auto place = [&](double u)
  {
    const PlanePoint point = rail_->at(u);
    return cosine * (point.y - origin.y) + sine * (point.z - origin.z);
  };
  const double begin = place(middle + memory.begin * half);
  const double end = place(middle + memory.end * half);
  patch.expected_width = memory.width = end - begin;
  patch.expected_length = memory.length = 2 * memory.half_length * patch.half_overlap;
  grid = coveringGrid(memory.length, begin, end, size);
  grid.symmetric = symmetric;
  memory.grid = grid;
}

bool WheelContact::layBoxes(const RigidTouch& touch, const GridSize& size)
{
  boxed_descent_ = solution_.approach;
  search_.overlapZones(touch.contact.separation + boxed_descent_, zones_);
  problem_.patches.resize(zones_.size());
  patches_.resize(zones_.size());
  for (std::size_t k = 0; k < zones_.size(); ++k)
  {
    WheelPatch& patch = patches_[k];
    PatchGap& gap = problem_.patches[k];
    patch.zone = zones_[k];
    patch.touch_gap = patch.zone.contact.separation - touch.contact.separation;
    patch.half_overlap = std::sqrt(2 * (boxed_descent_ - patch.touch_gap) * wheelRadius(config_, patch.zone.contact));
    layBox(size, patch, gap.grid);
    gap.weight = std::cos(patch.plane.angle);
    const bool sound = gap.grid.dx > 0 && gap.grid.dy > 0;
    if (!sound || !buildGap(*wheel_, *rail_, patch.plane, gap.grid, gap.gap, patch.columns))
    {
      return false;
    }
  }
  return !zones_.empty();
}

WheelContact::Memory WheelContact::remember(const WheelPatch& patch, const Grid& grid) const
{
  const PressureExtent& extent = patch.extent;
  const OverlapZone& zone = patch.zone;
  const double grown = std::sqrt(solution_.approach / boxed_descent_);  // of the stretch, by the solved descent
  const double middle = 0.5 * (zone.u_begin + zone.u_end);
  const double half = 0.5 * (zone.u_end - zone.u_begin) * grown;
  const auto fraction = [&](double t) { return (railParameter(grid, patch.columns, t) - middle) / half; };
  Memory memory;
  memory.rail_u = railParameter(grid, patch.columns, patch.center_y);
  memory.center = (memory.rail_u - middle) / half;
  memory.begin = fraction(extent.y_begin);
  memory.end = fraction(extent.y_end);
  memory.half_length = extent.half_length / (patch.half_overlap * grown);
  memory.turn = patch.plane.angle + std::atan(patch.slope) - std::atan(zone.contact.slope);
  memory.shift_x = patch.plane.x + patch.center_x - tangentPlane(*wheel_, *rail_, zone.contact).x;
  growCut(extent, grid, memory);
  return memory;
}

void WheelContact::growCut(const PressureExtent& extent, const Grid& grid, Memory& memory)
{
  const double width = memory.end - memory.begin;
  memory.begin -= extent.cutBegin(grid) ? box_growth * width : 0;
  memory.end += extent.cutEnd(grid) ? box_growth * width : 0;
  memory.half_length *= extent.cutLength(grid) ? 1 + box_growth : 1;
}

void WheelContact::measure()
{
  box_fill_ = 1;
  box_cut_ = false;
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    const Grid& grid = problem_.patches[k].grid;
    const Eigen::ArrayXXd& pressure = solution_.patches[k].pressure;
    findCenter(pressure, grid, patches_[k]);
    patches_[k].extent = findExtent(grid, pressure);
    const PressureExtent& extent = patches_[k].extent;
    if (!extent.empty)
    {
      box_cut_ = box_cut_ || extent.cut(grid);
      box_fill_ = std::min({box_fill_, (extent.y_end - extent.y_begin) / patches_[k].expected_width,
                            2 * extent.half_length / patches_[k].expected_length});
    }
  }
}

void WheelContact::learn()
{
  memory_.clear();
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    if (!patches_[k].extent.empty)
    {
      memory_.push_back(remember(patches_[k], problem_.patches[k].grid));
    }
  }
}

/// Looks at the stretch beyond the box: where the undeformed bodies overlap by more than this pressure pushes them
/// apart there, pressure was missed (a second lobe, say). Widens the patch's extent over such places.
bool WheelContact::missesPressure(const RigidTouch& touch, std::size_t k)
{
  WheelPatch& patch = patches_[k];
  const Grid& grid = problem_.patches[k].grid;
  const double clearance = missed_clearance * grid.ny * grid.dy;
  const double closing = (1 - missed_share) * solution_.approach * std::cos(patch.plane.angle);
  search_.stationsBetween(patch.zone.u_begin, patch.zone.u_end, stations_);
  bool missed = false;
  for (const Station& station : stations_)
  {
    const PlanePoint rail = rail_->at(station.rail_u);
    const double t = placeOnPlane(patch.plane, rail);
    const double local = std::atan2(rail.dz, rail.dy);
    const double gap =
        (station.separation - touch.contact.separation) * std::cos(local) / std::cos(local - patch.plane.angle);
    const bool beyond = t < grid.y0 - clearance || t > grid.y(grid.ny - 1) + clearance;
    if (beyond && closing - gap > displacementBeside(k, t))
    {
      missed = true;
      patch.extent.y_begin = std::min(patch.extent.y_begin, t);
      patch.extent.y_end = std::max(patch.extent.y_end, t);
    }
  }
  return missed;
}

/// Displacement of both bodies at place t beside the pressure, on its line of centres [m]: each column's load spread
/// evenly over the pressure's length, columns taken together in eight groups.
double WheelContact::displacementBeside(std::size_t k, double t) const
{
  const Grid& grid = problem_.patches[k].grid;
  const Eigen::ArrayXXd& pressure = solution_.patches[k].pressure;
  const double half_length = std::max(patches_[k].extent.half_length, grid.dx);
  constexpr int groups = 8;
  double sum = 0;
  for (int group = 0; group < groups; ++group)
  {
    const int begin = group * grid.ny / groups;
    const int end = (group + 1) * grid.ny / groups;
    const double force = pressure.middleCols(begin, end - begin).sum() * grid.cellArea();
    const double distance = std::abs(t - 0.5 * (grid.y(begin) + grid.y(end - 1)));
    sum += force * std::asinh(half_length / distance);
  }
  return sum / (std::acos(-1.0) * modulus_ * half_length);
}

bool WheelContact::boxesHold(const RigidTouch& touch)
{
  bool missed = false;
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    missed = (!patches_[k].extent.empty && missesPressure(touch, k)) || missed;
  }
  widened_ = widened_ || missed;
  if (box_cut_ || missed)
  {
    return false;
  }
  if (solution_.approach < descent_allowance * boxed_descent_)
  {
    return true;
  }
  search_.overlapZones(touch.contact.separation + solution_.approach, zones_);
  return std::all_of(zones_.begin(), zones_.end(),
                     [this](const OverlapZone& zone)
                     {
                       return std::any_of(patches_.begin(), patches_.end(),
                                          [&](const WheelPatch& patch) {
                                            return zone.u_begin < patch.zone.u_end && patch.zone.u_begin < zone.u_end;
                                          });
                     });
}

bool WheelContact::onProfiles() const
{
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    const PressureExtent& extent = patches_[k].extent;
    for (int j = extent.first_column; j <= extent.last_column; ++j)
    {
      const GapColumn& column = patches_[k].columns[static_cast<std::size_t>(j)];
      if (column.rail_u < 0 || column.rail_u > rail_->profile().length() || column.wheel_u < 0 ||
          column.wheel_u > config_.wheel_profile->length())
      {
        return false;
      }
    }
  }
  return true;
}

WheelForces WheelContact::forces() const
{
  WheelForces sum;
  const PlanePoint reference = rail_->referencePoint();
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    const WheelPatch& patch = patches_[k];
    const double force = solution_.patches[k].force;
    const double outward = force * std::sin(patch.plane.angle + std::atan(patch.slope));
    const double vertical = force * std::cos(patch.plane.angle);
    const PlanePoint place = rail_->at(railParameter(problem_.patches[k].grid, patch.columns, patch.center_y));
    sum.outward += outward;
    sum.vertical += vertical;
    sum.moment += outward * (place.z - reference.z) + vertical * (place.y - reference.y);
  }
  return sum;
}

double WheelContact::heightOverReference() const
{
  double force = 0;
  double moment = 0;
  const double reference = rail_->referencePoint().z;
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    force += solution_.patches[k].force;
    moment += solution_.patches[k].force * (patches_[k].plane.z - reference);
  }
  return force > 0 ? moment / force : 0;
}

double WheelContact::planeError() const
{
  double force = 0;
  double error = 0;
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    force += solution_.patches[k].force;
    error += solution_.patches[k].force * std::abs(patches_[k].slope);
  }
  return force > 0 ? error / force : 0;
}

double WheelContact::lever() const
{
  double vertical = 0;
  double moment = 0;
  for (std::size_t k = 0; k < patches_.size(); ++k)
  {
    const ContactPlane& plane = patches_[k].plane;
    const double share = solution_.patches[k].force * std::cos(plane.angle);
    vertical += share;
    moment += share * (plane.y - wheel_->pose().y + (plane.z - wheel_->pose().z) * std::tan(plane.angle));
  }
  return vertical > 0 ? moment / vertical : 0;
}
}  // namespace wheel_rail_contact
