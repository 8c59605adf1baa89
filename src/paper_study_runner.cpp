// SPDX-License-Identifier: BSD-3-Clause
// The calculations of the command paper_study. The command finds the files and draws the pictures.
//   paper_study_runner OUT CONFIG.yaml TABLE.yaml...
#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "paper/study.h"
#include "ros/parameters/compliance_table_file.h"
#include "ros/parameters/parameters.h"

namespace
{
using namespace wheel_rail_contact;

void run(const std::filesystem::path& folder, const std::string& config_file,
         const std::vector<std::string>& table_files)
{
  const core::ContactModelConfig config =
      readNodeConfig(readParameterFile(config_file), "", std::filesystem::current_path().string()).model;
  std::vector<core::paper::NamedTable> tables;
  for (const std::string& name : table_files)
  {
    const ComplianceTableFile file = readComplianceTable(name);
    tables.push_back({file.name, file.table, file.linear_range});
  }
  const auto progress = [](const std::string& what) { std::cerr << "paper_study: " << what << std::endl; };
  core::paper::writeCases(config, folder, progress);
  core::paper::writeForces(config, tables, folder, progress);
  core::paper::writeStress(config, tables, folder, progress);
  core::paper::writeScan(config, tables, folder, progress);
}
}  // namespace

int main(int argc, char** argv)
{
  if (argc < 4)
  {
    std::cerr << "usage: paper_study_runner OUT CONFIG.yaml TABLE.yaml...\n";
    return 2;
  }
  std::signal(SIGXFSZ, SIG_IGN);  // at the file size limit, writing fails with an error as on a full disk
  try
  {
    run(argv[1], argv[2], {argv + 3, argv + argc});
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "paper_study: " << error.what() << '\n';
    return 1;
  }
}
