// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace wheel_rail_contact::core::stability
{
/// What methods do in a situation; verdicts in the order of the table's columns.
struct MapRow
{
  std::string situation;
  std::vector<std::string> verdicts;
};

struct MapTable
{
  std::string title, text;
  std::vector<std::string> columns;
  std::vector<MapRow> rows;
};

/// How far a highest pressure is off, in words: "right" up to 2 %.
std::string verdictOf(double relative_error);

/// The same of an answer whose error estimate is above the tolerance or not.
std::string verdictSaid(const std::string& verdict, bool above_tolerance);

/// Whole wheelsets by each contact/method; solved once.
const MapTable& wheelsetMap();
/// Solvers on one patch as its cells grow longer.
MapTable aspectMap();
/// Ways to iterate on the same matrix: steps, over-relaxation, stopping rules.
MapTable iterationMap();
/// Shapes that leave Hertz: conformal, with several lobes, flat, rough; solved once.
const MapTable& shapeMap();
/// Contacts that one to some cells of a grid carry.
MapTable fewCellsMap();
/// Boxes too small and too large for the contact.
MapTable boxMap();

/// The page doc/stability.md.
std::string stabilityPage();
}  // namespace wheel_rail_contact::core::stability
