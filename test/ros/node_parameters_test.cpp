// SPDX-License-Identifier: BSD-3-Clause
#include "ros/parameters/node_parameters.h"

#include <gtest/gtest.h>

#include <string>

using namespace wheel_rail_contact;

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

TEST(NodeParameters, ParameterServerTypesAreConvertedToYaml)
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
