// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "wheel_rail_contact/core/profile_reader.h"

namespace wheel_rail_contact::core
{
namespace
{

TEST(StandardProfiles, EachNameOfTheListsOpensTheProfileOfThatName)
{
  for (const ProfileKind kind : {ProfileKind::wheel, ProfileKind::rail})
  {
    const std::vector<std::string> names = standardProfileNames(kind);
    EXPECT_GE(names.size(), kind == ProfileKind::wheel ? 1U : 2U);
    for (const std::string& name : names)
    {
      EXPECT_EQ(loadProfile(name, kind).name(), name);
    }
  }
  EXPECT_EQ(standardProfileNames(ProfileKind::rail_section), standardProfileNames(ProfileKind::rail));
}

TEST(StandardProfiles, MessageOnAnUnknownNameListsAllOfThem)
{
  try
  {
    loadProfile("61E1", ProfileKind::rail);
    FAIL();
  }
  catch (const FileError& error)
  {
    for (const ProfileKind kind : {ProfileKind::wheel, ProfileKind::rail})
    {
      for (const std::string& name : standardProfileNames(kind))
      {
        EXPECT_NE(error.reason().find(name), std::string::npos) << name;
      }
    }
  }
}

/// Names in the first column of the tables of a page, in order: `NAME`, or several of them.
std::vector<std::string> namesInTables(const std::string& page)
{
  std::ifstream lines(page);
  std::vector<std::string> names;
  std::string line;
  while (std::getline(lines, line))
  {
    std::istringstream column(line.rfind("| `", 0) == 0 ? line.substr(2, line.find('|', 2) - 2) : "");
    std::string name;
    while (std::getline(column, name, '`') && std::getline(column, name, '`'))
    {
      names.push_back(name);
    }
  }
  return names;
}

TEST(StandardProfiles, PageOfTheDocumentationListsEachOfThemOnce)
{
  std::vector<std::string> names = standardProfileNames(ProfileKind::wheel);
  const std::vector<std::string> rails = standardProfileNames(ProfileKind::rail);
  names.insert(names.end(), rails.begin(), rails.end());
  EXPECT_EQ(namesInTables("../doc/standard_profiles.md"), names);
}
}  // namespace
}  // namespace wheel_rail_contact::core
