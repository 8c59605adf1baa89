// SPDX-License-Identifier: BSD-3-Clause
#include "stability_map.h"

namespace wheel_rail_contact::core::stability
{
std::string digits(double value)
{
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  return text.back() == '.' ? text.substr(0, text.size() - 1) : text;
}

const std::vector<MapTable>& stabilityMaps()
{
  static const std::vector<MapTable> maps{wheelsetMap(),  sweepMap(),    conformalMap(), shapeMap(),   aspectMap(),
                                          iterationMap(), fewCellsMap(), boxMap(),       frictionMap()};
  return maps;
}
}  // namespace wheel_rail_contact::core::stability
