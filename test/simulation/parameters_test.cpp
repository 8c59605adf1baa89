// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/parameters.h"

#include "../temporary_folder.h"
#include "../usual_headers.h"
#include "examples/simulate_wheelset/contact_ways.h"
#include "examples/simulate_wheelset/wheelset_dynamics.h"

namespace simulate_wheelset
{
namespace
{
/// A file in a folder that is removed at the end.
class Scratch : public testing::Test
{
 protected:
  std::string file(const std::string& text) const { return folder_.write("file.yaml", text); }

  const wheel_rail_contact::Folder folder_;
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

/// Rails that never touch.
class InAir : public ContactSource
{
 public:
  ContactReply evaluate(const ContactRequest& /*request*/) override
  {
    ContactReply reply;
    reply.status = wheel_rail_contact::core::ContactStatus::ok;
    return reply;
  }
};

TEST_F(SimulationParameters, ShippedFileStatesTheDefaults)
{
  const auto values = [](const Parameters& all)
  {
    const auto& [wheelset, suspension, run] = std::tie(all.wheelset, all.suspension, all.run);
    return std::make_tuple(wheelset.mass, wheelset.yaw_inertia, wheelset.spin_inertia, wheelset.gyroscopic,
                           wheelset.line_inertia, wheelset.axle_load, suspension.half_spacing,
                           suspension.longitudinal_stiffness, suspension.lateral_stiffness,
                           suspension.vertical_stiffness, suspension.longitudinal_damping, suspension.lateral_damping,
                           run.speed, run.duration, run.step, run.start, run.y, run.yaw, run.held_steps);
  };
  EXPECT_EQ(values(readParameters("../../config/simulate_wheelset.yaml")), values({}));
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
  EXPECT_TRUE(contains(refusal("wheelset: {gyroscopic: 0.6}"), "must be 0 or 1"));
  EXPECT_TRUE(contains(refusal("run: 3"), "group run must be a map"));
  EXPECT_TRUE(contains(refusal("hello"), "the file must be a map of groups"));
  EXPECT_TRUE(contains(refusal(""), "the file must be a map of groups"));
  EXPECT_TRUE(contains(refusal("run: {held_steps: 2.5}"), "run/held_steps = 2.5 must be a whole number from 0 to"));
  EXPECT_TRUE(
      contains(refusal("run: {held_steps: 1.0e+10}"), "run/held_steps = 1e+10 must be a whole number from 0 to"));
  EXPECT_TRUE(contains(refusal("run: {duration: 1.0e+9}"), "run/duration = 1e+09 must be at most"));
  EXPECT_TRUE(contains(refusal("run: {step: 1.0e-9}"), "run/step = 1e-09 must be at least 1e-06 s"));
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
  EXPECT_EQ(messageOf(
                [] {
                  parseOptions({"--speed", "3x"});
                }),
            "the argument ('3x') for option '--speed' is invalid: must be a number");
  EXPECT_EQ(messageOf(
                [] {
                  parseOptions({"--speed", "3", "--speed", "4"});
                }),
            "option '--speed' cannot be specified more than once");
  EXPECT_EQ(messageOf([] { parseOptions({"--speed"}); }), "the required argument for option '--speed' is missing");
  EXPECT_EQ(messageOf([] { parseOptions({"--fast", "1"}); }), "unrecognised option '--fast'");
  EXPECT_EQ(messageOf([] { parseOptions({"fast"}); }), "fast: unknown option");
  EXPECT_NE(messageOf([] { parseOptions({"--contact", "topics", "--contact-config", "a.yaml"}); }), "");
  EXPECT_NE(messageOf([] { parametersOf(parseOptions({"--speed", "-1"})); }), "");
}

TEST_F(SimulationParameters, ContactParametersAreThoseOfTheNodeOrRefused)
{
  const auto config = readContact(
      file("wheel: {profile: cone_1_20}\nrail: {profile: 60E2}\ntrack: {gauge: 1.437}\ncontact: {tolerance: 0.02}\n"));
  EXPECT_EQ(config.track.gauge, 1.437);
  EXPECT_EQ(config.contact.tolerance, 0.02);
  EXPECT_EQ(config.wheel_profile.left->name(), "cone_1_20");
  EXPECT_EQ(config.rail_profile.right->name(), "60E2");
}

TEST_F(SimulationParameters, StepIsAWholeNumberOfNanoseconds)
{
  Parameters parameters;
  parameters.run.step = 1.0 / 3000;
  parameters.run.duration = 0.1;
  EXPECT_EQ(parameters.run.stepNanoseconds(), 333333);
  EXPECT_EQ(parameters.run.steps(), 301);  // 300 steps of 333333 ns end 100 ns before 0.1 s
  InAir contact;
  HeldContact held(contact, 0);
  WheelsetDynamics dynamics(parameters);
  dynamics.advance(held);
  // The rounding changes the step by 1e-6.
  const double way = dynamics.motion().y - parameters.run.y;
  EXPECT_NEAR(way / (333333e-9 * dynamics.motion().y_rate), 1, 1e-8);
}

TEST_F(SimulationParameters, MistakesInContactParametersAreRefusedByName)
{
  const auto refusal = [this](const std::string& text) { return messageOf([&] { readContact(file(text)); }); };
  EXPECT_EQ(refusal("wheelset: {free: []}"),
            "wheelset/free = [] must be [z, roll]: this program does not integrate height and roll");
  EXPECT_EQ(refusal("wheelset: {balance: wheel_loads}"),
            "wheelset/balance = wheel_loads must be moments: the load of this program is for it");
  EXPECT_NE(refusal("track: {displacement: topic}").find("track/displacement = topic"), std::string::npos);
  const std::string bending = "model: compliance, table: config/rails/pads_10_25.yaml, ";
  EXPECT_NE(refusal("rail_bending: {" + bending + "lateral_force: topic}").find("lateral_force = topic"),
            std::string::npos);
  EXPECT_NE(refusal("rail_bending: {" + bending + "neighbours: [{topic: /front, distance: 2.5}]}").find("neighbours"),
            std::string::npos);
  EXPECT_EQ(refusal("track: {gauge: wide}"), "parameter track/gauge = wide must be a finite number");
  EXPECT_NE(refusal("wheel: NOSUCH").find("parameter wheel is unknown"), std::string::npos);
  EXPECT_NE(refusal("hello").find("the document must be a map"), std::string::npos);
}
}  // namespace
}  // namespace simulate_wheelset
