// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

namespace wheel_rail_contact::core
{
/// Properties of a grid that determine its influence coefficients. The coefficients scale with the cell width, so only
/// the aspect of the cells is relevant.
struct OperatorShape
{
  int nx = 0, ny = 0;      ///< cells along the track (of the whole grid) and across
  double aspect = 1;       ///< dx/dy
  bool symmetric = false;  ///< pressure even in x, half of it stored (nx even)
};

/// Product of the influence matrix with a pressure, for cells of width dy = 1 and pi E* = 1. Multiply the result by dy
/// / (pi E*).
///
/// The coefficients depend on the distance of the cells and are even in x and y. On a grid of twice the length and
/// width (zero padding) the product is therefore diagonal in the cosine and sine modes. The pressure fills only half of
/// that grid in each direction and is split into parts even and odd about the centre. Each mode is then a sum over a
/// quarter of the doubled grid. At the sizes of a contact patch these sums are fastest as matrix products with
/// precomputed cosines.
///
/// Fields are stored in an order of cells that suits the sums; see rowOffset(). A field has fieldSize() doubles,
/// including padding.
class InfluenceOperator
{
 public:
  /// Scratch memory of multiply() and precondition(). Several operators can use the same one.
  class Workspace
  {
   public:
    Workspace();
    ~Workspace();
    Workspace(Workspace&&) noexcept;
    Workspace& operator=(Workspace&&) noexcept;
    /// Reserves memory for an operator. Allocates only if the operator is larger than all previous ones.
    void reserve(const InfluenceOperator& shape);

   private:
    friend class InfluenceOperator;
    struct Buffers;
    std::unique_ptr<Buffers> buffers_;
  };

  /// Creates an operator. It shares the tables that do not depend on the aspect with `sibling`, if the sibling has the
  /// same nx and ny. A symmetric operator takes its coefficients from a sibling that differs only in symmetry.
  /// @throw std::invalid_argument for nx or ny below 2, an odd nx with symmetry, or an aspect that is not positive and
  /// finite.
  explicit InfluenceOperator(const OperatorShape& shape, const InfluenceOperator* sibling = nullptr);
  ~InfluenceOperator();
  InfluenceOperator(InfluenceOperator&&) noexcept;
  InfluenceOperator& operator=(InfluenceOperator&&) noexcept;

  /// Shape given to the constructor.
  const OperatorShape& shape() const;

  /// Number of doubles in a field, a multiple of eight.
  int fieldSize() const;

  /// Row part of the index of a stored cell in a field. Row and column are counted as in Grid. The index is rowOffset()
  /// + columnOffset().
  int rowOffset(int row) const { return row_offsets_[static_cast<std::size_t>(row)]; }
  /// Column part of the index of a stored cell in a field.
  int columnOffset(int column) const { return column_offsets_[static_cast<std::size_t>(column)]; }

  /// Computes displacement = A pressure. The padding of `pressure` must be zero. That of `displacement` is then zero
  /// too.
  void multiply(const double* pressure, double* displacement, Workspace& workspace) const;

  /// True if `displacement` is the product of the matrix with `pressure`. Checked by one weighted sum over all cells,
  /// to 1e-9 of its value. A larger change of any single cell is detected.
  bool isProduct(const double* pressure, const double* displacement) const;

  /// Approximate inverse: the inverse of the same kernel, repeated with the period of the grid.
  void precondition(const double* residual, double* direction, Workspace& workspace) const;

 private:
  void fillOffsets();
  void fillProbe();

  struct Tables;
  std::unique_ptr<Tables> tables_;
  std::vector<int> row_offsets_, column_offsets_;
};
}  // namespace wheel_rail_contact::core
