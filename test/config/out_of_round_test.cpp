// SPDX-License-Identifier: BSD-3-Clause
#include "parameter_helpers.h"

using namespace wheel_rail_contact;

// The parameters wheel/left/out_of_round and wheel/right/out_of_round.
namespace
{
/// Table of a wave with an amplitude of 0.1 in steps of 10, up to `last`.
void writeTable(const std::string& name, const std::string& titles, int last)
{
  std::ofstream file(testing::TempDir() + name);
  file << titles << "\n";
  for (int angle = 0; angle <= last; angle += 10)
  {
    file << angle << ", " << 0.1 * std::sin(angle * M_PI / 180) << "\n";
  }
}

/// Deviation of the left wheel at an angle [rad].
double deviation(const std::string& yaml, double angle)
{
  const auto wheel = read(with("wheel: {left: {out_of_round: " + yaml + "}}")).model.wheelset.out_of_round;
  return wheel.left && !wheel.right ? wheel.left->at(angle, 0.46) : 0;
}
}  // namespace

TEST(OutOfRound, IsAFileHarmonicsAndFlatsOrNone)
{
  writeTable("turn.csv", "angle [deg], deviation [mm]", 360);
  writeTable("open.csv", "# angle_deg, deviation_mm", 350);
  EXPECT_NEAR(deviation("turn.csv", 0.5 * M_PI), 0.1e-3, 1e-9);
  EXPECT_NEAR(deviation("{file: open.csv, flats: [{angle: 1.57, depth: 4e-4}]}", -1.5 * M_PI), -0.3e-3, 1e-6);
  EXPECT_NEAR(deviation("{harmonics: [{order: 2, amplitude: 1e-4, phase: 0.5}]}", 1), 1e-4 * std::sin(2.5), 1e-12);
  EXPECT_NEAR(deviation("{flats: [{angle: 1, length: 0.04}]}", 1), std::sqrt(0.46 * 0.46 - 0.02 * 0.02) - 0.46, 1e-12);
  EXPECT_EQ(deviation("''", 1), 0);
}

TEST(OutOfRound, MistakesAreRefusedByTheirName)
{
  writeTable("gap.csv", "angle [deg], deviation [mm]", 300);
  writeTable("radians.csv", "angle [rad], deviation [mm]", 360);
  writeTable("unit.csv", "angle [deg], deviation", 360);
  writeTable("metres.csv", "angle [deg], deviation [m]", 360);
  std::ofstream(testing::TempDir() + "jump.csv") << "angle_deg,deviation_mm\n0,0\n50,0\n100,0\n150,0\n200,0\n250,0\n"
                                                    "300,0\n350,0\n360,0.3\n";
  const std::vector<std::array<std::string, 3>> mistakes{
      {"gap.csv", " = gap.csv: ", "a gap of 60 deg"},
      {"{file: radians.csv}", "/file = radians.csv: ", "must be one turn"},
      {"jump.csv", " = jump.csv: ", "jumps by -0.3 mm from the last row to the first one"},
      {"unit.csv", " = unit.csv: ", "unit.csv:1: column 'deviation' is missing or has no valid unit"},
      {"metres.csv", ": deviation = 0.0", "5 mm on a radius of 0.46 m"},
      {"{harmonics: [{order: 20, amplitude: 0.1}]}", "/harmonics/amplitude = 0.1", "within ±0.005 m"},
      {"{harmonics: [{order: 0, amplitude: .nan}]}", "/harmonics/amplitude = .nan", "finite"},
      {"{harmonics: [{order: 0, amplitude: 1e-4}]}", "/harmonics/order = 0", "from 1 to 100"},
      {"{harmonics: [{order: 2}]}", "/harmonics/amplitude is missing", "[m]"},
      {"{flats: [{angle: 0, width: 1}]}", "/flats/width is unknown", "depth, length"},
      {"{flats: [{angle: 0}]}", "/flats/depth is missing", "depth or length"},
      {"{flats: [{angle: 0, length: 40}]}", "/flats/length = 40", "0.29 rolling radii"}};
  for (const auto& [yaml, option, rule] : mistakes)
  {
    const std::string wheel = "wheel: {right: {out_of_round: " + yaml + "}}",
                      name = "wheel/right/out_of_round" + option;
    expectRefused({{wheel.c_str(), name.c_str(), rule.c_str()}});
  }
}
