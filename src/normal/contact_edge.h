// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <vector>

namespace wheel_rail_contact
{
/// Cells around a pressure that the functions below may read.
constexpr int kFrame = 3;

/// Where the edge of the contact lies, in cells outward from the centre of the outermost loaded cell of a line.
///
/// p1 > 0 is that cell's pressure, p2 and p3 those of the next two inward (zero if not loaded).
///
/// Near its edge the true pressure rises like the root of the distance. For cells of constant pressure matched at their
/// centres, the discrete pressures along such an edge are linear in the edge's place, whatever the cells' size:
/// with the edge d cells outside the first centre,
///   d = (1.07425 p1 - 0.17475 p2) / (p2 - 0.42487 p1),   p3 = 1.42487 p2 -
///   0.26582 p1.
/// The numbers were fitted (to 1e-5) to a line contact of 667 cells' width, moved through a cell in 200 steps; a cell
/// is loaded when d lies between -0.175 and 0.825. What p3 differs from this is taken as the next term of the pressure,
/// (distance)^(3/2), and removed from p1 and p2 first.
double edgeDistance(double p1, double p2, double p3);

/// Area of the contact in cells: the polygon through the edge's crossings of the lines of cell centres, less what it is
/// known to be off.
///
/// Chords between the crossings cut a closed curve short by half a cell and more, all the more the farther its tips
/// reach out beyond the outermost loaded row or column. Where the edge runs askew to a line, its crossing is found too
/// far out or in, by the cells' shape and by how far beyond the last loaded centre it lies. With m crossings; n the
/// cells of the polygon; a the cells' aspect (dx/dy); at each end of a chord t the edge's distance d less 0.325, l =
/// ln(a) on a line along x and -ln(a) on one along y, e = t² - 1/12; r and c the chord's extent along the end's line
/// and square to it in cells, f the angle in the plane between the edge and what is square to the line; and t at the
/// tip of each side, with l as on a line towards it,
///   excess = 0.005 m - max(0.67 - 1.5 / n, 0)
///            + sum over ends of [ 0.0026 l sin²(f) + (0.18 l - 0.024) t r c / (r² + c²)^(1/2)
///                                 - 0.469 l e r³ c / (r² + c²)^(3/2) - 0.0115 l |l| e c sin²(f) ]
///            - sum over tips of [ 0.295 t - (0.335 - 0.295 l) t² ].
/// Terms and numbers were fitted, by a program that is not kept, to the least error of 11 800 Hertz contacts (a
/// quarter of them turned by up to 0.3 rad, on 24 grids of 4 × 16 to 48 × 96 cells, B/A from 0.1 to 20), 3 000 of a
/// handful of cells and 11 400 patches of test/calibration's wheelsets on 18 grids of 4 × 16 to 32 × 96 cells. On as
/// many others the mean error is 0.13 and 0.18 cells (0.17 and 0.23 without the terms in t at the ends and t² at the
/// tips). test/normal/measures_test.cpp looks at more. A pressure on several islands counts as one.
class EdgePolygon
{
 public:
  /// Copies a pressure (rows × columns) into a frame of kFrame zeros; with `mirrored` the rows before the first are its
  /// mirror image instead. Allocates only for larger arrays than before.
  void frame(const Eigen::ArrayXXd& pressure, bool mirrored);

  /// Area of what was framed, of a mirrored one that of the stored half [cells].
  /// @param aspect  of the cells: length along x, the rows, over width along y, the columns [-]
  double cells(double aspect);

 private:
  /// The outermost loaded line of cells on one side, and how far the edge lies beyond it.
  struct Tip
  {
    static constexpr int none = std::numeric_limits<int>::min();

    /// Looks at the edge `reach` cells beyond the line `outward`, which counts up towards the side.
    void see(int outward, double reach);
    /// What the polygon is too small by here [cells]. `longer`: logarithm of the cells' extent towards the side over
    /// that square to it.
    double cutShort(double longer) const;

    int line = none;
    double farthest = 0;
  };

  /// Framed pressure around a cell; the next row is one further, the next column stride_.
  const double* at(Eigen::Index row, Eigen::Index column) const
  {
    return framed_.data() + (row + kFrame) + (column + kFrame) * stride_;
  }
  /// Area of the polygon alone [cells]; counts the crossings, sums what the chords are off by and finds the tips.
  /// `longer` is the logarithm of `aspect`.
  double polygonCells(double aspect, double longer);
  /// What the polygon is too large by [cells].
  double excess(double polygon, double longer) const;

  std::vector<double> framed_, along_;  ///< pressure; edge's distances along x at the last column, where it crosses
  Eigen::Index rows_ = 0, columns_ = 0;
  std::ptrdiff_t stride_ = 0;
  bool mirrored_ = false;
  int crossings_ = 0;
  double askew_ = 0;                 ///< sum over the chords' ends, see above [cells]
  Tip front_, back_, left_, right_;  ///< towards rising and falling x, falling and rising y
};
}  // namespace wheel_rail_contact
