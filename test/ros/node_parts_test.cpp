// SPDX-License-Identifier: BSD-3-Clause
#include <thread>

#include "../manchester_scene.h"
#include "../refusal.h"
#include "../usual_headers.h"
#include "ros/evaluation/contact_evaluator.h"
#include "ros/evaluation/contact_input.h"
#include "ros/evaluation/transform_store.h"
#include "ros/node/newest_queue.h"
#include "ros/parameters/node_parameters.h"
#include "ros/parameters/vehicle_parameters.h"

using namespace wheel_rail_contact;

TEST(ContactEvaluator, FirstStatusHasTheWarningsOfTheParameters)
{
  NodeConfig config;
  config.model = core::manchesterScene();
  config.warnings = {"one", "two"};
  ContactEvaluator evaluator(config);
  PreparedInput input;
  input.state.force_z = -2e5;
  EXPECT_EQ(evaluator.evaluate(input).reason, "one; two");
  input.resets = false;
  EXPECT_EQ(evaluator.evaluate(input).reason, "");
}

TEST(NewestQueue, KeepsTheNewestEntriesInOrderAndCountsTheOthers)
{
  NewestQueue<int> queue(3);
  for (int i = 1; i <= 5; ++i)
  {
    queue.push(i);
  }
  EXPECT_EQ(queue.pop(), 3);
  EXPECT_EQ(queue.pop(), 4);
  EXPECT_EQ(queue.pop(), 5);
  EXPECT_EQ(queue.dropped(), 2U);
}

TEST(NewestQueue, WaitingEndsWithAnEntry)
{
  NewestQueue<int> queue(1);
  EXPECT_FALSE(queue.waitForEntry(0.001));
  std::thread writer([&queue] { queue.push(1); });
  EXPECT_TRUE(queue.waitForEntry(60));
  writer.join();
  EXPECT_EQ(queue.pop(), 1) << "waiting must not remove the entry";
  queue.close();
  EXPECT_TRUE(queue.waitForEntry(60));
}

TEST(NewestQueue, ClosingEndsTheWaitingOfTheReader)
{
  NewestQueue<int> queue(1);
  std::thread reader([&queue] { EXPECT_EQ(queue.pop(), std::nullopt); });
  queue.close();
  reader.join();
  queue.push(1);
  EXPECT_EQ(queue.pop(), std::nullopt);
}

TEST(NewestQueue, EveryEntryIsDeliveredOrCounted)
{
  NewestQueue<int> queue(10);
  constexpr int count = 20000;
  int delivered = 0, last = -1;
  std::thread reader(
      [&]
      {
        while (last != count - 1)
        {
          const int entry = *queue.pop();
          EXPECT_GT(entry, last);
          last = entry;
          ++delivered;
        }
      });
  for (int i = 0; i < count; ++i)
  {
    queue.push(i);
  }
  reader.join();
  EXPECT_EQ(static_cast<std::uint64_t>(delivered) + queue.dropped(), static_cast<std::uint64_t>(count));
}

TEST(NodeParameters, NumbersOfTheParameterServerKeepTheirExactValue)
{
  for (const double value : {0.1, 1.0 / 3.0, 1.435, 2.1e11, 6.05e-8, 1e22, 1e-300, 1.7976931348623157e308})
  {
    XmlRpc::XmlRpcValue server;
    server["sync"]["slop"] = value;
    const YAML::Node tree = toYaml(server);
    EXPECT_EQ(std::stod(tree["sync"]["slop"].Scalar()), value);
  }
}

// ROS reads the name 54E1 as the number 540, and an inclination of 1:40 as 100: they are found again by these texts.
TEST(NodeParameters, NumbersThatRosMakesOfTextsHaveTheTextsOfIntegers)
{
  const std::vector<std::pair<double, std::string>> texts{{100, "100"}, {540, "540"},   {560, "560"},
                                                          {600, "600"}, {6000, "6000"}, {54000, "54000"}};
  for (const auto& [number, text] : texts)
  {
    EXPECT_EQ(toYaml(XmlRpc::XmlRpcValue(number)).Scalar(), text);
  }
}

