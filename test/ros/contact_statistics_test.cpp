// SPDX-License-Identifier: BSD-3-Clause
#include "ros/evaluation/contact_statistics.h"
#include "../usual_headers.h"
#include "config/compliance_table_file.h"
#include "result_scene.h"
#include "ros/evaluation/contact_evaluator.h"

using namespace wheel_rail_contact;
using diagnostic_msgs::DiagnosticStatus;

namespace
{
ContactOutput resultWith(std::uint8_t status, const std::string& reason, double solve_time = 0.001)
{
  ContactOutput output;
  output.solve_time = solve_time;
  output.status = status;
  output.reason = reason;
  return output;
}

diagnostic_updater::DiagnosticStatusWrapper reportOf(const ContactStatistics& now, const ContactStatistics& before)
{
  diagnostic_updater::DiagnosticStatusWrapper report;
  diagnose(now, before, report);
  return report;
}

std::string valueOf(const diagnostic_updater::DiagnosticStatusWrapper& report, const std::string& key)
{
  for (const auto& entry : report.values)
  {
    if (entry.key == key)
    {
      return entry.value;
    }
  }
  return "no such key";
}

using Values = std::map<std::string, std::string>;

void expectReport(const ContactStatistics& now, std::uint8_t level, const Values& values = {},
                  const std::string& message = "")
{
  const auto report = reportOf(now, {});
  EXPECT_EQ(report.level, level) << report.message;
  EXPECT_TRUE(message.empty() || report.message == message) << report.message;
  for (const auto& [key, value] : values)
  {
    EXPECT_EQ(valueOf(report, key), value) << key;
  }
}

/// Statistics of some results.
ContactStatistics counted(const std::vector<ContactOutput>& outputs)
{
  ContactStatistics statistics;
  for (const ContactOutput& output : outputs)
  {
    statistics.count(output);
  }
  return statistics;
}

core::WheelsetResult withForces(double left_lateral, double left_vertical, double right_lateral, double right_vertical)
{
  core::WheelsetResult result;
  result.rail.left.lateral_force = left_lateral;
  result.rail.left.vertical_force = left_vertical;
  result.rail.right.lateral_force = right_lateral;
  result.rail.right.vertical_force = right_vertical;
  return result;
}
}  // namespace

TEST(ContactStatistics, UsableResultsAreOk)
{
  const ContactOutput lifted = resultWith(WheelsetContact::LIFT_OFF, "the left wheel carries no load", 0.003);
  expectReport(counted({resultWith(WheelsetContact::OK, ""), lifted}), DiagnosticStatus::OK,
               {{"results", "2"},
                {"results LIFT_OFF", "1"},
                {"solve time, mean [ms]", "2.000"},
                {"solve time, max [ms]", "3.000"},
                {"last reason", "the left wheel carries no load"}});
}

TEST(ContactStatistics, LoadsOfAnotherUnitOrSignWarn)
{
  core::WheelsetConfig wheelset;
  const auto doubt_of = [&wheelset](double force_z, std::uint8_t status, std::size_t count = 10)
  {
    ContactOutput output = resultWith(status, "");
    output.state.force_z = force_z;
    ContactStatistics now = counted(std::vector<ContactOutput>(count, output));
    now.load_doubt = now.loads.doubt(wheelset);
    const auto report = reportOf(now, {});
    EXPECT_EQ(report.level, now.load_doubt.empty() ? DiagnosticStatus::OK : DiagnosticStatus::WARN);
    return now.load_doubt.empty() ? "none" : report.message;
  };
  EXPECT_EQ(doubt_of(-2e5, WheelsetContact::OK), "none");
  EXPECT_EQ(doubt_of(-200, WheelsetContact::OK, 9), "none");
  EXPECT_EQ(doubt_of(-200, WheelsetContact::OK), "the mean wheel load is 100 N: loads must be in N, not in kN or t");
  EXPECT_EQ(doubt_of(2e5, WheelsetContact::LIFT_OFF).find("the mean wheel load is -100 kN, upward"), 0U);
  EXPECT_EQ(doubt_of(-2e5, WheelsetContact::LIFT_OFF), "a wheel lifts in all results: unit or sign of torque.x?");
  wheelset.rolling_radius = 0.092;  // model scale 1:5: loads are 1/25
  EXPECT_EQ(doubt_of(-100, WheelsetContact::OK), "none");
}

