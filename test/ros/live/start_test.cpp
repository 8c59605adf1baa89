// SPDX-License-Identifier: BSD-3-Clause
#include <sys/wait.h>

#include <csignal>

#include "../../usual_headers.h"
#include "contact_client.h"

using namespace wheel_rail_contact;

namespace
{
struct Outcome
{
  int exit_code = -1;  ///< 124 if the node did not end and was ended by its guard
  std::string output;
};

/// A contact node in a process of its own, with a name and private parameters. A guard ends it after two minutes, so
/// that a node that hangs does not block the test.
class NodeProcess
{
 public:
  NodeProcess(const std::string& name, const std::string& parameters)
      : pipe_(popen(
            ("timeout --kill-after=5 120 " CONTACT_NODE " __name:=" + name + " " + parameters + " 2>&1").c_str(), "r"))
  {
  }
  ~NodeProcess() { waitForEnd(); }
  NodeProcess(const NodeProcess&) = delete;
  NodeProcess& operator=(const NodeProcess&) = delete;

  /// Waits until the process has ended.
  Outcome waitForEnd()
  {
    Outcome outcome;
    if (pipe_ == nullptr)
    {
      return outcome;
    }
    std::array<char, 256> buffer{};
    while (fgets(buffer.data(), static_cast<int>(buffer.size()), pipe_) != nullptr)
    {
      outcome.output += buffer.data();
    }
    const int status = pclose(pipe_);
    pipe_ = nullptr;
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return outcome;
  }

 private:
  FILE* pipe_;
};

const std::string profiles = "_wheel/profile:=S1002 _rail/profile:=60E1 ";

/// The node with valid profiles and one invalid parameter must end with exit code 1 and `text` in its output.
void expectRefused(const std::string& name, const std::string& parameter, const std::string& text)
{
  const Outcome node = NodeProcess(name, profiles + parameter).waitForEnd();
  EXPECT_EQ(node.exit_code, 1) << node.output;
  EXPECT_NE(node.output.find(text), std::string::npos) << node.output;
}
}  // namespace

TEST(NodeStart, InvalidParametersEndTheProcessWithTheirNameInTheOutput)
{
  expectRefused("node_1", "_track/gauge:=wide", "/node_1/track/gauge = wide");
  expectRefused("node_2", "_track/gage:=1.435", "/node_2/track/gage is unknown");
  expectRefused("node_3", "_material/wheel/young:=-210e9", "/node_3/material/wheel/young");
  expectRefused("node_4", "_wheel/profile:=no_such_file.prw", "/node_4/wheel/profile = no_such_file.prw");
  expectRefused("node_5", "_contact/tolerance:=nan", "/node_5/contact/tolerance");
}

TEST(NodeStart, MissingProfileEndsTheProcess)
{
  const Outcome node = NodeProcess("bare", "").waitForEnd();
  EXPECT_EQ(node.exit_code, 1) << node.output;
  EXPECT_NE(node.output.find("/bare/wheel/profile is missing"), std::string::npos) << node.output;
}

TEST(NodeStart, NodeWithValidParametersRunsAndEndsWithoutErrorAtSigint)
{
  NodeProcess process("valid", profiles + "_material/wheel/young:=210e9");
  ContactClient client("/", "/valid");
  const auto result = client.request(0);
  EXPECT_TRUE(result && result->status == WheelsetContact::OK);
  ASSERT_EQ(kill(processOf("/valid"), SIGINT), 0);
  const Outcome node = process.waitForEnd();
  EXPECT_EQ(node.exit_code, 0) << node.output;
}
