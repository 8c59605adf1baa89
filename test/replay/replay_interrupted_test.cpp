// SPDX-License-Identifier: BSD-3-Clause
#include <atomic>
#include <iterator>

#include "../pairs_bag.h"
#include "../temporary_folder.h"
#include "../usual_headers.h"
#include "replay/replay.h"

using namespace wheel_rail_contact;

namespace
{
constexpr int pairs = 1500;  ///< their results fill more than one chunk

std::string contentOf(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

class ReplayInterrupted : public testing::Test
{
 protected:
  ReplayInterrupted()
  {
    writePairs(folder_.path("in.bag"), pairs, [](int i) { return 4e-6 * i; });
  }

  /// Runs a replay. @return number of results in the output after the run
  std::uint64_t run(bool resume, bool interrupted) const
  {
    ReplayOptions options;
    options.input = folder_.path("in.bag");
    options.output = folder_.path("out.bag");
    options.csv = folder_.path("out.csv");
    options.threads = 2;
    options.resume = resume;
    Replay replay(options);
    replay.run(std::atomic<bool>(interrupted));
    return replay.results();
  }

  const Folder folder_;
};
}  // namespace

// Ctrl-C arrives before the resumed run has skipped the results of the first run. All of them stay in the output.
TEST_F(ReplayInterrupted, ResumedRunInterruptedAtOnceLosesNothing)
{
  EXPECT_EQ(run(false, false), pairs);
  const std::string bag = contentOf(folder_.path("out.bag")), table = contentOf(folder_.path("out.csv"));
  ASSERT_GT(bag.size(), BagWriter::full_chunk);

  const std::uint64_t kept = run(true, true);
  EXPECT_GT(kept, 0U);
  EXPECT_LT(kept, pairs);
  const BagFile file(folder_.path("out.bag"));
  const BagContents contents = readContents(file, [](const std::string&) { return true; });
  EXPECT_EQ(contents.fault, "");
  ASSERT_EQ(contents.connections.size(), 1U);
  EXPECT_EQ(contents.messages, (std::map<std::uint32_t, std::uint64_t>{{0, kept}}));

  EXPECT_EQ(run(true, false), pairs);
  EXPECT_TRUE(contentOf(folder_.path("out.bag")) == bag);
  EXPECT_TRUE(contentOf(folder_.path("out.csv")) == table);
}
