// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "core/profile/section_blend.h"
#include "wheel_rail_contact/core/rail_sections.h"

namespace wheel_rail_contact::core
{
/// Profile of a rail at a place of the line. It changes from place to place without allocating memory.
class ChangingProfile
{
 public:
  /// Prepares memory for all places. Keeps a reference to `sections`, which must outlive this.
  explicit ChangingProfile(const RailSections& sections);

  /// Moves to x [m], which RailSections::contains(). @return true if the profile is another one than before
  bool moveTo(double x);
  /// Profile at the place of the last moveTo(). Its shape changes with the next one.
  const std::shared_ptr<const Profile>& profile() const { return profile_; }
  /// Length of the longest profile, over all places [m].
  double longest() const { return longest_; }
  /// Section of the running rail at or before the place, and the share of the next one.
  std::size_t section() const { return pieces_.front().index; }
  double share() const { return pieces_.front().share; }

 private:
  /// What a part shows at the place: one of its sections, or the curves between two.
  struct Piece
  {
    std::size_t part = 0, index = 0;
    const SectionBlend* blend = nullptr;  ///< null: section `index` itself
    double share = 0;
  };

  void choose(double x);
  void compose();
  void update();

  const RailSections& sections_;
  std::vector<Piece> pieces_, before_;
  std::shared_ptr<Profile> composed_;
  std::shared_ptr<const Profile> profile_;
  double longest_ = 0;
};
}  // namespace wheel_rail_contact::core
