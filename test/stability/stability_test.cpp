// SPDX-License-Identifier: BSD-3-Clause
#include <regex>

#include "../usual_headers.h"
#include "stability_map.h"
#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core::stability
{
namespace
{
/// Rows of a table of the page: the lines behind its head, as fields without the letters of reasons.
std::vector<std::vector<std::string>> rowsBehind(const std::string& head, const std::string& page)
{
  const std::size_t place = page.find(head);
  std::istringstream lines(place == std::string::npos ? "" : page.substr(place + head.size()));
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(lines, line) && !line.empty();)
  {
    static const std::regex letter(R"(refused \(.\))"), separator(R"( \| )");
    line = std::regex_replace(line.substr(2, line.size() - 4), letter, "refused");
    rows.emplace_back(std::sregex_token_iterator(line.begin(), line.end(), separator, -1),
                      std::sregex_token_iterator());
  }
  return rows;
}

TEST(Verdict, IsTheClassOfTheErrorAndAllowsTheNextOneOnlyCloseToTheBorder)
{
  EXPECT_EQ(Verdict::ofError(0.02).text(), "right");
  EXPECT_EQ(Verdict::ofError(0.021).text(), "error 2–10 %");
  EXPECT_EQ(Verdict::ofError(0.3).text(), "error 10–50 %");
  EXPECT_EQ(Verdict::ofError(std::numeric_limits<double>::quiet_NaN()).text(), "error > 50 %");
  EXPECT_TRUE(Verdict::ofError(0.0239).allows("right"));
  EXPECT_FALSE(Verdict::ofError(0.0241).allows("right"));
  EXPECT_TRUE(Verdict::ofError(0.081).allows("error 10–50 %"));
  EXPECT_FALSE(Verdict::ofError(0.079).allows("error 10–50 %"));
  EXPECT_FALSE(Verdict::ofError(0.3).allows("error 2–10 %"));
  EXPECT_FALSE(Verdict::ofError(0.3).allows("error > 50 %"));
  EXPECT_FALSE(Verdict::ofError(0.01).allows("refused"));
}

TEST(Verdict, RoundsANumberToEitherSideAndFlagsResultsThatAreNotRight)
{
  const Verdict range = Verdict::rounded(6.105, 0.02).with(Verdict::rounded(0.31, 0.1), "–").with("mm", " ");
  EXPECT_EQ(range.text(), "6.10–0.3 mm");
  EXPECT_TRUE(range.allows("6.12–0.3 mm"));
  EXPECT_TRUE(range.allows("6.10–0.4 mm"));
  EXPECT_FALSE(range.allows("6.08–0.3 mm"));
  EXPECT_EQ(Verdict::ofError(0.3).withFlag(0.4, 0.01).text(), "error 10–50 %, flagged");
  EXPECT_FALSE(Verdict::ofError(0.3).withFlag(0.4, 0.01).allows("error 10–50 %"));
  EXPECT_TRUE(Verdict::ofError(0.3).withFlag(0.0119, 0.01).allows("error 10–50 %"));
  EXPECT_EQ(Verdict::ofError(0.01).withFlag(0.4, 0.01).text(), "right");
  EXPECT_TRUE(Verdict::ofError(0.0239).withFlag(0.4, 0.01).allows("right"));
}

/// Fails if a text or a situation is not that of the page, or if a result is in another class than on the page. Small
/// changes of an error close to a border are allowed, so that the page need not be written again for them. The letters
/// of the reasons may differ.
TEST(StabilityPage, HasTheTextsSituationsClassesAndReasonsOfTheComputedTables)
{
  std::ifstream file(STABILITY_PAGE);
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  const std::regex title("\n## ");
  EXPECT_EQ(std::distance(std::sregex_iterator(page.begin(), page.end(), title), std::sregex_iterator()),
            static_cast<std::ptrdiff_t>(stabilityMaps().size()));
  for (const MapTable& table : stabilityMaps())
  {
    const auto rows = rowsBehind(headOf(table), page);
    ASSERT_EQ(rows.size(), table.rows.size()) << "text, columns or rows differ: " << table.title;
    for (std::size_t r = 0; r < rows.size(); ++r)
    {
      const MapRow& row = table.rows[r];
      ASSERT_EQ(rows[r].size(), 1 + row.verdicts.size()) << table.title << ", " << row.situation;
      EXPECT_EQ(rows[r][0], row.situation) << table.title;
      for (std::size_t k = 0; k < row.verdicts.size(); ++k)
      {
        const Verdict& verdict = row.verdicts[k];
        EXPECT_TRUE(verdict.allows(rows[r][1 + k]))
            << STABILITY_PAGE << ": " << table.title << ", " << row.situation << ", " << table.columns[k]
            << ": the page has \"" << rows[r][1 + k] << "\", computed is \"" << verdict.text()
            << "\". The head of the page describes how to generate it again.";
        EXPECT_TRUE(verdict.reason().empty() || page.find("| " + verdict.reason() + " |") != std::string::npos)
            << table.title << ", " << row.situation << ": " << verdict.reason();
      }
    }
  }
}

/// An error above 2 %, or no reference, is allowed only if the result is flagged, and only where the gap has features
/// that the finest grid of `auto` does not resolve: waves, and steps.
TEST(AutoMethod, IsRightRefusedOrFlaggedInEachSituation)
{
  int tables = 0;
  for (const MapTable& table : stabilityMaps())
  {
    if (table.columns.front() != toString(NormalMethod::automatic))
    {
      continue;
    }
    ++tables;
    for (const MapRow& row : table.rows)
    {
      const Verdict& verdict = row.verdicts.front();
      const auto is = [&](const char* part) { return row.situation.find(part) != std::string::npos; };
      const bool unresolved = is("_wavy,") || is("waves of") || is("step of");
      const bool flagged = verdict.text().find("flagged") != std::string::npos;
      EXPECT_TRUE(verdict.isReliable() && (unresolved || !flagged))
          << table.title << ", " << row.situation << ": " << verdict.text();
    }
  }
  EXPECT_EQ(tables, 3) << "wheelsets, conformal contacts, and gaps that differ from Hertz";
}
}  // namespace
}  // namespace wheel_rail_contact::core::stability
