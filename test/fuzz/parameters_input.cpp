// SPDX-License-Identifier: BSD-3-Clause
// Parameter files and compliance tables: each is read, or rejected with std::invalid_argument.
#include "../temporary_folder.h"
#include "config/compliance_table_file.h"
#include "config/node_config.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace wheel_rail_contact;
  static const Folder folder;
  const std::string file = folder.write("input.yaml", {data, data + size});
  try
  {
    readNodeConfig(readParameterFile(file), "", {"", nullptr});
  }
  catch (const std::invalid_argument&)  // rejected with a reason
  {
  }
  try
  {
    readComplianceTable(file);
  }
  catch (const std::invalid_argument&)  // rejected with a reason
  {
  }
  return 0;
}
