// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/normal/measures/edge_bias.h"

namespace wheel_rail_contact::core
{
/// Position of the edge of the contact, in cells outward from the centre of the outermost loaded cell of a line, at
/// most 1.
/// @param p1  pressure of this cell, > 0
/// @param p2,p3  pressures of the next two cells inward; zero if they are not loaded
double edgeDistance(double p1, double p2, double p3);

/// Area of the contact in cells. The crossings of the edge with the lines of cell centres form a polygon. The area is
/// that of the polygon minus its known bias (doc/theory.md, "Area").
class EdgePolygon
{
  static constexpr int frame_width = 3;  ///< readable cells around the pressure

 public:
  /// Copies a pressure (rows × columns) into a frame of frame_width zeros. With `mirrored`, the rows before the first
  /// one are the mirror image. Allocates only if the array is larger than all previous ones.
  void frame(const Eigen::ArrayXXd& pressure, bool mirrored);

  /// Area of the framed pressure [cells]; of a mirrored pressure: area of the stored half.
  /// @param aspect  length of the cells along x (rows) over their width along y (columns) [-]
  double cells(double aspect);

  /// Area of the polygon without correction [cells], as for cells(). Finds the crossings.
  double chords();
  /// Crossings of the framed pressure, found by the last chords() or cells(). Valid until the next frame(). Of a
  /// mirrored pressure: those of the stored half.
  const std::vector<EdgeCrossing>& crossings() const { return crossings_; }

  /// Network inputs at each crossing, computed by the last cells().
  const std::vector<EdgeInputs>& inputs() const { return inputs_; }

  /// Number of islands of the whole contact minus the number of holes in them, found by the last chords() or cells().
  /// Cells that touch only at a corner belong to different islands.
  int islands() const { return islands_; }

  /// Radius of gyration along x over that along y, of the parts within the edge of the lines of cell centres, each in
  /// cells, found by the last chords() or cells(); 0 without a contact.
  double gyrationRatio() const;

  /// A cell of the framed pressure.
  struct Cell
  {
    Eigen::Index row, column;
  };
  /// Position of the loaded cell of a crossing.
  Cell loadedCell(const EdgeCrossing& crossing) const;

 private:
  /// Framed pressure of a cell. The next row is at +1, the next column at +stride_.
  const double* at(Eigen::Index row, Eigen::Index column) const
  {
    return framed_.data() + (row + frame_width) + (column + frame_width) * stride_;
  }
  /// Crossing between a cell and the one `step` further, exactly one of which is loaded.
  EdgeCrossing crossingAfter(const double* p, std::ptrdiff_t step) const;
  /// Stores this crossing. Returns the distance of the edge from the loaded cell [cells].
  /// @param place  of the first cell, from the centre of the grid or any other place [cells]
  double cross(const double* p, std::ptrdiff_t step, double place);

  /// Integrals of 1, t and t² over the loaded parts of lines t [cells].
  struct Moments
  {
    double zeroth = 0, first = 0, second = 0;

    void add(double end, double sign);
    double variance() const;
  };

  std::vector<double> framed_, along_;  ///< pressure; distances of the edge along x at the last column
  Eigen::Index rows_ = 0, columns_ = 0;
  std::ptrdiff_t stride_ = 0;
  bool mirrored_ = false;
  int islands_ = 0;
  Moments moments_along_, moments_across_;
  std::vector<EdgeCrossing> crossings_;
  std::vector<EdgeInputs> inputs_;
};
}  // namespace wheel_rail_contact::core
