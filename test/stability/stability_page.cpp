// SPDX-License-Identifier: BSD-3-Clause
// Writes the page doc/stability.md to the standard output:
//   stability_page > doc/stability.md
#include "stability_map.h"

int main()
{
  using namespace wheel_rail_contact::core::stability;
  try
  {
    writePage(std::cout, stabilityMaps());
  }
  catch (const std::exception& error)
  {
    std::cerr << "stability_page: " << error.what() << '\n';
    return 1;
  }
  return std::cout.flush() ? 0 : 1;
}
