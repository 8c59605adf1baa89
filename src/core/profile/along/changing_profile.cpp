// SPDX-License-Identifier: BSD-3-Clause
#include "core/profile/along/changing_profile.h"

#include <algorithm>
#include <iterator>

namespace wheel_rail_contact::core
{
/// Profile of all parts at a place. Its curves change in place.
class ChangingProfile::Composed : public Profile
{
 public:
  Composed() : Profile("rail at its place on the line") {}

  /// Takes as many sections as the curves of all parts have.
  void take(const std::vector<Piece>& pieces);
  /// Sets the curves between two sections of the rail, and the lines between two parts.
  void update(const std::vector<Piece>& pieces);
};

void ChangingProfile::Composed::take(const std::vector<Piece>& pieces)
{
  clear();
  for (const Piece& piece : pieces)
  {
    beginPart();
    const std::size_t count = piece.sections();
    for (std::size_t i = 0; i < count; ++i)
    {
      add(piece.blend ? ProfileSection{CubicSection{}, piece.blend->length(), piece.blend->errorOf(i)}
                      : piece.section->section(i));
    }
  }
  makeBuckets();
}

void ChangingProfile::Composed::update(const std::vector<Piece>& pieces)
{
  std::size_t begin = 0;
  for (const Piece& piece : pieces)
  {
    if (begin > 0)
    {
      setContinuation(begin++);
    }
    for (std::size_t i = 0; piece.blend && i < piece.sections(); ++i)
    {
      setLaw(begin + i, piece.blend->at(i, piece.share));
    }
    begin += piece.sections();
  }
  findOrigins();
}

ChangingProfile::ChangingProfile(const RailSections& sections)
    : sections_(sections), composed_(std::make_shared<Composed>())
{
}

void ChangingProfile::reserve()
{
  pieces_.reserve(sections_.parts().size());
  before_.reserve(sections_.parts().size());
  std::vector<double> places;
  for (const RailSeries& series : sections_.parts())
  {
    std::transform(series.begin(), series.end(), std::back_inserter(places),
                   [](const RailSection& section) { return section.x; });
  }
  std::sort(places.begin(), places.end());
  // Every combination of curves occurs at one of these places, or half way between two of them.
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    for (const double x : {places[i], 0.5 * (places[i] + places[std::min(i + 1, places.size() - 1)])})
    {
      if (sections_.contains(x))
      {
        moveTo(x);
        longest_ = std::max(longest_, profile_->length());
      }
    }
  }
}

bool ChangingProfile::moveTo(double x)
{
  std::swap(pieces_, before_);
  choose(x);
  const auto same_curves = [](const Piece& a, const Piece& b)
  { return a.part == b.part && a.section == b.section && a.blend == b.blend; };
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
    composed_->take(pieces_);
    profile_ = composed_;
  }
  composed_->update(pieces_);
  return true;
}

void ChangingProfile::choose(double x)
{
  pieces_.clear();
  const auto add_section = [&](std::size_t part, std::size_t index) {
    pieces_.push_back({part, index, sections_.parts()[part][index].profile.get(), nullptr, 0});
  };
  for (std::size_t part = 0; part < sections_.parts().size(); ++part)
  {
    const RailSeries& series = sections_.parts()[part];
    if (series.size() == 1)
    {
      add_section(part, 0);
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
      pieces_.push_back({part, index, nullptr, blend, share});
    }
    else
    {
      add_section(part, share < 1 ? index : index + 1);
    }
  }
}
}  // namespace wheel_rail_contact::core
