// SPDX-License-Identifier: BSD-3-Clause
// Prints how often the error estimate of the left wheel holds, by class, at 10, 1 and 0.3 %, against 128 x 256 cells.
#include "../core/balance/crossing_scene.h"
#include "../core/normal/gap_scenes.h"
#include "../stability/scene.h"

using namespace wheel_rail_contact::core;
/// Highest pressure, area, largest approach and force of the left wheel, and its estimate. A mean approach would jump
/// where two contacts become one.
static std::array<double, 5> valuesOf(const WheelsetResult& result)
{
  std::array<double, 5> values{};
  for (const PatchResult& patch : result.patches)
  {
    const double share = patch.side == Side::left ? 1 : 0, force = patch.normal_force;
    values = {std::max(values[0], share * patch.max_pressure), values[1] + share * patch.area,
              std::max(values[2], share * patch.approach), values[3] + share * force,
              std::max(values[4], share * patch.error_estimate)};
  }
  return values;
}

int main()
{
  const auto wheels = stability::wheelProfiles(), rails = stability::railProfiles();
  const std::array<std::string, 10> names{"tread", "two points", "corner",   "conformal", "flange",
                                          "worn",  "measured",   "crossing", "soft",      "cones"};
  constexpr double least[]{-3, 4.9, 4.2, 6.15, 6.5, -8, -8, -5, -8, -8};  // y [mm]
  constexpr double most[]{3, 5.1, 6, 6.4, 8.6, 8, 8, 5, 8, 8};
  for (std::size_t c = 0; c < names.size(); ++c)
  {
    const std::string& name = names[c];
    scenes::Random random(77);
    ContactModelConfig config = name == "crossing" ? crossing_scene::scene() : manchesterScene();
    const auto& wheel = wheels[name == "worn" ? 3 : name == "measured" ? 2 : 0].profile;
    config.wheel_profile.left = name == "cones" ? std::make_shared<const Profile>(coneWheel(0.05)) : wheel;
    config.rail_profile.left = rails[name == "worn" ? 4 : name == "measured" ? 3 : 0].profile;
    config.rail_bending.table = softPads();
    config.rail_bending.model = RailBendingConfig::Model(name == "soft" ? 2 : 0);
    config.contact = {NormalMethod::conjugate_gradient, 1e-3, 128, 256};
    WheelsetContact reference(config);
    int count[3] = {}, held[3] = {};
    for (int i = 0; i < 200; ++i)
    {
      const double y = 1e-3 * scenes::uniform(random, least[c], most[c]), load = scenes::uniform(random, 5e3, 1.5e5);
      WheelsetState state = stateAt(y, load, scenes::oneIn(random, 2) ? 0 : scenes::uniform(random, -0.02, 0.02));
      state.distance = scenes::uniform(random, 0, 0.8);
      const std::array<double, 5> truth = valuesOf(reference.evaluate(state));
      for (int k = 0; k < 3; ++k)
      {
        config.contact = {NormalMethod::automatic, std::array{0.1, 0.01, 0.003}[k]};
        const std::array<double, 5> found = valuesOf(WheelsetContact(config).evaluate(state));
        const auto error = [&](int quantity) { return std::abs(found[quantity] / truth[quantity] - 1); };
        count[k] += error(3) < 0.05 ? 1 : 0;  // else another equilibrium, or none
        held[k] += error(3) < 0.05 && std::max({error(0), error(1), error(2)}) <= found[4] ? 1 : 0;
      }
    }
    std::printf("%-10s %d/%d %d/%d %d/%d\n", name.c_str(), held[0], count[0], held[1], count[1], held[2], count[2]);
  }
}
