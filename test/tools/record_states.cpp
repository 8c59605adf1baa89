// SPDX-License-Identifier: BSD-3-Clause
// Prints the results of states of all kinds, to show that a change of the code does not change a number:
//   record_states         a line for each state, with a digest of the bits of its result; to be compared with `diff`
//   record_states SEED    all numbers of the results of one scene, to find the first that differs
// The scenes are random scenes of test/stability, varied by unequal sides, moments, stress, irregularities and
// sections.
#include "../result_numbers.h"
#include "../stability/random_scene.h"

namespace
{
using namespace wheel_rail_contact::core;
using stability::Scene;
using stability::ScenePool;
using namespace wheel_rail_contact;

constexpr unsigned long scene_count = 72;  ///< of thirty states each

/// All numbers of a result, and the stiffness of both contacts if `with_stiffness`.
/// @return its status
ContactStatus visitAll(WheelsetContact& contact, const WheelsetState& state, bool with_stiffness, const Number& number)
{
  const WheelsetResult& result = contact.evaluate(state);
  visitNumbers(result, number);
  for (const Side side : sides)
  {
    if (with_stiffness)
    {
      visitNumbers(contact.stiffness(side), "stiffness", number);
    }
  }
  return result.status;
}

/// An irregularity of each kind, over the distances of `spread`.
std::shared_ptr<const TrackLine> line()
{
  std::vector<LineStation> stations;
  for (int i = 0; i <= 20; ++i)
  {
    const double wave = (i % 7 - 3) / 3.0, other = (i % 5 - 2) / 2.0;
    LineStation station;
    station.x = 0.5 * i;
    station.cross_level = 4e-3 * other;
    station.rail = {RailDeflection{2e-3 * wave, -3e-3 * other, 2e-3 * wave},
                    RailDeflection{-1e-3 * other, 2e-3 * wave, 0}};
    stations.push_back(station);
  }
  return std::make_shared<const TrackLine>("waves", stations);
}

/// A rail that changes from one profile to another and back.
std::shared_ptr<const RailSections> changing(const ScenePool& pool)
{
  RailSeries series;
  for (int i = 0; i <= 4; ++i)
  {
    series.push_back({2.5 * i, pool.rails[i % 2 == 0 ? 0 : 1].profile, {}});
  }
  return std::make_shared<const RailSections>(std::vector<RailSeries>{series}, RailSections::Placement::gauge);
}

void makeUnequal(const ScenePool& pool, ContactModelConfig& config)
{
  config.wheel_profile.right = pool.wheels[1].profile;
  config.rail_profile.left = pool.rails[1].profile;
  config.wheelset.rolling_radius = {0.46, 0.455};
  config.wheel_material.left.young = 1.9e11;
  config.rail_material.right = Material{2.0e11, 0.3, 480e6};
  config.track.rail_inclination = {0.025, 0.05};
}

/// Places the states along the line.
void spread(Scene& scene)
{
  for (std::size_t i = 0; i < scene.states.size(); ++i)
  {
    scene.states[i].distance = 10.0 * static_cast<double>(i) / static_cast<double>(scene.states.size());
  }
}

Scene variedScene(const ScenePool& pool, unsigned long seed)
{
  Scene scene = randomScene(pool, seed);
  switch (seed % 6)
  {
    case 1:
      makeUnequal(pool, scene.config);
      break;
    case 2:
      scene.config.wheelset.balance = WheelsetConfig::Balance::moments;
      break;
    case 3:
      scene.config.stress = {8, true};
      break;
    case 4:
      scene.config.track.line = line();
      spread(scene);
      break;
    case 5:
      scene.config.rail_sections.left = changing(pool);
      spread(scene);
      break;
    default:
      break;
  }
  return scene;
}

/// Prints seed, number and status of each state of a scene, and the digest of its numbers, or these numbers themselves.
void print(const ScenePool& pool, unsigned long seed, bool all_numbers)
{
  const Scene scene = variedScene(pool, seed);
  WheelsetContact contact(scene.config);
  for (std::size_t i = 0; i < scene.states.size(); ++i)
  {
    std::string bits;
    const auto add = [&](const char* name, double value)
    {
      bits.append(reinterpret_cast<const char*>(&value), sizeof value);
      if (all_numbers)
      {
        std::printf("%s %a\n", name, value);
      }
    };
    const ContactStatus status = visitAll(contact, scene.states[i], i % 5 == 0, add);
    std::printf("%lu %zu status %d digest %016zx\n", seed, i, static_cast<int>(status), std::hash<std::string>{}(bits));
  }
}
}  // namespace

int main(int argc, char** argv)
{
  const ScenePool pool = stability::readScenePool();
  const unsigned long only = argc > 1 ? std::stoul(argv[1]) : 0;
  for (unsigned long seed = only > 0 ? only : 1; seed <= (only > 0 ? only : scene_count); ++seed)
  {
    print(pool, seed, only > 0);
  }
}
