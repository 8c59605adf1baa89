// SPDX-License-Identifier: BSD-3-Clause
#include "parameter_helpers.h"
#include "wheel_rail_contact/core/profile_reader.h"

using namespace wheel_rail_contact;

// Options of profile files: profile: {file, unit, y, z, origin, shift, rotate, mirror, smoothing}.
namespace
{
class ProfileParameters : public testing::Test
{
 protected:
  ProfileParameters()
  {
    writePoints("down.txt", core::s1002Wheel(), "",
                [](double& y, double& z)
                {
                  y *= -1e3;
                  z *= -1e3;
                });
    writePoints("back.txt", core::s1002Wheel(), "",
                [](double& y, double& z)
                {
                  y += 0.07;
                  z += 0.3;
                });
  }
};

TEST_F(ProfileParameters, TellWhatAFileDoesNotState)
{
  const NodeConfig config = read(with("wheel: {profile: {file: down.txt, unit: mm, y: inward, z: down}}"));
  EXPECT_NEAR(config.model.wheel_profile.left->at(0).y, -0.07, 1e-9);
  EXPECT_NEAR(config.model.wheel_profile.left->at(0).z, core::s1002Wheel().at(0).z, 1e-9);
  ASSERT_EQ(config.notes.size(), 1U);
  EXPECT_EQ(config.notes[0].substr(0, 70), "wheel/profile/file = down.txt: table, 401 points, unit mm, y inward, z");
}

TEST_F(ProfileParameters, WarnOfARailThatIsInclinedTwice)
{
  writePoints("inclined.txt", core::rail60E1(), "",
              [](double& y, double& z)
              {
                const double before = y;
                y -= 0.025 * z;
                z += 0.025 * before;
              });
  const std::string rail = "rail: {profile: {file: inclined.txt, unit: m, y: outward, z: up}}";
  const NodeConfig config = read(with(rail));
  ASSERT_EQ(config.warnings.size(), 1U);
  EXPECT_EQ(config.warnings[0],
            "rail/profile/file = inclined.txt: the file looks inclined by 1:40; rail_inclination adds 0.025 rad");
  EXPECT_EQ(config.remarks().back(), "warning: " + config.warnings[0]);
  EXPECT_TRUE(read(with("{track: {rail_inclination: 0}, " + rail + "}")).warnings.empty());
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
  expectRefused({
      {"wheel: {profile: {file: down.txt}}", "wheel/profile", "does not state its unit, y, z"},
      {"wheel: {profile: {file: down.txt, unit: furlong}}", "wheel/profile/unit", "furlong"},
      {"wheel: {profile: {file: down.txt, y: left}}", "wheel/profile/y", "left"},
      {"wheel: {profile: {file: down.txt, z: 1}}", "wheel/profile/z", "1"},
      {"wheel: {profile: {file: down.txt, origin: centre}}", "wheel/profile/origin", "centre"},
      {"wheel: {profile: {file: down.txt, shift: {y: 70}}}", "wheel/profile/shift/y", "70"},
      {"wheel: {profile: {file: down.txt, smoothing: 5e-6}}", "wheel/profile/smoothing", "5e-6"},
      {"wheel: {profile: {file: down.txt, smoothing: 200}}", "wheel/profile/smoothing", "from 0.01 to 100 [um]"},
      {"wheel: {profile: {file: down.txt, units: mm}}", "wheel/profile/units", "unknown"},
      {"wheel: {profile: {unit: mm}}", "wheel/profile/file", "missing"},
      {"wheel: {profile: {file: S1002, smoothing: 5}}", "wheel/profile/file", "apply to files"},
      {"rail: {profile: {sections: [{x: 0, file: a.csv}], origin: foot}}", "rail/profile/origin", ""},
  });
}

// Parameters of rails whose profile changes along the line.
using Placement = core::RailSections::Placement;

/// Points of a round head with its middle at `y` and its crown at `top` [mm].
std::string head(double y, double top, double z_sign, const std::string& separator)
{
  std::string text;
  for (int i = -36; i <= 36; ++i)
  {
    const double height = top - i * i / 60.0;
    text += std::to_string(y + i) + separator + std::to_string(z_sign * height) + "\n";
  }
  return text;
}

/// Files in the folder that read() takes for relative names: a.csv and b.csv, and rail.slcs with a.txt and b.txt.
class SectionParameters : public testing::Test
{
 protected:
  SectionParameters()
  {
    write("a.csv", "y_mm,z_mm\n" + head(0, 0, 1, ","));
    write("b.csv", "y_mm,z_mm\n" + head(3, 1, 1, ","));
    write("a.txt", head(0, 0, -1, " "));
    write("b.txt", head(3, 1, -1, " "));
    write("rail.slcs", "0 1000\n2\n0 0 0\n1\n-1 'a.txt'\n1 'b.txt'\n");
    write("bad.slcs", "0 1000\n2\n0 0 0\n1\n-1 'a.txt'\n-1 'b.txt'\n");
    write("apart.slcs", "0 1000\n2\n2 0 0\n1\n-1 'a.txt'\n1 'b.txt'\n-1 10 -1\n1 -1 20\n");
  }
  static void write(const std::string& name, const std::string& text)
  {
    std::ofstream(testing::TempDir() + name) << text;
  }
  static core::ContactModelConfig model(const std::string& profile)
  {
    return read(with("rail: {left: {profile: " + profile + "}}")).model;
  }
};

TEST_F(SectionParameters, SectionsAreReadInOrder)
{
  const core::ContactModelConfig config =
      model("{sections: [{x: -2, file: a.csv}, {x: 0.5, file: b.csv}, {x: 4e0, file: 60E1}]}");
  ASSERT_NE(config.rail_sections.left, nullptr);
  EXPECT_EQ(config.rail_sections.right, nullptr) << "only of this side";
  EXPECT_EQ(config.rail_profile.left, nullptr);
  EXPECT_EQ(config.rail_profile.right->name(), "60E1");
  const core::RailSections& rail = *config.rail_sections.left;
  EXPECT_EQ(rail.placement(), Placement::gauge);
  ASSERT_EQ(rail.parts().size(), 1U);
  const core::RailSeries& series = rail.parts()[0];
  ASSERT_EQ(series.size(), 3U);
  EXPECT_EQ(series[0].x, -2);
  EXPECT_EQ(series[1].x, 0.5);
  EXPECT_EQ(series[2].x, 4);
  EXPECT_EQ(series[1].profile->name(), "b.csv");
  EXPECT_EQ(series[2].profile->name(), "60E1");
}

TEST_F(SectionParameters, SlicesAreReadAndPlacedByTheirCoordinates)
{
  const core::ContactModelConfig config = model("{slices: rail.slcs}");
  const core::RailSections& rail = *config.rail_sections.left;
  EXPECT_EQ(rail.placement(), Placement::coordinates);
  ASSERT_EQ(rail.parts().at(0).size(), 2U);
  EXPECT_EQ(rail.parts()[0][1].x, 1);
  EXPECT_EQ(model("{slices: rail.slcs, placement: gauge}").rail_sections.left->placement(), Placement::gauge);
  EXPECT_EQ(model("{sections: [{x: 0, file: a.csv}], placement: coordinates}").rail_sections.left->placement(),
            Placement::coordinates);
}

TEST_F(SectionParameters, FurtherPartsAreSectionsSlicesOrOneFile)
{
  const core::ContactModelConfig config = model(
      "{file: 60E1, parts: [{slices: rail.slcs}, {file: a.csv, mirror: true}, {sections: [{x: 1, file: a.csv}, "
      "{x: 2, file: b.csv}]}]}");
  const core::RailSections& rail = *config.rail_sections.left;
  EXPECT_EQ(rail.placement(), Placement::gauge);
  ASSERT_EQ(rail.parts().size(), 4U);
  EXPECT_EQ(rail.parts()[0].at(0).profile->name(), "60E1");
  EXPECT_EQ(rail.parts()[1].size(), 2U);
  EXPECT_EQ(rail.parts()[2].size(), 1U);
  EXPECT_EQ(rail.parts()[3].at(1).x, 2);
}

TEST_F(SectionParameters, MirrorAppliesToAllFilesOfItsPart)
{
  const core::ContactModelConfig config = model(
      "{sections: [{x: 0, file: a.csv}, {x: 1, file: b.csv}], mirror: true, placement: coordinates,\n"
      " parts: [{file: b.csv}]}");
  const auto& parts = config.rail_sections.left->parts();
  EXPECT_NEAR(parts[0][1].profile->at(0).y, -0.039, 1e-12);
  EXPECT_NEAR(parts[1][0].profile->at(0).y, -0.033, 1e-12);
}

TEST_F(SectionParameters, EqualFilesAreOpenedOnce)
{
  const auto series =
      model("{sections: [{x: 0, file: 60E1}, {x: 1, file: 60E1}, {x: 2, file: a.csv}]}").rail_sections.left->parts()[0];
  EXPECT_EQ(series[0].profile, series[1].profile) << "the rail does not change between them";
  const core::ContactModelConfig both = read(with("rail: {profile: {slices: rail.slcs}}")).model;
  EXPECT_NE(both.rail_sections.left, nullptr);
  EXPECT_EQ(both.rail_sections.left, both.rail_sections.right);
}

TEST_F(SectionParameters, AProfileOfOneSideReplacesTheSectionsOfBoth)
{
  const core::ContactModelConfig config =
      read(with("rail: {profile: {slices: rail.slcs}, right: {profile: 60E1}}")).model;
  EXPECT_NE(config.rail_sections.left, nullptr);
  EXPECT_EQ(config.rail_sections.right, nullptr);
  EXPECT_EQ(config.rail_profile.right->name(), "60E1");
}

TEST_F(SectionParameters, MistakesAreRefusedByTheirName)
{
  expectRefused({
      {"rail: {profile: {placement: gauge}}", "rail/profile/placement", "together with slices, sections or parts"},
      {"rail: {profile: {file: a.csv, placement: gauge}}", "rail/profile/placement", "together with"},
      {"rail: {profile: {slices: rail.slcs, placement: middle}}", "rail/profile/placement", "gauge, coordinates"},
      {"rail: {profile: {slices: [rail.slcs]}}", "rail/profile/slices", "[rail.slcs]"},
      {"rail: {profile: {slices: none.slcs}}", "rail/profile/slices", "none.slcs"},
      {"rail: {left: {profile: {slices: bad.slcs}}}", "rail/left/profile/slices", "bad.slcs:6: the places"},
      {"rail: {left: {profile: {slices: apart.slcs}}}", "rail/left/profile", "no corresponding places"},
      {"rail: {profile: {slices: rail.slcs, mirror: 1}}", "rail/profile/mirror", "1"},
      {"rail: {profile: {slices: rail.slcs, file: a.csv}}", "rail/profile/file", "only one"},
      {"rail: {profile: {slices: rail.slcs, sections: [{x: 0, file: a.csv}]}}", "rail/profile/sections", "only one"},
      {"rail: {profile: {sections: a.csv}}", "rail/profile/sections", "a.csv"},
      {"rail: {profile: {sections: [a.csv]}}", "rail/profile/sections", "a list of groups"},
      {"rail: {profile: {sections: []}}", "rail/profile/sections", "at least one section"},
      {"rail: {profile: {sections: [{file: a.csv}]}}", "rail/profile/sections/x", "missing"},
      {"rail: {profile: {sections: [{x: 0}]}}", "rail/profile/sections/file", "missing"},
      {"rail: {profile: {sections: [{x: far, file: a.csv}]}}", "rail/profile/sections/x", "far"},
      {"rail: {profile: {sections: [{x: .nan, file: a.csv}]}}", "rail/profile/sections/x", "nan"},
      {"rail: {profile: {sections: [{x: 0, file: none.csv}]}}", "rail/profile/sections/file", "none.csv"},
      {"rail: {profile: {sections: [{x: 0, file: S1002}]}}", "rail/profile/sections/file", "belongs to a wheel"},
      {"rail: {profile: {sections: [{x: 0, file: a.csv, y: 1}]}}", "rail/profile/sections/y", "unknown"},
      {"rail: {profile: {sections: [{x: 0, file: a.csv}, {x: 0, file: b.csv}]}}", "rail/profile/sections/x",
       "greater than that of the section before"},
      {"rail: {profile: {sections: [{x: 0, file: 60E1}], mirror: true}}", "rail/profile/sections/file",
       "apply to files, not to the standard profile '60E1'"},
      {"rail: {profile: {parts: [{file: a.csv}]}}", "rail/profile/slices", "give slices, sections or file"},
      {"rail: {profile: {file: 60E1, parts: a.csv}}", "rail/profile/parts", "a list of groups"},
      {"rail: {profile: {file: 60E1, parts: [{}]}}", "rail/profile/parts/slices", "give slices, sections or file"},
      {"rail: {profile: {file: 60E1, parts: [{file: none.csv}]}}", "rail/profile/parts/file", "none.csv"},
      {"rail: {profile: {file: 60E1, parts: [{slices: none.slcs}]}}", "rail/profile/parts/slices", "none.slcs"},
      {"rail: {profile: {file: 60E1, parts: [{file: a.csv, x: 1}]}}", "rail/profile/parts/x", "unknown"},
      {"rail_bending: {neighbours: [{name: front}]}", "rail_bending/neighbours/name is unknown", "distance, topic"},
      {"rail: {profile: {file: 60E1, parts: [{profile: a.csv}]}}", "rail/profile/parts/profile is unknown",
       "file, mirror, origin, rotate, sections, shift, slices, smoothing, unit, y, z"},
      {"rail: {profile: {sections: [{x: 0, profile: a.csv}]}}", "rail/profile/sections/profile is unknown", "file, x"},
      {"rail: {profile: {file: 60E1, parts: [{sections: [{x: 0}]}]}}", "rail/profile/parts/sections/file", "missing"},
      {"wheel: {profile: {slices: rail.slcs}}", "wheel/profile/slices", "unknown"},
  });
}

TEST_F(SectionParameters, NameAndGroupExcludeEachOther)
{
  ParameterTree tree = with("rail: {profile: {slices: rail.slcs}}");
  tree["rail/profile"] = YAML::Node("60E1");
  EXPECT_TRUE(contains(refusal(tree), "rail/profile = 60E1 must be either a name or a group")) << refusal(tree);
}
}  // namespace
