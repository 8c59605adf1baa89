// SPDX-License-Identifier: BSD-3-Clause
#include "core/profile/changing_profile.h"

#include <algorithm>

namespace wheel_rail_contact::core
{
ChangingProfile::ChangingProfile(const RailSections& sections)
    : sections_(sections), composed_(new Profile("rail at its place on the line"))
{
  pieces_.reserve(sections.parts().size());
  before_.reserve(sections.parts().size());
  // Every combination of curves that occurs begins at one of these places: visits them once to take the memory.
  for (const RailSeries& series : sections.parts())
  {
    for (std::size_t i = 0; i < series.size(); ++i)
    {
      for (const double x : {series[i].x, 0.5 * (series[i].x + series[std::min(i + 1, series.size() - 1)].x)})
      {
        if (sections.contains(x))
        {
          moveTo(x);
          longest_ = std::max(longest_, profile_->length());
        }
      }
    }
  }
}

bool ChangingProfile::moveTo(double x)
{
  std::swap(pieces_, before_);
  choose(x);
  const auto same_curves = [](const Piece& a, const Piece& b)
  { return a.part == b.part && a.index == b.index && a.blend == b.blend; };
  const bool same = profile_ && std::equal(pieces_.begin(), pieces_.end(), before_.begin(), before_.end(), same_curves);
  const bool still = std::equal(pieces_.begin(), pieces_.end(), before_.begin(), before_.end(),
                                [](const Piece& a, const Piece& b) { return !a.blend || a.share == b.share; });
  if (same && still)
  {
    return false;
  }
  if (pieces_.size() == 1 && !pieces_.front().blend)
  {
    profile_ = sections_.parts()[0][pieces_.front().index].profile;
    return true;
  }
  if (!same || profile_ != composed_)
  {
    compose();
  }
  update();
  return true;
}

void ChangingProfile::choose(double x)
{
  pieces_.clear();
  for (std::size_t part = 0; part < sections_.parts().size(); ++part)
  {
    const RailSeries& series = sections_.parts()[part];
    if (series.size() == 1)
    {
      pieces_.push_back({part, 0, nullptr, 0});
      continue;
    }
    if (!(x >= series.front().x && x <= series.back().x))
    {
      continue;  // a further part that does not reach to this place
    }
    const auto after = std::upper_bound(series.begin() + 1, series.end() - 1, x,
                                        [](double place, const RailSection& section) { return place < section.x; });
    const auto index = static_cast<std::size_t>(after - series.begin()) - 1;
    const double share = (x - series[index].x) / (series[index + 1].x - series[index].x);
    const SectionBlend* blend = sections_.between(part, index);
    if (blend && share > 0 && share < 1)
    {
      pieces_.push_back({part, index, blend, share});
    }
    else
    {
      pieces_.push_back({part, share < 1 ? index : index + 1, nullptr, 0});
    }
  }
}

/// Makes a profile with as many sections as the curves of all parts.
void ChangingProfile::compose()
{
  composed_->clear();
  for (const Piece& piece : pieces_)
  {
    composed_->beginPart();
    if (piece.blend)
    {
      for (std::size_t i = 0; i < piece.blend->size(); ++i)
      {
        composed_->add(CubicSection{}, piece.blend->length());
      }
      continue;
    }
    const Profile& section = *sections_.parts()[piece.part][piece.index].profile;
    for (std::size_t i = 0; i < section.law_.size(); ++i)
    {
      composed_->add(section.law_[i], section.start_[i + 1] - section.start_[i]);
    }
  }
  composed_->makeBuckets();
  profile_ = composed_;
}

/// Sets the curves between two sections.
void ChangingProfile::update()
{
  auto law = composed_->law_.begin();
  for (std::size_t k = 0; k < pieces_.size(); ++k)
  {
    law += k > 0 ? 1 : 0;  // the distance of two parts
    const Piece& piece = pieces_[k];
    if (!piece.blend)
    {
      law += static_cast<long>(sections_.parts()[piece.part][piece.index].profile->law_.size());
      continue;
    }
    for (std::size_t i = 0; i < piece.blend->size(); ++i)
    {
      *law++ = piece.blend->at(i, piece.share);
    }
  }
}
}  // namespace wheel_rail_contact::core