TEST(ContactStatistics, NoInputIsOkUnmatchedInputWarnsAndAnExceptionIsAnError)
{
  ContactStatistics now;
  expectReport(now, DiagnosticStatus::OK);
  now.pairing.received = now.pairing.waiting = 20;
  expectReport(now, DiagnosticStatus::WARN, {}, "no inputs with matching stamps");
  now.internal_errors = 1;
  expectReport(now, DiagnosticStatus::ERROR);
}

TEST(ContactStatistics, UnusableResultsWarnAndAreAnErrorIfNoneIsUsable)
{
  const ContactStatistics before = counted({resultWith(WheelsetContact::OK, "")});
  ContactStatistics now = before;
  now.count(resultWith(WheelsetContact::INVALID_INPUT, "load: force is not finite", 0));
  EXPECT_EQ(reportOf(now, before).level, DiagnosticStatus::ERROR);
  EXPECT_NE(reportOf(now, before).message.find("load: force is not finite"), std::string::npos);
  now.count(resultWith(WheelsetContact::OK, ""));
  EXPECT_EQ(reportOf(now, before).level, DiagnosticStatus::WARN);
  EXPECT_EQ(reportOf(now, now).level, DiagnosticStatus::OK) << "only the time since the last report counts";
}

TEST(ContactStatistics, DroppedInputsWarnAndAreCountedByReason)
{
  ContactStatistics now;
  now.pairing.dropped[static_cast<std::size_t>(DropReason::time_jump)] = 3;
  now.overload = 2;
  expectReport(now, DiagnosticStatus::WARN,
               {{"messages dropped: time went back", "3"}, {"inputs dropped: overload", "2"}});
}

TEST(ContactStatistics, MessagesWithoutAStampAreNamedInTheWarning)
{
  ContactStatistics now = counted({resultWith(WheelsetContact::OK, "")});
  now.pairing.dropped[static_cast<std::size_t>(DropReason::duplicate)] = 1;
  now.pairing.dropped[static_cast<std::size_t>(DropReason::unstamped)] = 4;
  expectReport(now, DiagnosticStatus::WARN, {{"messages dropped: stamp 0, which means that the stamp is unknown", "4"}},
               "4 messages dropped: their stamp is 0, which means unknown");
}

TEST(ContactStatistics, LoadsThatTheInterpolationDoesNotNeedAreCountedWithoutAWarning)
{
  ContactStatistics now = counted({resultWith(WheelsetContact::OK, "")});
  now.pairing.dropped[static_cast<std::size_t>(DropReason::unneeded)] = 9;
  expectReport(now, DiagnosticStatus::OK, {{"messages dropped: load not needed, because no pose is next to it", "9"}});
  now.pairing.dropped[static_cast<std::size_t>(DropReason::not_enclosed)] = 1;
  expectReport(now, DiagnosticStatus::WARN);
}

TEST(ContactStatistics, UnknownForcesOfANeighbourWarn)
{
  const ContactOutput known = resultWith(WheelsetContact::OK, "");
  ContactOutput lacking = known;
  lacking.lacks_neighbour = true;
  ContactStatistics now = counted({known, lacking});
  now.services.lacking_neighbour = 3;
  expectReport(
      now, DiagnosticStatus::WARN,
      {{"results that lack a neighbour's forces", "1"}, {"service results that lack a neighbour's forces", "3"}},
      "1 of 2 results lack a neighbour's forces");
}