TEST(NodeParameters, ParameterServerTypesAreConvertedToYaml)
{
  XmlRpc::XmlRpcValue server;
  server["wheel"]["profile"]["file"] = "my.csv";
  server["wheel"]["profile"]["mirror"] = XmlRpc::XmlRpcValue(true);
  server["a"] = 5;
  server["b"] = "210e9";
  server["c"] = XmlRpc::XmlRpcValue(true);  // before ROS 1.15, an assignment of true stores the number 1
  server["d"][0] = "z";
  server["d"][1] = "roll";
  server["e"].setSize(0);
  const ParameterTree tree = parameterTree(toYaml(server));
  EXPECT_EQ(tree.at("wheel/profile/file").Scalar(), "my.csv");
  EXPECT_EQ(tree.at("wheel/profile/mirror").Scalar(), "true");
  EXPECT_EQ(tree.at("a").Scalar(), "5");
  EXPECT_EQ(tree.at("b").Scalar(), "210e9");
  EXPECT_EQ(tree.at("c").Scalar(), "true");
  EXPECT_EQ(tree.at("d").size(), 2U);
  EXPECT_TRUE(tree.at("e").IsSequence());
  EXPECT_TRUE(parameterTree(toYaml(XmlRpc::XmlRpcValue())).empty());
}

namespace
{
XmlRpc::XmlRpcValue fromYaml(const YAML::Node& node)
{
  XmlRpc::XmlRpcValue value;
  node.IsSequence() ? value.setSize(0) : static_cast<void>(value);
  for (std::size_t i = 0; node.IsSequence() && i < node.size(); ++i)
  {
    value[static_cast<int>(i)] = fromYaml(node[i]);
  }
  for (auto entry = node.begin(); node.IsMap() && entry != node.end(); ++entry)
  {
    value[entry->first.Scalar()] = fromYaml(entry->second);
  }
  return node.IsScalar() ? XmlRpc::XmlRpcValue(node.Scalar()) : value;
}

/// Parameters of each wheelset as flow YAML, after its name.
std::vector<std::string> split(const std::string& yaml)
{
  std::vector<std::string> texts;
  for (const auto& wheelset :
       wheelsetParameters(fromYaml(YAML::Load(yaml)), "/vehicle/",
                          [](const std::string& name) { return "/" + name + "/vehicle/contact"; }))
  {
    YAML::Emitter text;
    text << YAML::Flow << toYaml(wheelset.values);
    texts.push_back(wheelset.name + " " + text.c_str());
  }
  return texts;
}
}  // namespace

TEST(WheelsetParameters, AreThoseOfAllWithThoseOfTheGroupAboveThem)
{
  EXPECT_TRUE(split("{contact: {method: hertz}}").empty());
  EXPECT_TRUE(split("{wheelsets: []}").empty());
  EXPECT_EQ(
      split("{wheelsets: [b, a_1], contact: {method: hertz, hold_last: 2}, a_1: {contact: {hold_last: 3}, x: 1}}"),
      (std::vector<std::string>{"b {contact: {hold_last: 2, method: hertz}}",
                                "a_1 {contact: {hold_last: 3, method: hertz}, x: 1}"}));
}

TEST(WheelsetParameters, WheelsetsWithinTheReachAreNeighboursUnlessAListIsGiven)
{
  EXPECT_EQ(split("{wheelsets: [a, b, c], wheelset_places: [4.5, 2, 0], neighbour_reach: 2,"
                  "c: {rail_bending: {neighbours: []}}}"),
            (std::vector<std::string>{"a {rail_bending: {neighbours: []}}",
                                      "b {rail_bending: {neighbours: [{distance: 2, topic: /c/vehicle/contact}]}}",
                                      "c {rail_bending: {neighbours: []}}"}));
}

