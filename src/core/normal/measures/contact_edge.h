// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/normal/measures/edge_bias.h"

namespace wheel_rail_contact::core
{
/// Area of the contact in cells: the polygon through the edge's crossings of the lines of cell centres, less what it is
/// known to be off (EdgeBias).
///
/// Chords between the crossings cut a closed curve short by half a cell and more, all the more the farther its tips
/// reach out beyond the outermost loaded row or column; where the edge runs askew to a line or bends, its crossing is
/// found too far out or in, by the cells' shape and by where between the centres it lies. All of that shows in the
/// pressures about a crossing.
class EdgePolygon
{
  static constexpr int kFrame = 3;  ///< cells around the pressure that may be read

 public:
  /// Copies a pressure (rows × columns) into a frame of kFrame zeros; with `mirrored` the rows before the first are its
  /// mirror image instead. Allocates only for larger arrays than before.
  void frame(const Eigen::ArrayXXd& pressure, bool mirrored);

  /// Area of what was framed, of a mirrored one that of the stored half [cells].
  /// @param aspect  of the cells: length along x, the rows, over width along y, the columns [-]
  double cells(double aspect);

  /// The same of the polygon alone; finds the crossings.
  double chords();
  /// Those of what was framed, found by the last chords() or cells(), until the next frame(); of a mirrored pressure
  /// those of the stored half.
  const std::vector<EdgeCrossing>& crossings() const { return crossings_; }

  /// What shows at each of them; found by the last cells().
  const std::vector<EdgeInputs>& inputs() const { return inputs_; }

  /// Islands of the whole contact, less the holes in them; found by the last chords() or cells(). What touches only by
  /// its corners is apart.
  int islands() const { return islands_; }

  /// A cell of the framed pressure.
  struct Cell
  {
    Eigen::Index row, column;
  };
  /// Where one of those crossings has its loaded cell.
  Cell loadedCell(const EdgeCrossing& crossing) const;

 private:
  /// Framed pressure around a cell; the next row is one further, the next column stride_.
  const double* at(Eigen::Index row, Eigen::Index column) const
  {
    return framed_.data() + (row + kFrame) + (column + kFrame) * stride_;
  }
  /// Between a cell and the one `step` further, of which one is loaded.
  EdgeCrossing crossingAfter(const double* p, std::ptrdiff_t step) const;
  /// Keeps that crossing, and gives the edge's distance from the loaded cell.
  double cross(const double* p, std::ptrdiff_t step);

  std::vector<double> framed_, along_;  ///< pressure; edge's distances along x at the last column, where it crosses
  Eigen::Index rows_ = 0, columns_ = 0;
  std::ptrdiff_t stride_ = 0;
  bool mirrored_ = false;
  int islands_ = 0;
  std::vector<EdgeCrossing> crossings_;
  std::vector<EdgeInputs> inputs_;
};
}  // namespace wheel_rail_contact::core
