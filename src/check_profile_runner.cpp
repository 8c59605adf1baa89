// SPDX-License-Identifier: BSD-3-Clause
// The calculations of the command check_profile for one file. The command draws the picture from the tables in OUT.
//   check_profile_runner OUT KIND FILE OPTIONS [CLEAN.csv]
// KIND is wheel, rail or content. OPTIONS is a YAML map as the group `profile` of a parameter file, without `file`.
#include <csignal>
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "profile_check/checked_profile.h"
#include "profile_check/clean_table.h"
#include "profile_check/tables.h"
#include "profile_check/text.h"
#include "ros/parameters/profile_parameters.h"

namespace
{
using namespace wheel_rail_contact;

constexpr std::size_t least_arguments = 4, clean_table = 4;

void run(const std::vector<std::string>& arguments)
{
  const std::string &kind = arguments[1], &file = arguments[2];
  const auto stated = kind == "wheel"  ? std::optional(core::ProfileKind::wheel)
                      : kind == "rail" ? std::optional(core::ProfileKind::rail)
                                       : std::nullopt;
  const core::profile_check::CheckedProfile checked =
      core::profile_check::checkedProfile(file, stated, readProfileOptions(parameterTree(YAML::Load(arguments[3]))));
  std::cout << core::profile_check::textOf(file, checked);
  core::profile_check::writeTables(checked, arguments[0]);
  if (arguments.size() > clean_table)
  {
    const std::string note = core::profile_check::writeCleanTable(file, checked, arguments[clean_table]);
    std::cout << (note.empty() ? "" : "  " + note + '\n');
  }
}
}  // namespace

int main(int argc, char** argv)
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() < least_arguments)
  {
    std::cerr << "usage: check_profile_runner OUT KIND FILE OPTIONS [CLEAN.csv]\n";
    return 2;
  }
  std::signal(SIGXFSZ, SIG_IGN);  // at the file size limit, writing fails with an error as on a full disk
  try
  {
    run(arguments);
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "check_profile: " << error.what() << '\n';
    return 1;
  }
}
