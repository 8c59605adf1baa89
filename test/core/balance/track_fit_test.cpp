// SPDX-License-Identifier: BSD-3-Clause
// Wheelsets that do not fit their track, and models of vehicles.
#include "../profile/profile_helpers.h"
#include "wheel_rail_contact/core/profile_reader.h"
#include "wheelset_scene.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Refusal of the Manchester wheelset on its track after a change, or the remarks on it.
std::string fitAfter(const std::function<void(ContactModelConfig&)>& change)
{
  ContactModelConfig config = manchesterScene();
  change(config);
  std::string remarks;
  const auto check = [&]
  {
    for (const std::string& remark : checkFit(config))
    {
      remarks += remark;
    }
    WheelsetContact contact(config);
  };
  const std::string refusal = refusalOf<std::invalid_argument>(check);
  return refusal == "accepted" ? remarks : refusal;
}

TEST(TrackFit, DimensionsThatContradictAreRefusedOrNamed)
{
  using Config = ContactModelConfig;
  EXPECT_EQ(fitAfter([](Config&) {}), "");
  EXPECT_TRUE(contains(fitAfter([](Config& c) { c.wheelset.flange_back_distance = 1.435; }),
                       "wheelset/flange_back_distance = 1.435 m"));
  EXPECT_TRUE(contains(fitAfter([](Config& c) { c.track.gauge = 1.415; }), "must be -4 mm to 35 mm"));
  EXPECT_TRUE(contains(fitAfter([](Config& c) { c.track.gauge = 1.505; }), "must be -4 mm to 35 mm"));
  EXPECT_TRUE(contains(fitAfter([](Config& c) { c.track.gauge = 1.47; }), "usual are 0 to 20 mm"));
  for (const double tape_circle : {0.0625, 0.0778})
  {
    EXPECT_TRUE(contains(fitAfter(
                             [=](Config& c)
                             {
                               c.wheelset.tape_circle = tape_circle;
                               c.wheelset.flange_back_distance += 2 * (0.07 - tape_circle);
                             }),
                         "is 70 mm from its running circle"));
  }
  EXPECT_TRUE(contains(fitAfter([](Config& c) { c.wheelset.rolling_radius = 0.92; }), "is it the diameter"));
}

// A model is the original made smaller: the same pressures, if its loads are smaller by the square of its scale.
TEST(ModelScale, PressuresAreThoseOfTheOriginal)
{
  const Folder folder;
  const double scale = 0.2;
  ContactModelConfig original = fineScene(), model = original;
  ProfileReading reading;
  reading.scale = scale;
  const auto read = [&](const Profile& profile, ProfileKind kind, double factor, const ProfileReading& how)
  {
    const std::string path = folder.write("profile.csv", csv(scaled(pointsOf(profile), factor, factor)));
    return std::make_shared<const Profile>(readProfile(path, kind, how));
  };
  original.wheel_profile = read(s1002Wheel(), ProfileKind::wheel, 1, {});
  original.rail_profile = read(rail60E1(), ProfileKind::rail, 1, {});
  model.wheel_profile = read(s1002Wheel(), ProfileKind::wheel, scale, reading);
  model.rail_profile = read(rail60E1(), ProfileKind::rail, scale, reading);
  EXPECT_TRUE(contains(refusalOf<FileError>([&] { read(s1002Wheel(), ProfileKind::wheel, scale, {}); }),
                       "not the running circle"));
  for (double* length :
       {&model.track.gauge, &model.track.gauge_depth, &model.wheelset.rolling_radius.left,
        &model.wheelset.rolling_radius.right, &model.wheelset.flange_back_distance, &model.wheelset.tape_circle})
  {
    *length *= scale;
  }
  EXPECT_DOUBLE_EQ(modelScale(original.track, original.wheelset), 1);
  EXPECT_NEAR(modelScale(model.track, model.wheelset), scale, 1e-12);
  WheelsetContact large(original), small(model);
  for (const double y : {0.0, 3e-3})
  {
    const WheelTotal one = wheelTotal(okResult(large, stateAt(y, wheel_load)), Side::left);
    const WheelTotal other = wheelTotal(okResult(small, stateAt(scale * y, scale * scale * wheel_load)), Side::left);
    EXPECT_NEAR(other.max_pressure / one.max_pressure, 1, 0.006) << y;  // twice the tolerance
    EXPECT_NEAR(other.area / (scale * scale * one.area), 1, 0.006) << y;
  }
  for (const double load : {0.9 * plausible_force, 1.1 * plausible_force})
  {
    const bool is_implausible = load > plausible_force;
    EXPECT_EQ(large.evaluate(stateAt(0, load)).implausible_force, is_implausible);
    EXPECT_EQ(small.evaluate(stateAt(0, scale * scale * load)).implausible_force, is_implausible);
  }
}
}  // namespace
}  // namespace wheel_rail_contact::core
