// SPDX-License-Identifier: BSD-3-Clause
#include "config/parameter_tree.h"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>
#include <string>

using namespace wheel_rail_contact;

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
