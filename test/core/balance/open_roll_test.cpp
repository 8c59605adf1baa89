// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "wheel_rail_contact/core/profile_reader.h"
#include "wheelset_scene.h"

using namespace wheel_rail_contact::core;

namespace
{
constexpr double running_slope = 0.05;  ///< slope of the tread [-]
constexpr double fillet = 0.014;        ///< radius between tread and flank [m]
constexpr double tread_begins = -0.03;  ///< [m]

/// Conical tread, fillet and flange face of 70 degrees. Tread and flange touch a rail at distant positions.
Profile straightFlanked()
{
  constexpr double flank_length = 0.014, tread_length = 0.09;
  const double tread = std::atan(running_slope), flank = 70 * M_PI / 180;
  const double centre_y = tread_begins + fillet * std::sin(tread);
  const double centre_z = tread_begins * running_slope - fillet * std::cos(tread);
  const double begin = 0.5 * M_PI + flank;  // start angle of the arc, from its centre
  const double y = centre_y + fillet * std::cos(begin), z = centre_z + fillet * std::sin(begin);
  const double c = std::cos(flank), s = std::sin(flank);
  return {"straight flank",
          {{LineSection{y - flank_length * c, z - flank_length * s, c, s}, flank_length},
           {ArcSection{centre_y, centre_z, fillet, begin, -1}, fillet * (flank - tread)},
           {LineSection{tread_begins, tread_begins * running_slope, std::cos(tread), std::sin(tread)}, tread_length}}};
}

ContactModelConfig scene(double tolerance, int along, int across)
{
  ContactModelConfig config;
  config.wheel_profile = std::make_shared<Profile>(straightFlanked());
  config.rail_profile = std::make_shared<Profile>(rail60E1());
  config.track.rail_inclination = running_slope;
  config.contact.method = NormalMethod::conjugate_gradient;
  config.contact.tolerance = tolerance;
  config.contact.cells_along = along;
  config.contact.cells_across = across;
  return config;
}

std::vector<const PatchResult*> leftPatches(const WheelsetResult& result)
{
  std::vector<const PatchResult*> patches;
  for (const PatchResult& patch : result.patches)
  {
    if (patch.side == Side::left)
    {
      patches.push_back(&patch);
    }
  }
  return patches;
}

double difference(const PatchResult& one, const PatchResult& other)
{
  return std::max({std::abs(one.max_pressure / other.max_pressure - 1), std::abs(one.area / other.area - 1),
                   std::abs(one.approach / other.approach - 1)});
}
}  // namespace

TEST(OpenRoll, DoesNotSeparateTreadAndFlange)
{
  // With a tolerance of 0.1, a roll error of up to 3e-5 rad would be allowed for a single contact. This is 14 um of
  // lateral displacement at the rail, as much as the approach of the flange face when it begins to carry load.
  WheelsetContact loose(scene(0.1, 8, 24)), strict(scene(0.003, 24, 56));
  double worst = 0;
  int two = 0;
  for (int step = 0; step < 20; ++step)
  {
    const WheelsetState state = stateAt(10.595e-3 + 3e-6 * step, 25e3, 0.01);
    const WheelsetResult &result = loose.evaluate(state), &reference = strict.evaluate(state);
    ASSERT_EQ(result.status, ContactStatus::ok) << state.y << result.reason;
    ASSERT_EQ(reference.status, ContactStatus::ok) << state.y << reference.reason;
    const auto patches = leftPatches(result), exact = leftPatches(reference);
    ASSERT_EQ(patches.size(), exact.size()) << state.y;
    two += patches.size() == 2 ? 1 : 0;
    for (std::size_t k = 0; k < patches.size(); ++k)
    {
      const double off = difference(*patches[k], *exact[k]);
      worst = std::max(worst, off);
      EXPECT_LT(off, patches[k]->error_estimate + exact[k]->error_estimate) << state.y << ", patch " << k;
    }
  }
  EXPECT_GT(two, 10);
  EXPECT_LT(worst, 0.1);  // the tolerance
}
