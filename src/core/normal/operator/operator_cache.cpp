// SPDX-License-Identifier: BSD-3-Clause
#include "core/normal/operator/operator_cache.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <tuple>

#include "core/normal/operator/cell_aspect.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Relative difference below which two aspects are treated as equal. The coefficients differ by no more.
constexpr double kSameAspect = 1e-9;

/// Number of operators kept for a grid whose aspects are not in the series of cell_aspect.h.
constexpr int kOthersKept = 8;

using Shared = std::shared_ptr<const InfluenceOperator>;

/// Operators that the whole process shares.
class SharedOperators
{
 public:
  Shared find(int nx, int ny, bool symmetric, int level)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return at({nx, ny, symmetric, level});
  }

 private:
  using Key = std::tuple<int, int, bool, int>;

  const Shared& at(const Key& key)
  {
    Shared& found = operators_[key];
    if (!found)
    {
      const auto [nx, ny, symmetric, level] = key;
      const Shared whole = symmetric && nx % 2 == 0 ? at({nx, ny, false, level}) : anyOf(nx, ny);
      found = std::make_shared<InfluenceOperator>(OperatorShape{nx, ny, cell_aspect::aspect(level), symmetric},
                                                  whole.get());
    }
    return found;
  }

  /// An operator of the same size, whose tables can be shared in part; null if there is none.
  Shared anyOf(int nx, int ny) const
  {
    const auto first = operators_.lower_bound({nx, ny, false, cell_aspect::kLowest});
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

/// Finds the level of an aspect; false if the aspect is not in the series.
bool roundedAspect(double aspect, int& level)
{
  if (!(aspect > 0))
  {
    return false;
  }
  level = cell_aspect::nearestAspect(aspect);
  return std::abs(cell_aspect::aspect(level) - aspect) <= kSameAspect * aspect;
}
}  // namespace

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
  const int last = cell_aspect::nearestAspect(longest * square);
  for (int level = cell_aspect::nearestAspect(square / widest); level <= last; ++level)
  {
    find(nx, ny, false, cell_aspect::aspect(level));
    if (nx % 2 == 0)
    {
      find(nx, ny, true, cell_aspect::aspect(level));
    }
  }
}

std::shared_ptr<const InfluenceOperator> OperatorCache::find(int nx, int ny, bool symmetric, double aspect)
{
  std::vector<Entry>& entries = family(nx, ny, symmetric).entries;
  auto at =
      std::lower_bound(entries.begin(), entries.end(), aspect * (1 - kSameAspect),
                       [](const Entry& entry, double wanted) { return entry.influence->shape().aspect < wanted; });
  if (at == entries.end() || at->influence->shape().aspect > aspect * (1 + kSameAspect))
  {
    Entry added;
    int level = 0;
    added.rounded_aspect = roundedAspect(aspect, level);
    if (added.rounded_aspect)
    {
      added.influence = sharedOperators().find(nx, ny, symmetric, level);
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
  forgetOldest(family(nx, ny, symmetric));
  return found;
}

void OperatorCache::forgetOldest(Family& family)
{
  const auto others = std::count_if(family.entries.begin(), family.entries.end(),
                                    [](const Entry& entry) { return !entry.rounded_aspect; });
  if (others <= kOthersKept)
  {
    return;
  }
  const auto oldest =
      std::min_element(family.entries.begin(), family.entries.end(),
                       [](const Entry& a, const Entry& b)
                       { return a.rounded_aspect != b.rounded_aspect ? b.rounded_aspect : a.last_use < b.last_use; });
  family.entries.erase(oldest);
}
}  // namespace wheel_rail_contact::core
