// SPDX-License-Identifier: BSD-3-Clause
#include "ros/parameters/parameter_tree.h"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>
#include <string>

using namespace wheel_rail_contact;

TEST(ParameterTree, NumbersOfTheParameterServerKeepTheirExactValue)
{
  for (const double value : {0.1, 1.0 / 3.0, 1.435, 2.1e11, 6.05e-8, 1e22, 1e-300, 1.7976931348623157e308})
  {
    XmlRpc::XmlRpcValue server;
    server["sync"]["slop"] = value;
    const YAML::Node tree = toYaml(server);
    EXPECT_EQ(std::stod(tree["sync"]["slop"].Scalar()), value);
  }
}

TEST(ParameterTree, ParameterServerTypesAreConvertedToYaml)
{
  XmlRpc::XmlRpcValue server;
  server["a"] = 5;
  server["b"] = "210e9";
  server["c"] = XmlRpc::XmlRpcValue(true);  // before ROS 1.15, an assignment of true stores the number 1
  server["d"][0] = "z";
  server["d"][1] = "roll";
  server["e"].setSize(0);
  const ParameterTree tree = parameterTree(toYaml(server));
  EXPECT_EQ(tree.at("a").Scalar(), "5");
  EXPECT_EQ(tree.at("b").Scalar(), "210e9");
  EXPECT_EQ(tree.at("c").Scalar(), "true");
  EXPECT_EQ(tree.at("d").size(), 2U);
  EXPECT_TRUE(tree.at("e").IsSequence());
  EXPECT_TRUE(parameterTree(toYaml(XmlRpc::XmlRpcValue())).empty());
}

TEST(ParameterTree, InvalidDocumentsAreRefused)
{
  EXPECT_THROW(parameterTree(YAML::Load("[1, 2]")), std::invalid_argument);
  EXPECT_THROW(parameterTree(YAML::Load("5")), std::invalid_argument);
  EXPECT_THROW(parameterTree(YAML::Load("{[a]: 1}")), std::invalid_argument);
  EXPECT_THROW(parameterTree(YAML::Load("{a/b: 1, a: {b: 2}}")), std::invalid_argument);
  EXPECT_THROW(parameterTree(YAML::Load("a: &a {b: *a}")), std::invalid_argument);
  std::string doubled = "g0: &g0 {a: 1}\n";
  for (int k = 1; k < 15; ++k)
  {
    const std::string before = "*g" + std::to_string(k - 1);
    doubled += "g" + std::to_string(k) + ": &g" + std::to_string(k) + " {a: " + before + ", b: " + before + "}\n";
  }
  EXPECT_THROW(parameterTree(YAML::Load(doubled)), std::invalid_argument);
  std::ofstream(testing::TempDir() + "broken.yaml") << "track: {gauge: 1.435";
  EXPECT_THROW(readParameterFile(testing::TempDir() + "broken.yaml"), std::invalid_argument);
  EXPECT_THROW(readParameterFile(testing::TempDir() + "none.yaml"), std::invalid_argument);
}
