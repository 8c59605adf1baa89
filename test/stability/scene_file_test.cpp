// SPDX-License-Identifier: BSD-3-Clause
#include "scene_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "random_scene.h"

namespace wheel_rail_contact::core::stability
{
namespace
{
std::string textOf(const Scene& scene)
{
  std::ostringstream text;
  writeScene(text, scene);
  return text.str();
}

/// Temporary file, removed by the destructor.
class TemporaryFile
{
 public:
  explicit TemporaryFile(const std::string& text)
      : path_((std::filesystem::temp_directory_path() / "scene_file_test.XXXXXX").string())
  {
    close(mkstemp(path_.data()));
    std::ofstream(path_) << text;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

Scene read(const std::string& text)
{
  return readScene(TemporaryFile(text).path());
}

void expectRefusal(const std::string& text, const std::string& message)
{
  try
  {
    read(text);
    ADD_FAILURE() << "not refused: " << message;
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
  }
}

/// The first result of a scene. A different number in the configuration or in the state changes its last digits.
WheelsetResult firstResult(const Scene& scene)
{
  return WheelsetContact(scene.config).evaluate(scene.states.front());
}

/// The twenty scenes contain profiles from points, all rail models and kinds of lateral force, and given grids.
TEST(SceneFile, GivesTheSameNumbersWhenReadBack)
{
  const ScenePool pool = readScenePool();
  for (unsigned long number = 1; number <= 20; ++number)
  {
    SCOPED_TRACE(number);
    const Scene scene = randomScene(pool, number);
    const Scene copy = read(textOf(scene));
    EXPECT_EQ(textOf(copy), textOf(scene));
    ASSERT_EQ(copy.states.size(), scene.states.size());
    for (std::size_t k = 0; k < scene.states.size(); ++k)
    {
      EXPECT_EQ(copy.states[k].y, scene.states[k].y);
      EXPECT_EQ(copy.states[k].z, scene.states[k].z);
      EXPECT_EQ(copy.states[k].yaw, scene.states[k].yaw);
      EXPECT_EQ(copy.states[k].roll, scene.states[k].roll);
      EXPECT_EQ(copy.states[k].force_z, scene.states[k].force_z);
      EXPECT_EQ(copy.states[k].torque_x, scene.states[k].torque_x);
      EXPECT_EQ(copy.states[k].rail_lateral_force, scene.states[k].rail_lateral_force);
    }
    const WheelsetResult expected = firstResult(scene), found = firstResult(copy);
    EXPECT_EQ(found.status, expected.status);
    EXPECT_EQ(found.z, expected.z);
    ASSERT_EQ(found.patches.size(), expected.patches.size());
    for (std::size_t k = 0; k < found.patches.size(); ++k)
    {
      EXPECT_EQ(found.patches[k].max_pressure, expected.patches[k].max_pressure);
    }
  }
}

TEST(SceneFile, KeepsTheOffsetOfTheRails)
{
  Scene scene = randomScene(readScenePool(), 1);
  scene.states.resize(1);
  scene.states[0].rail_displacement.right = {1.0 / 3, -2e-5, 1e-300};
  const RailDeflection offset = read(textOf(scene)).states[0].rail_displacement.right;
  EXPECT_EQ(offset.lateral, 1.0 / 3);
  EXPECT_EQ(offset.vertical, -2e-5);
  EXPECT_EQ(offset.roll, 1e-300);
}

TEST(SceneFile, IsRefusedWithTheNameOfTheWrongKey)
{
  const std::string profiles = "wheel: {profile: S1002}\nrail: {profile: 60E1}\n", states = "states: [{y: 0.001}]\n";
  EXPECT_EQ(read(profiles + states).states[0].y, 0.001);
  expectRefusal(profiles, "states is missing");
  expectRefusal(profiles + "states: []\n", "states");
  expectRefusal(profiles + "states: [{height: 1}]\n", "states/height is unknown");
  expectRefusal(profiles + "states: [{y: left}]\n", "states/y = left must be a finite number");
  expectRefusal("rail: {profile: 60E1}\n" + states, "wheel/profile is missing");
  expectRefusal(profiles + states + "contact: {methods: auto}\n", "contact/methods is unknown");
  expectRefusal(profiles + states + "rail_bending: {model: compliance}\n", "lateral_lateral is missing");
}
}  // namespace
}  // namespace wheel_rail_contact::core::stability
