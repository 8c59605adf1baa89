// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "stability_map.h"

namespace wheel_rail_contact::core::stability
{
namespace
{
std::vector<std::string> lines(const std::string& text)
{
  std::istringstream stream(text);
  std::vector<std::string> list;
  for (std::string line; std::getline(stream, line);)
  {
    list.push_back(line);
  }
  return list;
}

/// Each cell is solved again: a method that does better or worse than the page says shows up here.
TEST(StabilityMap, EveryVerdictIsAsThePageSays)
{
  const std::string found = stabilityPage();
  if (std::getenv("WRITE_STABILITY_PAGE") != nullptr)
  {
    std::ofstream(STABILITY_PAGE) << found;
    GTEST_SKIP() << "page written";
  }
  std::ifstream file(STABILITY_PAGE);
  std::stringstream page;
  page << file.rdbuf();
  const std::vector<std::string> expected = lines(page.str()), actual = lines(found);
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k)
  {
    EXPECT_EQ(actual[k], expected[k]) << STABILITY_PAGE << ", line " << k + 1;
  }
}

/// `method: auto` and its grids are right or refuse; on waves that the reference hardly resolves, or not, they say that
/// the error estimate is above the tolerance.
TEST(StabilityMap, AutoIsRightRefusesOrSaysThatItCannotResolveNoise)
{
  for (const MapTable* table : {&wheelsetMap(), &shapeMap()})
  {
    for (const MapRow& row : table->rows)
    {
      const std::string& verdict = row.verdicts[0];
      const bool known = verdict.rfind("off", 0) != 0 && verdict.rfind("no reference", 0) != 0;
      const bool said = verdict.find("and says so") != std::string::npos;
      const bool noisy = row.situation == "S1002 through points, y = 1 mm" ||  // 2.4 % off, estimates of 90 % and more
                         row.situation == "60E1 through points, y = 1 mm";
      EXPECT_TRUE(known || (said && noisy)) << row.situation << ": " << verdict;
    }
  }
}
}  // namespace
}  // namespace wheel_rail_contact::core::stability
