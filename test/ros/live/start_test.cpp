// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace
{
constexpr int start_time = START_TIME;  ///< in which the node is surely up [s]
constexpr int exit_time = EXIT_TIME;    ///< in which it ends [s]

struct Outcome
{
  int exit_code = -1;
  std::string output;
};

/// Runs a command of the shell to its end.
Outcome run(const std::string& command)
{
  Outcome result;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr)
  {
    return result;
  }
  std::array<char, 256> buffer{};
  while (fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr)
  {
    result.output += buffer.data();
  }
  const int status = pclose(pipe);
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

/// Starts the node with good profiles and one private parameter more. It is given 10 s to end by itself.
Outcome startNode(const std::string& parameter)
{
  static int count = 0;
  const std::string name = "node_" + std::to_string(++count);
  return run("timeout 10 " CONTACT_NODE " __name:=" + name + " _wheel/profile:=S1002 _rail/profile:=60E1 " + parameter);
}

void expectStopped(const Outcome& node, const std::string& name)
{
  EXPECT_EQ(node.exit_code, 1) << node.output;
  EXPECT_NE(node.output.find(name), std::string::npos) << node.output;
}
}  // namespace

TEST(NodeStart, MistakesInParametersEndTheProcessWithTheNameInTheOutput)
{
  expectStopped(startNode("_track/gauge:=wide"), "/node_1/track/gauge = wide");
  expectStopped(startNode("_track/gage:=1.435"), "/node_2/track/gage is unknown");
  expectStopped(startNode("_material/wheel/young:=-210e9"), "/node_3/material/wheel/young");
  expectStopped(startNode("_wheel/profile:=no_such_file.prw"), "/node_4/wheel/profile = no_such_file.prw");
  expectStopped(startNode("_contact/tolerance:=nan"), "/node_5/contact/tolerance");
}

TEST(NodeStart, MissingProfileEndsTheProcess)
{
  const Outcome node = run("timeout 10 " CONTACT_NODE " __name:=bare");
  EXPECT_EQ(node.exit_code, 1) << node.output;
  EXPECT_NE(node.output.find("/bare/wheel/profile is missing"), std::string::npos) << node.output;
}

TEST(NodeStart, GoodParametersRunUntilAskedToStopAndEndAtOnceWithoutError)
{
  const ros::WallTime start = ros::WallTime::now();
  const Outcome node =
      run("timeout --preserve-status --signal=INT " + std::to_string(start_time) +
          " " CONTACT_NODE " __name:=good _wheel/profile:=S1002 _rail/profile:=60E1 _material/wheel/young:=210e9");
  EXPECT_EQ(node.exit_code, 0) << node.output;
  EXPECT_LT((ros::WallTime::now() - start).toSec(), start_time + exit_time) << "must end at the signal";
}