TEST(WheelsetParameters, BadListsAreRefusedByName)
{
  const std::vector<std::pair<std::string, std::string>> cases{
      {"[a, b, a]", "/vehicle/wheelsets = [a, b, a] must be a list of different names: 'a' is given twice"},
      {"[a, 1b]", "'1b' is none"},
      {"[a/b]", "'a/b' is none"},
      {"front", "/vehicle/wheelsets = front must be a list of strings"},
      {"[a], wheelset_places: [0, 1]", "/vehicle/wheelset_places = [0, 1] must be [] or a list with a place for each"},
      {"[a], wheelset_places: [here]", "/vehicle/wheelset_places = [here] must be a list of finite numbers"},
      {"[a], neighbour_reach: 3", "/vehicle/neighbour_reach = 3 must be 0 without wheelset_places"},
      {"[a], wheelset_places: [0], neighbour_reach: 3, rail_bending: stiff",
       "/vehicle/rail_bending = stiff must be a group"},
      {"[a], wheelset_places: [0], neighbour_reach: 3, rail_bending: {neighbours: [{topic: x, distance: 1}]}",
       "/vehicle/rail_bending/neighbours"},
      {"[a, b], wheelset: {frame: axle}", "/vehicle/wheelset/frame"},
      {"[a, b], track: {publish_track_frame: map}", "/vehicle/track/publish_track_frame"},
      {"[a], a: 3", "/vehicle/a = 3 must be a group: the parameters of this wheelset"}};
  for (const auto& [list, message] : cases)
  {
    EXPECT_TRUE(contains(refusalOf([&, value = list] { split("{wheelsets: " + value + "}"); }), message));
  }
}

TEST(TransformStore, FarStampCostsOneTransformAndEndsNothing)
{
  TransformStore store;
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "track";
  transform.child_frame_id = "vehicle";
  transform.transform.rotation.w = 1;
  for (const std::uint32_t second : {100U, 101U, 4294967295U, 102U, 3000000000U, 103U})
  {
    transform.header.stamp = ros::Time(second, 999000000);
    store.add(transform, false);
  }
  for (const std::uint32_t second : {100U, 101U, 102U, 103U})
  {
    EXPECT_TRUE(store.canTransform("track", "vehicle", ros::Time(second, 999000000))) << second;
  }
  EXPECT_EQ(store.refused().find("2 transforms not used, the first one: transform to 'vehicle' with the stamp 42949"),
            0U)
      << store.refused();
}

TEST(WarmStartReset, OccursAtTheFirstInputAtWholeSecondsAfterTwoHundredInputsAndWhenAStampDecreases)
{
  using Places = std::vector<std::size_t>;
  const auto resets = [](const std::vector<int>& stamps)  // indices of the stamps [ms] at which it is reset
  {
    ResetRule rule;
    Places result;
    for (std::size_t i = 0; i < stamps.size(); ++i)
    {
      if (rule.resets(ros::Time(0, 0) + ros::Duration().fromNSec(std::int64_t{1000000} * stamps[i])))
      {
        result.push_back(i);
      }
    }
    return result;
  };
  EXPECT_EQ(resets({500, 700, 999, 1000, 1999, 2000, 5000}), (Places{0, 3, 5, 6}));
  EXPECT_EQ(resets({500, 700, 600, 610, 610}), (Places{0, 2})) << "not when a stamp is repeated";
  std::vector<int> stamps(450);
  std::generate(stamps.begin(), stamps.end(), [stamp = 1998]() mutable { return stamp += 2; });
  EXPECT_EQ(resets(stamps), (Places{0, 200, 400}));
  // Two evaluators that begin at different inputs have the same resets from the next whole second on.
  EXPECT_EQ(resets({100, 300, 900, 1100, 1200, 2100}), (Places{0, 3, 5}));
  EXPECT_EQ(resets({900, 1100, 1200, 2100}), (Places{0, 1, 3}));
}
