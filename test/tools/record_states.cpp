// SPDX-License-Identifier: BSD-3-Clause
// Records the results of states of all kinds, to show that a change of the code does not change a number:
//   record_states write FILE     before the change: one line for each state, with a digest of the bits of its result
//   record_states compare FILE   after it: prints the states whose line differs; exit status 1 if there are any
//   record_states print SEED     all numbers of the results of one scene, to find the first that differs
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

/// Lines of a recording: seed, number and status of the state, and the digest of its numbers.
std::vector<std::string> record()
{
  const ScenePool pool = stability::readScenePool();
  std::vector<std::string> lines;
  for (unsigned long seed = 1; seed <= scene_count; ++seed)
  {
    const Scene scene = variedScene(pool, seed);
    WheelsetContact contact(scene.config);
    for (std::size_t i = 0; i < scene.states.size(); ++i)
    {
      std::string bits;
      const ContactStatus status = visitAll(contact, scene.states[i], i % 5 == 0,
                                            [&](const char*, double value)
                                            { bits.append(reinterpret_cast<const char*>(&value), sizeof value); });
      char line[80];
      std::snprintf(line, sizeof line, "%lu %zu status %d digest %016zx", seed, i, static_cast<int>(status),
                    std::hash<std::string>{}(bits));
      lines.emplace_back(line);
    }
  }
  return lines;
}

int write(const std::string& file)
{
  std::ofstream out(file);
  for (const std::string& line : record())
  {
    out << line << '\n';
  }
  out.close();
  return out ? 0 : 2;
}

int compare(const std::string& file)
{
  std::ifstream in(file);
  std::size_t different = 0, count = 0;
  for (const std::string& line : record())
  {
    std::string before;
    std::getline(in, before);
    ++count;
    if (line != before)
    {
      ++different;
      std::cout << "before " << before << "\nnow    " << line << '\n';
    }
  }
  std::string more;
  const bool shorter = static_cast<bool>(std::getline(in, more));
  std::cout << different << " of " << count << " states differ" << (shorter ? "; the recording is longer" : "") << '\n';
  return different == 0 && !shorter ? 0 : 1;
}

int print(unsigned long seed)
{
  const Scene scene = variedScene(stability::readScenePool(), seed);
  WheelsetContact contact(scene.config);
  std::printf("%s\n", scene.description.c_str());
  for (std::size_t i = 0; i < scene.states.size(); ++i)
  {
    std::printf("state %zu\n", i);
    visitAll(contact, scene.states[i], i % 5 == 0,
             [](const char* name, double value) { std::printf("%s %a\n", name, value); });
  }
  return 0;
}
}  // namespace

int main(int argc, char** argv)
{
  const std::string command = argc == 3 ? argv[1] : "";
  try
  {
    if (command == "write")
    {
      return write(argv[2]);
    }
    if (command == "compare")
    {
      return compare(argv[2]);
    }
    if (command == "print")
    {
      return print(std::stoul(argv[2]));
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << "record_states: " << error.what() << '\n';
    return 2;
  }
  std::cerr << "usage: record_states write FILE | compare FILE | print SEED\n";
  return 2;
}
