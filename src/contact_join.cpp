// SPDX-License-Identifier: BSD-3-Clause
// Joins the results of consecutive parts of a bag (contact_replay with --from and --to). contact_campaign calls it.
//
//   contact_join [--lz4] OUT.bag PART.bag...
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "replay/join.h"

int main(int argc, char** argv)
{
  std::vector<std::string> files(argv + 1, argv + argc);
  const bool lz4 = !files.empty() && files.front() == "--lz4";
  files.erase(files.begin(), files.begin() + (lz4 ? 1 : 0));
  if (files.size() < 2 || files.front()[0] == '-')
  {
    std::cerr << "usage: contact_join [--lz4] OUT.bag PART.bag...\n";
    return 2;
  }
  try
  {
    const std::vector<std::string> parts(files.begin() + 1, files.end());
    std::cout << wheel_rail_contact::joinParts(parts, files.front(), lz4 ? "lz4" : "none") << " messages\n";
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "contact_join: " << error.what() << '\n';
    return 1;
  }
}
