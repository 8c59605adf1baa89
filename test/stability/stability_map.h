// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "verdict.h"

namespace wheel_rail_contact::core::stability
{
/// Results of all methods in one situation, in the order of the columns.
struct MapRow
{
  std::string situation;
  std::vector<Verdict> verdicts;
};

/// A table of doc/stability.md.
struct MapTable
{
  std::string title, text;
  std::vector<std::string> columns;
  std::vector<MapRow> rows;
};

/// A number with up to six decimals, without zeros at its end.
std::string digits(double value);

/// Names of all methods, as columns.
std::vector<std::string> methodNames();

/// Wheelsets with each contact/method.
MapTable wheelsetMap();
/// Wheelsets that move to and fro, with `auto`: onset of a contact, and states with two equilibria.
MapTable sweepMap();
/// Wheelsets whose flange root touches the gauge corner, against the reference code.
MapTable conformalMap();
/// Gaps that differ from Hertz: conformal, with several lobes, flat, rough.
MapTable shapeMap();
/// Normal solvers on one patch, with cells of increasing length.
MapTable aspectMap();
/// Iterations on the same matrix: step sizes, relaxation factors, stopping criteria.
MapTable iterationMap();
/// Contacts on few cells of a grid.
MapTable fewCellsMap();
/// Grids smaller and larger than the contact.
MapTable boxMap();
/// Methods for creep forces, against the complete theory on the same cells.
MapTable frictionMap();

/// All of them. They are computed in the first call, which takes about ten seconds.
const std::vector<MapTable>& stabilityMaps();

/// All lines of a table on the page before its rows.
std::string headOf(const MapTable& table);
/// Writes the page doc/stability.md.
void writePage(std::ostream& out, const std::vector<MapTable>& tables);
}  // namespace wheel_rail_contact::core::stability
