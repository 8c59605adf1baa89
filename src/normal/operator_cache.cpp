// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/normal/operator_cache.h"

#include <algorithm>
#include <cmath>

#include "wheel_rail_contact/normal/aspect_ladder.h"

namespace wheel_rail_contact
{
namespace
{
/// Relative difference below which two aspects count as one; the coefficients differ by no more.
constexpr double kSameAspect = 1e-9;

/// Operators kept of a grid with aspects off the ladder.
constexpr int kOthersKept = 8;
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

void OperatorCache::prepare(int nx, int ny, bool symmetric)
{
  for (int rung = aspect_ladder::kLowest; rung <= aspect_ladder::kHighest; ++rung)
  {
    find(nx, ny, symmetric, aspect_ladder::aspect(rung));
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
    OperatorShape shape;
    shape.nx = nx;
    shape.ny = ny;
    shape.symmetric = symmetric;
    shape.kernel = kernel_;
    const double rung = aspect > 0 ? aspect_ladder::aspect(aspect_ladder::nearestRung(aspect)) : aspect;
    Entry added;
    added.on_ladder = std::abs(rung - aspect) <= kSameAspect * aspect;
    shape.aspect = added.on_ladder ? rung : aspect;
    const InfluenceOperator* sibling = entries.empty() ? nullptr : entries.front().influence.get();
    added.influence = std::make_shared<InfluenceOperator>(shape, sibling);
    at = entries.insert(at, std::move(added));
  }
  at->last_use = ++uses_;
  std::shared_ptr<const InfluenceOperator> found = at->influence;
  forgetOldest(family(nx, ny, symmetric));
  return found;
}

void OperatorCache::forgetOldest(Family& family)
{
  const auto others =
      std::count_if(family.entries.begin(), family.entries.end(), [](const Entry& entry) { return !entry.on_ladder; });
  if (others <= kOthersKept)
  {
    return;
  }
  const auto oldest = std::min_element(family.entries.begin(), family.entries.end(),
                                       [](const Entry& a, const Entry& b)
                                       { return a.on_ladder != b.on_ladder ? b.on_ladder : a.last_use < b.last_use; });
  family.entries.erase(oldest);
}
}  // namespace wheel_rail_contact
