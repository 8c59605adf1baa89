// SPDX-License-Identifier: BSD-3-Clause
#include "stability_map.h"

namespace wheel_rail_contact::core::stability
{
const std::vector<MapTable>& stabilityMaps()
{
  static const std::vector<MapTable> maps{wheelsetMap(),  shapeMap(),    aspectMap(),
                                          iterationMap(), fewCellsMap(), boxMap()};
  return maps;
}
}  // namespace wheel_rail_contact::core::stability
