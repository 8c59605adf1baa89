// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/operator/operator_cache.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <tuple>

namespace wheel_rail_contact::core
{
namespace
{
constexpr double aspects_per_octave = 8;
/// Relative difference below which two aspects are treated as equal. The coefficients differ by no more.
constexpr double same_aspect = 1e-9;

/// Number of operators kept for a grid whose aspects are not in the series of cell_aspect.
constexpr int others_kept = 8;

using Shared = std::shared_ptr<const InfluenceOperator>;

/// Operators that the whole process shares.
class SharedOperators
{
 public:
  Shared find(int nx, int ny, bool symmetric, int index)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return at({nx, ny, symmetric, index});
  }

 private:
  using Key = std::tuple<int, int, bool, int>;

  const Shared& at(const Key& key)
  {
    Shared& found = operators_[key];
    if (!found)
    {
      const auto [nx, ny, symmetric, index] = key;
      const Shared whole = symmetric && nx % 2 == 0 ? at({nx, ny, false, index}) : anyOf(nx, ny);
      found = std::make_shared<InfluenceOperator>(OperatorShape{nx, ny, cell_aspect::aspect(index), symmetric},
                                                  whole.get());
    }
    return found;
  }

  /// An operator of the same size, whose tables can be shared in part; null if there is none.
  Shared anyOf(int nx, int ny) const
  {
    const auto first = operators_.lower_bound({nx, ny, false, cell_aspect::lowest_index});
    const bool same_size =
        first != operators_.end() && std::get<0>(first->first) == nx && std::get<1>(first->first) == ny;
    return same_size ? first->second : nullptr;
  }

  std::mutex mutex_;
  std::map<Key, Shared> operators_;
};

SharedOperators& sharedOperators()
{
  static SharedOperators shared;
  return shared;
}

/// Finds the index of an aspect in the series of cell_aspect; false if the aspect is not in the series.
bool findInSeries(double aspect, int& index)
{
  if (!(aspect > 0))
  {
    return false;
  }
  index = cell_aspect::nearestIndex(aspect);
  return std::abs(cell_aspect::aspect(index) - aspect) <= same_aspect * aspect;
}
}  // namespace

namespace cell_aspect
{
double aspect(int index)
{
  return std::exp2(index / aspects_per_octave);
}

int indexAbove(double value)
{
  return static_cast<int>(std::ceil(aspects_per_octave * std::log2(value)));
}

int nearestIndex(double dx_over_dy)
{
  const double clamped = std::clamp(dx_over_dy, aspect(lowest_index), aspect(highest_index));
  return static_cast<int>(std::lround(aspects_per_octave * std::log2(clamped)));
}

Cell coveringCell(double length, double width, int nx, int ny)
{
  const double dx = length / nx, dy = width / ny;
  const double rounded_aspect = aspect(nearestIndex(dx / dy));
  Cell cell;
  cell.dy = std::max(dy, dx / rounded_aspect);
  cell.dx = cell.dy * rounded_aspect;
  return cell;
}
}  // namespace cell_aspect

OperatorCache::Family& OperatorCache::family(int nx, int ny, bool symmetric)
{
  for (Family& known : families_)
  {
    if (known.nx == nx && known.ny == ny && known.symmetric == symmetric)
    {
      return known;
    }
  }
  Family added;
  added.nx = nx;
  added.ny = ny;
  added.symmetric = symmetric;
  families_.push_back(std::move(added));
  return families_.back();
}

void OperatorCache::prepare(int nx, int ny)
{
  const double square = static_cast<double>(ny) / nx;
  const int last = cell_aspect::nearestIndex(longest * square);
  for (int index = cell_aspect::nearestIndex(square / widest); index <= last; ++index)
  {
    find(nx, ny, false, cell_aspect::aspect(index));
    if (nx % 2 == 0)
    {
      find(nx, ny, true, cell_aspect::aspect(index));
    }
  }
}

std::shared_ptr<const InfluenceOperator> OperatorCache::find(int nx, int ny, bool symmetric, double aspect)
{
  std::vector<Entry>& entries = family(nx, ny, symmetric).entries;
  auto at =
      std::lower_bound(entries.begin(), entries.end(), aspect * (1 - same_aspect),
                       [](const Entry& entry, double wanted) { return entry.influence->shape().aspect < wanted; });
  const bool is_new = at == entries.end() || at->influence->shape().aspect > aspect * (1 + same_aspect);
  if (is_new)
  {
    Entry added;
    int index = 0;
    added.in_series = findInSeries(aspect, index);
    if (added.in_series)
    {
      added.influence = sharedOperators().find(nx, ny, symmetric, index);
    }
    else
    {
      const InfluenceOperator* sibling = entries.empty() ? nullptr : entries.front().influence.get();
      added.influence = std::make_shared<InfluenceOperator>(OperatorShape{nx, ny, aspect, symmetric}, sibling);
    }
    at = entries.insert(at, std::move(added));
  }
  at->last_use = ++uses_;
  std::shared_ptr<const InfluenceOperator> found = at->influence;
  if (is_new)
  {
    forgetOldest(family(nx, ny, symmetric));
  }
  return found;
}

void OperatorCache::forgetOldest(Family& family)
{
  const auto others =
      std::count_if(family.entries.begin(), family.entries.end(), [](const Entry& entry) { return !entry.in_series; });
  if (others <= others_kept)
  {
    return;
  }
  const auto oldest = std::min_element(family.entries.begin(), family.entries.end(),
                                       [](const Entry& a, const Entry& b)
                                       { return a.in_series != b.in_series ? b.in_series : a.last_use < b.last_use; });
  family.entries.erase(oldest);
}
}  // namespace wheel_rail_contact::core
