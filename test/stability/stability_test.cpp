// SPDX-License-Identifier: BSD-3-Clause
#include "../usual_headers.h"
#include "stability_map.h"
#include "wheel_rail_contact/core/normal_solver.h"

namespace wheel_rail_contact::core::stability
{
namespace
{
PageEntries readPageFile()
{
  std::ifstream file(STABILITY_PAGE);
  return readPage(file);
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

TEST(StabilityPage, IsReadAsItIsWritten)
{
  const MapTable table{"Title",
                       "Text.",
                       {"one", "two"},
                       {{"first", {"right", Verdict::refused("a reason")}}, {"second", {"no contact", "flagged"}}}};
  std::stringstream page;
  writePage(page, {table});
  const PageEntries expected{
      {"Title",
       {{"first", {{"one", "right"}, {"two", "refused"}}}, {"second", {{"one", "no contact"}, {"two", "flagged"}}}}}};
  EXPECT_EQ(readPage(page), expected);
}

/// Fails if a result is in another class than on the page. Small changes of an error close to a border are allowed, so
/// that the page need not be written again for them.
TEST(StabilityPage, EachEntryIsInTheClassOfTheComputedResult)
{
  PageEntries page = readPageFile();
  for (const MapTable& table : stabilityMaps())
  {
    for (const MapRow& row : table.rows)
    {
      for (std::size_t k = 0; k < row.verdicts.size(); ++k)
      {
        const std::string written = page[table.title][row.situation][table.columns[k]];
        EXPECT_TRUE(row.verdicts[k].allows(written))
            << STABILITY_PAGE << ": " << table.title << ", " << row.situation << ", " << table.columns[k]
            << ": the page has \"" << written << "\", computed is \"" << row.verdicts[k].text()
            << "\". The head of the page describes how to generate it again.";
      }
    }
  }
}

TEST(StabilityPage, HasTheComputedSituations)
{
  const PageEntries page = readPageFile();
  ASSERT_EQ(page.size(), stabilityMaps().size());
  for (const MapTable& table : stabilityMaps())
  {
    ASSERT_EQ(page.count(table.title), 1U) << table.title;
    EXPECT_EQ(page.at(table.title).size(), table.rows.size()) << table.title;
    for (const auto& [situation, entries] : page.at(table.title))
    {
      EXPECT_EQ(entries.size(), table.columns.size()) << table.title << ", " << situation;
    }
  }
}

/// The texts of the tables and the reasons of the refusals are those of the page. The letters of the reasons may
/// differ.
TEST(StabilityPage, HasTheTextsAndReasonsOfTheComputedTables)
{
  std::ifstream file(STABILITY_PAGE);
  std::stringstream page;
  page << file.rdbuf();
  for (const MapTable& table : stabilityMaps())
  {
    EXPECT_NE(page.str().find("\n\n" + table.text + "\n\n"), std::string::npos) << table.title;
    for (const MapRow& row : table.rows)
    {
      for (const Verdict& verdict : row.verdicts)
      {
        EXPECT_TRUE(verdict.reason().empty() || page.str().find("| " + verdict.reason() + " |") != std::string::npos)
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
