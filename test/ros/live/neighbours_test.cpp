// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <ros/package.h>

#include "contact_client.h"
#include "ros/node/conversions.h"
#include "ros/parameters/compliance_table_file.h"

using namespace wheel_rail_contact;

namespace
{
constexpr double inclination = 0.025;

core::RailForce forceOf(const core::RailResult& rail)
{
  return {rail.lateral_force, rail.vertical_force, rail.moment};
}

/// Two wheelsets 2.5 m apart, and one by itself that gets the inputs of the one behind.
class LiveNeighbours : public testing::Test
{
 protected:
  /// Wheelset behind and its double at the same place. @return the answer of the first
  core::WheelsetResult askBehind(double y, const ros::Time& stamp)
  {
    const auto pose = ContactClient::pose(y, stamp);
    const auto load = ContactClient::load(-200e3, stamp);
    const auto behind = behind_.ask(pose, load), alone = alone_.ask(pose, load);
    EXPECT_TRUE(behind && alone);
    alone_result_ = alone ? fromMessage(*alone) : core::WheelsetResult();
    return behind ? fromMessage(*behind) : core::WheelsetResult();
  }

  /// What bends a rail of an answer beside its own forces.
  core::RailDeflection offsetOf(const core::RailResult& rail) const
  {
    const core::RailDeflection own = deflectionInTrack(file_.table, forceOf(rail), inclination);
    return {rail.deflection.lateral - own.lateral, rail.deflection.vertical - own.vertical,
            rail.deflection.roll - own.roll};
  }

  const ComplianceTableFile file_ =
      readComplianceTable(ros::package::getPath("wheel_rail_contact") + "/config/rails/pads_10_25.yaml");
  ContactClient front_{"/front", "/front/contact_node"};
  ContactClient behind_{"/behind", "/behind/contact_node"};
  ContactClient alone_{"/alone", "/alone/contact_node"};
  core::WheelsetResult alone_result_;
};

void expectSameRails(const core::WheelsetResult& a, const core::WheelsetResult& b)
{
  ASSERT_EQ(a.status, core::ContactStatus::ok) << a.reason;
  for (std::size_t side = 0; side < 2; ++side)
  {
    EXPECT_EQ(a.rail[side].deflection.lateral, b.rail[side].deflection.lateral);
    EXPECT_EQ(a.rail[side].deflection.vertical, b.rail[side].deflection.vertical);
    EXPECT_EQ(a.rail[side].deflection.roll, b.rail[side].deflection.roll);
  }
}
}  // namespace

// The front wheelset runs at its left flange, so that its two rails bend differently. Deflection and forces of an
// answer fit the table to rounding; 1e-6 of the greatest influence is left for it.
TEST_F(LiveNeighbours, ForcesOfTheOtherWheelsetBendTheRailsByTheTablesInfluence)
{
  expectSameRails(askBehind(1e-3, ContactClient::nextStamp()), alone_result_);

  const auto front = front_.ask(6.5e-3);
  ASSERT_TRUE(front);
  ASSERT_EQ(front->status, WheelsetContact::OK) << front->status_text;
  const core::WheelsetResult forces = fromMessage(*front);
  const core::ComplianceTable& influence = file_.neighbours.at(1).influence;
  ASSERT_EQ(file_.neighbours.at(1).distance, 2.5);

  // The answer reaches the wheelset behind a moment before or after it reaches this program.
  core::WheelsetResult behind;
  const auto is_told = [&] { return std::abs(offsetOf(behind.rail[0]).lateral) > 1e-5; };
  for (int i = 0; i < 20 && !is_told(); ++i)
  {
    behind = askBehind(1e-3, ContactClient::nextStamp());
  }
  ASSERT_TRUE(is_told());
  for (std::size_t side = 0; side < 2; ++side)
  {
    SCOPED_TRACE(side == 0 ? "left" : "right");
    const core::RailDeflection found = offsetOf(behind.rail[side]);
    const core::RailDeflection wanted = deflectionInTrack(influence, forceOf(forces.rail[side]), inclination);
    EXPECT_NEAR(found.lateral, wanted.lateral, 1e-9);
    EXPECT_NEAR(found.vertical, wanted.vertical, 1e-9);
    EXPECT_NEAR(found.roll, wanted.roll, 1e-8);
    const core::RailDeflection nobody = offsetOf(alone_result_.rail[side]);
    EXPECT_NEAR(nobody.lateral, 0, 1e-9);
    EXPECT_NEAR(nobody.vertical, 0, 1e-9);
    EXPECT_NEAR(nobody.roll, 0, 1e-8);
    RecordProperty(side == 0 ? "left" : "right",
                   std::to_string(1e6 * wanted.lateral) + " um, " + std::to_string(1e3 * wanted.roll) + " mrad");
  }
  EXPECT_GT(std::abs(offsetOf(behind.rail[0]).lateral - offsetOf(behind.rail[1]).lateral), 1e-5);

  const std::string lacking = "answers that lack a neighbour's forces";
  const int lacked = std::stoi(nextReport("/behind/contact_node").values[lacking]);
  EXPECT_GE(lacked, 1) << "the first one";
  expectSameRails(askBehind(1e-3, front->header.stamp + ros::Duration(1.5)), alone_result_);
  EXPECT_EQ(std::stoi(nextReport("/behind/contact_node").values[lacking]), lacked + 1);
  EXPECT_EQ(nextReport("/alone/contact_node").values[lacking], "0");
}
