// SPDX-License-Identifier: BSD-3-Clause
// The calculations behind the command paper_study, which finds the files and draws the pictures:
//   paper_study_runner OUT CONFIG.yaml cases|forces|scan... -- TABLE.yaml...
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "paper/study.h"
#include "wheel_rail_contact/ros/compliance_table_file.h"
#include "wheel_rail_contact/ros/parameters.h"

namespace
{
using namespace wheel_rail_contact;

void run(const std::vector<std::string>& arguments)
{
  const std::filesystem::path folder = arguments.at(0);
  const ContactModelConfig config =
      readNodeConfig(readParameterFile(arguments.at(1)), "", std::filesystem::current_path().string()).model;
  std::size_t next = 2;
  std::vector<std::string> parts;
  for (; next < arguments.size() && arguments[next] != "--"; ++next)
  {
    parts.push_back(arguments[next]);
  }
  std::vector<paper::NamedTable> tables;
  for (++next; next < arguments.size(); ++next)
  {
    const ComplianceTableFile file = readComplianceTable(arguments[next]);
    tables.push_back({file.name, file.table, file.linear_range});
  }
  const auto progress = [](const std::string& what) { std::cerr << "paper_study: " << what << std::endl; };
  for (const std::string& part : parts)
  {
    if (part == "cases")
    {
      paper::writeCases(config, folder, progress);
    }
    else if (part == "forces")
    {
      paper::writeForces(config, tables, folder, progress);
    }
    else if (part == "scan")
    {
      paper::writeScan(config, tables, folder, progress);
    }
    else
    {
      throw std::invalid_argument(part + ": must be cases, forces or scan");
    }
  }
}
}  // namespace

int main(int argc, char** argv)
{
  try
  {
    if (argc < 4)
    {
      throw std::invalid_argument("needs OUT CONFIG.yaml cases|forces|scan... -- TABLE.yaml...");
    }
    run({argv + 1, argv + argc});
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "paper_study: " << error.what() << '\n';
    return 1;
  }
}
