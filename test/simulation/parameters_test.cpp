// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/parameters.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "examples/simulate_wheelset/in_process_contact.h"
#include "examples/simulate_wheelset/options.h"

namespace simulate_wheelset
{
namespace
{
/// A folder that is removed at the end.
class Scratch : public testing::Test
{
 public:
  ~Scratch() override { std::filesystem::remove_all(folder_); }

 protected:
  Scratch()
  {
    std::string name = (std::filesystem::temp_directory_path() / "simulation_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  std::string file(const std::string& text) const
  {
    std::string name = (folder_ / "file.yaml").string();
    std::ofstream(name) << text;
    return name;
  }

  std::filesystem::path folder_;
};

template <typename Function>
std::string messageOf(const Function& function)
{
  try
  {
    function();
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

using SimulationParameters = Scratch;

TEST_F(SimulationParameters, ShippedFileStatesTheDefaults)
{
  const Parameters file = readParameters("../../config/simulate_wheelset.yaml"), defaults;
  EXPECT_EQ(file.wheelset.mass, defaults.wheelset.mass);
  EXPECT_EQ(file.wheelset.yaw_inertia, defaults.wheelset.yaw_inertia);
  EXPECT_EQ(file.wheelset.spin_inertia, defaults.wheelset.spin_inertia);
  EXPECT_EQ(file.wheelset.rolling_radius, defaults.wheelset.rolling_radius);
  EXPECT_EQ(file.wheelset.axle_load, defaults.wheelset.axle_load);
  EXPECT_EQ(file.suspension.half_spacing, defaults.suspension.half_spacing);
  EXPECT_EQ(file.suspension.longitudinal_stiffness, defaults.suspension.longitudinal_stiffness);
  EXPECT_EQ(file.suspension.lateral_stiffness, defaults.suspension.lateral_stiffness);
  EXPECT_EQ(file.suspension.vertical_stiffness, defaults.suspension.vertical_stiffness);
  EXPECT_EQ(file.suspension.longitudinal_damping, defaults.suspension.longitudinal_damping);
  EXPECT_EQ(file.suspension.lateral_damping, defaults.suspension.lateral_damping);
  EXPECT_EQ(file.creep.friction, defaults.creep.friction);
  EXPECT_EQ(file.creep.shear_modulus, defaults.creep.shear_modulus);
  EXPECT_EQ(file.creep.poisson, defaults.creep.poisson);
  EXPECT_EQ(file.run.speed, defaults.run.speed);
  EXPECT_EQ(file.run.duration, defaults.run.duration);
  EXPECT_EQ(file.run.step, defaults.run.step);
  EXPECT_EQ(file.run.start, defaults.run.start);
  EXPECT_EQ(file.run.y, defaults.run.y);
  EXPECT_EQ(file.run.yaw, defaults.run.yaw);
  EXPECT_EQ(file.run.held_steps, defaults.run.held_steps);
}

TEST_F(SimulationParameters, MistakesAreRefusedByName)
{
  const auto refusal = [this](const std::string& text) { return messageOf([&] { readParameters(file(text)); }); };
  const auto contains = [](const std::string& text, const std::string& part)
  { return text.find(part) != std::string::npos; };
  EXPECT_TRUE(contains(refusal("run: {sped: 3}"), "parameter run/sped has an unknown name"));
  EXPECT_TRUE(contains(refusal("wheelset: {mass: heavy}"), "wheelset/mass = heavy must be a number"));
  EXPECT_TRUE(contains(refusal("wheelset: {mass: 0}"), "wheelset/mass = 0 must be a finite number > 0"));
  EXPECT_TRUE(contains(refusal("suspension: {lateral_damping: -1}"), "suspension/lateral_damping = -1 must be"));
  EXPECT_TRUE(contains(refusal("creep: {poisson: 0.6}"), "must be from 0 to 0.5"));
  EXPECT_TRUE(contains(refusal("run: 3"), "group run must be a map"));
  EXPECT_TRUE(contains(refusal("run: {step: 20, duration: 10}"), "run/step"));
  EXPECT_TRUE(contains(refusal("run: [\n"), "file.yaml"));
  EXPECT_TRUE(contains(messageOf([] { readParameters("missing.yaml"); }), "missing.yaml"));
}

TEST_F(SimulationParameters, CommandLineIsOverTheFile)
{
  const Options options = parseOptions({"--config", file("run: {speed: 20, step: 0.002}"), "--speed", "30"});
  const Parameters parameters = parametersOf(options);
  EXPECT_EQ(parameters.run.speed, 30);
  EXPECT_EQ(parameters.run.step, 0.002);
  EXPECT_EQ(messageOf(
                [] {
                  parseOptions({"--contact", "radio"});
                }),
            "--contact radio: must be in_process, topics or service");
  EXPECT_EQ(messageOf([] { parseOptions({"--speed", "3x"}); }), "--speed 3x: must be a number");
  EXPECT_EQ(messageOf([] { parseOptions({"--speed"}); }), "--speed: a value must follow");
  EXPECT_EQ(messageOf([] { parseOptions({"--fast", "1"}); }), "--fast: unknown option");
  EXPECT_NE(messageOf([] { parseOptions({"--contact", "topics", "--contact-config", "a.yaml"}); }), "");
  EXPECT_NE(messageOf([] { parametersOf(parseOptions({"--speed", "-1"})); }), "");
}

TEST_F(SimulationParameters, ContactParametersAreThoseOfTheNodeOrRefused)
{
  const auto config = readContactParameters(
      file("wheel: {profile: cone_1_20}\nrail: {profile: 60E2}\ntrack: {gauge: 1.437}\ncontact: {tolerance: 0.02}\n"));
  EXPECT_EQ(config.track.gauge, 1.437);
  EXPECT_EQ(config.contact.tolerance, 0.02);
  EXPECT_EQ(config.wheel_profile.left->name(), "cone_1_20");
  EXPECT_EQ(config.rail_profile.right->name(), "60E2");
  EXPECT_NE(messageOf([&] { readContactParameters(file("rail_bending: {model: none}\n")); })
                .find("parameter rail_bending/model is not supported with --contact in_process"),
            std::string::npos);
}
}  // namespace
}  // namespace simulate_wheelset