TEST(ContactStatistics, ImplausibleWheelForceWarnsWithItsReason)
{
  ContactStatistics now;
  core::WheelsetResult result;
  ContactOutput output = resultWith(WheelsetContact::OK, "");
  output.result = unowned(result);
  now.count(output);
  EXPECT_EQ(reportOf(now, {}).level, DiagnosticStatus::OK);
  result.implausible_force = true;
  output.reason = "the left wheel carries 18 MN";
  now.count(output);
  expectReport(now, DiagnosticStatus::WARN, {{"results with an implausible wheel force", "1"}},
               "1 of 2 results with an implausible wheel force: the left wheel carries 18 MN");
}

TEST(ContactStatistics, RailBeyondTheRangeOfItsTableWarns)
{
  const std::string rail = "left rail: Y = 70.0 kN at Q = 100.0 kN";
  ContactOutput beyond = resultWith(WheelsetContact::OK, "");
  beyond.beyond_linear_range = rail;
  expectReport(
      counted({beyond, resultWith(WheelsetContact::OK, "")}), DiagnosticStatus::WARN,
      {{"results beyond the table's linear range", "1"}, {"last result beyond the table's linear range", rail}}, rail);
}

TEST(ContactStatistics, ErrorEstimateAboveTheToleranceWarns)
{
  ContactStatistics now = counted({resultWith(WheelsetContact::OK, "")});
  ContactOutput output = resultWith(WheelsetContact::OK, "the estimated error of a wheel is above contact/tolerance");
  core::WheelsetResult result;
  result.above_tolerance = true;
  output.result = unowned(result);
  now.count(output);
  expectReport(now, DiagnosticStatus::WARN,
               {{"results with an error estimate above contact/tolerance", "1"}, {"last reason", output.reason}});
}

TEST(ContactStatistics, HeldResultIsCountedAsHeldAlone)
{
  core::WheelsetResult last;
  last.above_tolerance = last.implausible_force = true;
  ContactOutput output = resultWith(WheelsetContact::OFF_PROFILE, "beyond the profile");
  output.result = unowned(last);
  output.held = true;
  const auto report = reportOf(counted({output}), {});
  EXPECT_EQ(valueOf(report, "results held"), "1");
  EXPECT_EQ(valueOf(report, "results with an error estimate above contact/tolerance"), "0");
  EXPECT_EQ(valueOf(report, "results with an implausible wheel force"), "0");
}

TEST(LinearRange, WarningGivesTheForcesOfEachRailBeyondTheRangeOfItsTable)
{
  EXPECT_EQ(linearRangeWarning(withForces(60e3, 100e3, -59e3, 100e3), 0.6), "");
  EXPECT_EQ(linearRangeWarning(withForces(0, 0, 0, 0), 0.6), "") << "wheels without a load";
  EXPECT_EQ(linearRangeWarning(withForces(9e5, 1e5, 0, 0), std::numeric_limits<double>::infinity()), "")
      << "infinite range";
  EXPECT_EQ(linearRangeWarning(withForces(0, 100e3, -70e3, 80e3), 0.6),
            "right rail: Y = -70.0 kN at Q = 80.0 kN, |Y|/Q = 0.875; its compliance table is valid up to 0.6");
  EXPECT_EQ(linearRangeWarning(withForces(50e3, 40e3, 5e3, 0), 0.6),
            "left rail: Y = 50.0 kN at Q = 40.0 kN, |Y|/Q = 1.250; its compliance table is valid up to 0.6; "
            "right rail: Y = 5.0 kN at Q = 0.0 kN, |Y|/Q = inf; its compliance table is valid up to 0.6");
  const core::WheelsetResult result = withForces(50e3, 100e3, 50e3, 100e3);
  EXPECT_EQ(linearRangeWarning(result, {0.6, 0.4}),
            "right rail: Y = 50.0 kN at Q = 100.0 kN, |Y|/Q = 0.500; its compliance table is valid up to 0.4");
  EXPECT_EQ(linearRangeWarning(result, {0.4, 0.6}),
            "left rail: Y = 50.0 kN at Q = 100.0 kN, |Y|/Q = 0.500; its compliance table is valid up to 0.4");
}
