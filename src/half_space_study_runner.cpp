// SPDX-License-Identifier: BSD-3-Clause
// The half-space solutions of one place, for the command half_space_study. The command runs the finite elements.
//   half_space_study_runner OUT CONFIG.yaml Y ROWS COLUMNS LOAD...
#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "half_space/tables.h"
#include "ros/parameters/parameters.h"

namespace
{
using namespace wheel_rail_contact;

void run(const std::vector<std::string>& arguments)
{
  const core::ContactModelConfig config =
      readNodeConfig(readParameterFile(arguments[1]), "", std::filesystem::current_path().string()).model;
  const core::half_space::CellCount count{std::stoi(arguments[3]), std::stoi(arguments[4])};
  std::vector<double> loads;
  for (std::size_t i = 5; i < arguments.size(); ++i)
  {
    loads.push_back(std::stod(arguments[i]));
  }
  core::half_space::writeTables(config, std::stod(arguments[2]), loads, count, arguments[0]);
}
}  // namespace

int main(int argc, char** argv)
{
  if (argc < 7)
  {
    std::cerr << "usage: half_space_study_runner OUT CONFIG.yaml Y ROWS COLUMNS LOAD...\n";
    return 2;
  }
  std::signal(SIGXFSZ, SIG_IGN);  // at the file size limit, writing fails with an error as on a full disk
  try
  {
    run({argv + 1, argv + argc});
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "half_space_study: " << error.what() << '\n';
    return 1;
  }
}
