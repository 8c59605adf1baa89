// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "core/profile/along/section_blend.h"
#include "wheel_rail_contact/core/profile.h"

namespace wheel_rail_contact::core
{
/// Profile of a rail at a place of the line. It changes from place to place without allocating memory.
class ChangingProfile
{
 public:
  /// Keeps a reference to `sections`, which must outlive this.
  explicit ChangingProfile(const RailSections& sections);
  ChangingProfile(const ChangingProfile&) = delete;  // a copy would share the profile that changes
  ChangingProfile& operator=(const ChangingProfile&) = delete;
  ChangingProfile(ChangingProfile&&) = default;
  ChangingProfile& operator=(ChangingProfile&&) = delete;
  ~ChangingProfile() = default;

  /// Takes the memory for all places: moveTo() then allocates none.
  void reserve();
  /// Moves to x [m], which RailSections::contains(). @return true if the profile is another one than before
  bool moveTo(double x);
  /// Profile at the place of the last moveTo(). Its shape changes with the next one.
  const std::shared_ptr<const Profile>& profile() const { return profile_; }
  /// Length of the longest profile, over all places since reserve() [m].
  double longest() const { return longest_; }
  /// Section of the running rail at or before the place, and the share of the next one.
  std::size_t section() const { return pieces_.front().index; }
  double share() const { return pieces_.front().share; }

 private:
  class Composed;

  /// What a part shows at the place: one of its sections, or the curves between two.
  struct Piece
  {
    std::size_t part = 0, index = 0;
    const Profile* section = nullptr;     ///< profile of section `index`; null with a blend
    const SectionBlend* blend = nullptr;  ///< curves between section `index` and the next one; null: the section itself
    double share = 0;

    /// Number of sections of its curve.
    std::size_t sections() const { return blend ? blend->size() : section->discontinuities().size() - 1; }
  };

  void choose(double x);

  const RailSections& sections_;
  std::vector<Piece> pieces_, before_;
  std::shared_ptr<Composed> composed_;
  std::shared_ptr<const Profile> profile_;
  double longest_ = 0;
};
}  // namespace wheel_rail_contact::core
