// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/config_file.h"
#include "config/parameter_tree.h"
#include "parameter_helpers.h"

using namespace wheel_rail_contact;

// The public header of the library.
namespace
{
const ParameterSource shipped{ParameterSource::file, default_parameters};

ContactParameters readOver(const std::vector<ParameterSource>& overlays)
{
  std::vector<ParameterSource> sources{shipped};
  sources.insert(sources.end(), overlays.begin(), overlays.end());
  return readContactParameters(sources, search());
}

std::string refusalOf(const std::vector<ParameterSource>& sources, const FileSearch& where)
{
  return wheel_rail_contact::refusalOf([&] { readContactParameters(sources, where); });
}
}  // namespace

TEST(ConfigFile, LaterSourcesOverrideEarlierOnes)
{
  std::ofstream(testing::TempDir() + "tolerance.yaml") << "contact: {tolerance: 0.02, method: hertz}";
  const ContactParameters parameters =
      readOver({{ParameterSource::file, "tolerance.yaml"},
                {ParameterSource::text, "{contact: {tolerance: 0.03}, track: {distance: topic}}"}});
  EXPECT_EQ(parameters.model.contact.tolerance, 0.03);
  EXPECT_EQ(parameters.model.contact.method, core::NormalMethod::hertz);
  EXPECT_EQ(parameters.model.track.gauge, core::TrackConfig().gauge);
  EXPECT_EQ(parameters.model.wheel_profile.left->name(), "S1002");
  EXPECT_TRUE(parameters.distance_topic);
}

TEST(ConfigFile, ProfilesAloneAreEnough)
{
  const ContactParameters alone =
      readContactParameters({{ParameterSource::text, "{wheel: {profile: S1002}, rail: {profile: 60E1}}"}}, {});
  EXPECT_EQ(alone.model.rail_profile.right->name(), "60E1");
  EXPECT_EQ(alone.model.contact.tolerance, core::ContactConfig().tolerance);
}

TEST(ConfigFile, MistakesAreRefusedByName)
{
  const auto refusal = [](const std::string& text) {
    return refusalOf({shipped, {ParameterSource::text, text}}, search());
  };
  EXPECT_EQ(refusal("track: {gauge: wide}"), "parameter track/gauge = wide must be a finite number");
  EXPECT_TRUE(contains(refusal("sync: {slop: -1}"), "sync/slop = -1"));
  EXPECT_EQ(refusal("trak: {gauge: 1.435}"),
            "parameter trak/gauge is unknown; known names: contact, creep, diagnostics, markers, material, "
            "neighbour_reach, rail, "
            "rail_bending, stress, sync, track, wheel, wheelset, wheelset_places, wheelsets");
  EXPECT_TRUE(contains(refusal("track: {gauge: 1.435"), "parameters: "));
  EXPECT_TRUE(contains(refusal("wheel: {profile: missing.prw}"),
                       "wheel/profile = missing.prw: no such file: missing.prw (searched: "));
}

TEST(ConfigFile, PackagesAreFoundOnlyByTheFunction)
{
  EXPECT_EQ(refusalOf({shipped}, {}),
            std::string(default_parameters) + ": there is no ROS package 'wheel_rail_contact'");
  EXPECT_EQ(search().find("package://wheel_rail_contact/config/default.yaml"), packageFile("config/default.yaml"));
  EXPECT_EQ(search().find("config/default.yaml"), packageFile("config/default.yaml"));
  EXPECT_EQ(refusalOf({{ParameterSource::file, "package://other/a.yaml"}}, search()),
            "package://other/a.yaml: there is no ROS package 'other'");
}

TEST(ParameterTree, InvalidDocumentsAreRefused)
{
  EXPECT_THROW(parameterTree(YAML::Load("[1, 2]")), std::invalid_argument);
  EXPECT_THROW(parameterTree(YAML::Load("5")), std::invalid_argument);
  EXPECT_THROW(parameterTree(YAML::Load("{[a]: 1}")), std::invalid_argument);
  EXPECT_THROW(parameterTree(YAML::Load("{a/b: 1, a: {b: 2}}")), std::invalid_argument);
  EXPECT_THROW(parameterTree(YAML::Load("a: &a {b: *a}")), std::invalid_argument);
  std::string doubled = "g0: &g0 {a: 1}\n";
  for (int k = 1; k < 15; ++k)
  {
    const std::string before = "*g" + std::to_string(k - 1);
    doubled += "g" + std::to_string(k) + ": &g" + std::to_string(k) + " {a: " + before + ", b: " + before + "}\n";
  }
  EXPECT_THROW(parameterTree(YAML::Load(doubled)), std::invalid_argument);
  std::ofstream(testing::TempDir() + "broken.yaml") << "track: {gauge: 1.435";
  EXPECT_THROW(readParameterFile(testing::TempDir() + "broken.yaml"), std::invalid_argument);
  EXPECT_THROW(readParameterFile(testing::TempDir() + "none.yaml"), std::invalid_argument);
}
