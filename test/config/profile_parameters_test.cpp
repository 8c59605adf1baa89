// SPDX-License-Identifier: BSD-3-Clause
// Options of profile files: profile: {file, unit, y, z, origin, shift, rotate, mirror, smoothing}.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <string>

#include "parameter_helpers.h"
#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact
{
namespace
{
/// Writes points of a profile [m], after a change, without titles.
void writePoints(const std::string& name, const core::Profile& profile,
                 const std::function<void(double&, double&)>& change)
{
  std::ofstream file(testing::TempDir() + name);
  file.precision(12);
  for (int i = 0; i <= 400; ++i)
  {
    const core::CurvePoint p = profile.at(profile.length() * i / 400);
    double y = p.y, z = p.z;
    change(y, z);
    file << y << " " << z << "\n";
  }
}

class ProfileParameters : public testing::Test
{
 protected:
  ProfileParameters()
  {
    writePoints("down.txt", core::s1002Wheel(),
                [](double& y, double& z)
                {
                  y *= -1e3;
                  z *= -1e3;
                });
    writePoints("back.txt", core::s1002Wheel(),
                [](double& y, double& z)
                {
                  y += 0.07;
                  z += 0.3;
                });
  }
};
}  // namespace

TEST_F(ProfileParameters, TellWhatAFileDoesNotState)
{
  const NodeConfig config = read(with("wheel: {profile: {file: down.txt, unit: mm, y: inward, z: down}}"));
  EXPECT_NEAR(config.model.wheel_profile.left->at(0).y, -0.07, 1e-9);
  EXPECT_NEAR(config.model.wheel_profile.left->at(0).z, core::s1002Wheel().at(0).z, 1e-9);
  ASSERT_EQ(config.notes.size(), 1U);
  EXPECT_EQ(config.notes[0].substr(0, 70), "wheel/profile/file = down.txt: table, 401 points, unit mm, y inward, z");
}

TEST_F(ProfileParameters, PlaceTheOrigin)
{
  const NodeConfig config =
      read(with("wheel: {profile: {file: back.txt, unit: m, y: outward, z: up, origin: flange_back}}"));
  EXPECT_NEAR(config.model.wheel_profile.left->at(0).y, -0.07, 1e-9);
  const NodeConfig shifted =
      read(with("wheel: {profile: {file: back.txt, unit: m, y: outward, z: up, shift: {y: -0.07, z: -0.3}}}"));
  EXPECT_NEAR(shifted.model.wheel_profile.left->at(0).z, core::s1002Wheel().at(0).z, 1e-9);
}

TEST_F(ProfileParameters, SmoothingIsInMicrometres)
{
  const auto note = [](const std::string& smoothing)
  {
    return read(with("wheel: {profile: {file: down.txt, unit: mm, y: inward, z: down, smoothing: " + smoothing + "}}"))
        .notes[0];
  };
  EXPECT_NE(note("5").find("smoothed for 5 um"), std::string::npos) << note("5");
  EXPECT_NE(note("0").find("not smoothed"), std::string::npos) << note("0");
}

TEST_F(ProfileParameters, OfOneSideLeaveTheOtherAsItIs)
{
  const NodeConfig config = read(with("wheel: {left: {profile: {file: down.txt, unit: mm, y: inward, z: down}}}"));
  EXPECT_EQ(config.model.wheel_profile.left->name(), "down.txt");
  EXPECT_EQ(config.model.wheel_profile.right->name(), "S1002");
  EXPECT_NE(config.notes.at(0).find("wheel/left/profile/file"), std::string::npos);
}

TEST_F(ProfileParameters, MistakesAreNamed)
{
  const std::pair<const char*, const char*> mistakes[] = {
      {"wheel: {profile: {file: down.txt}}", "does not state its unit, y, z"},
      {"wheel: {profile: {file: down.txt, unit: furlong}}", "wheel/profile/unit"},
      {"wheel: {profile: {file: down.txt, y: left}}", "wheel/profile/y"},
      {"wheel: {profile: {file: down.txt, z: 1}}", "wheel/profile/z"},
      {"wheel: {profile: {file: down.txt, origin: centre}}", "wheel/profile/origin"},
      {"wheel: {profile: {file: down.txt, shift: {y: 70}}}", "wheel/profile/shift/y"},
      {"wheel: {profile: {file: down.txt, smoothing: 5e-6}}", "wheel/profile/smoothing"},
      {"wheel: {profile: {file: down.txt, smoothing: 200}}", "from 0.01 to 100 [um]"},
      {"wheel: {profile: {file: down.txt, units: mm}}", "wheel/profile/units"},
      {"wheel: {profile: {unit: mm}}", "wheel/profile/file"},
      {"wheel: {profile: {file: S1002, smoothing: 5}}", "apply to files"},
      {"rail: {profile: {sections: [{x: 0, file: a.csv}], origin: foot}}", "rail/profile/origin"}};
  for (const auto& [yaml, part] : mistakes)
  {
    const std::string text = refusal(with(yaml));
    EXPECT_NE(text.find(part), std::string::npos) << yaml << ": " << text;
  }
}
}  // namespace wheel_rail_contact
