// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "wheel_rail_contact/core/standard_profiles.h"

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
  catch (const ProfileError& error)
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
}  // namespace
}  // namespace wheel_rail_contact::core
