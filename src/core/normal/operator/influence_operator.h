// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

namespace wheel_rail_contact::core
{
/// Shape of a grid as far as its influence coefficients go: they scale with the cell width, so only the aspect counts.
struct OperatorShape
{
  int nx = 0, ny = 0;      ///< cells along (of the whole grid) and across
  double aspect = 1;       ///< dx/dy
  bool symmetric = false;  ///< pressure even in x, half stored (nx even)
};

/// Product of the influence matrix with a pressure, for cells of width dy = 1 and pi E* = 1: multiply by dy / (pi E*).
///
/// The coefficients depend on the cells' distance and are even in x and y. So the product is diagonal in the cosine and
/// sine modes of a grid twice as long and wide (zero padding); since the pressure fills only half of it, and is split
/// into parts even and odd about the grid's centre, each mode is a sum over a quarter of the doubled grid. At the sizes
/// of a contact patch these sums are fastest as matrix products with precomputed cosines.
///
/// Fields are stored in an order of cells that suits the sums, see rowOffset(); fieldSize() doubles, padding included.
class InfluenceOperator
{
 public:
  /// Scratch memory of multiply() and precondition(), shared by operators.
  class Workspace
  {
   public:
    Workspace();
    ~Workspace();
    Workspace(Workspace&&) noexcept;
    Workspace& operator=(Workspace&&) noexcept;
    /// Makes room for an operator. Allocates only if it is larger than all before.
    void reserve(const InfluenceOperator& shape);

   private:
    friend class InfluenceOperator;
    struct Buffers;
    std::unique_ptr<Buffers> buffers_;
  };

  /// Shares what does not depend on the aspect with `sibling`, if that has the same nx and ny. A symmetric one takes
  /// its coefficients over from a sibling that differs in nothing but symmetry.
  /// @throw std::invalid_argument for sizes below 2, an odd nx with symmetry, or an aspect that is not positive.
  explicit InfluenceOperator(const OperatorShape& shape, const InfluenceOperator* sibling = nullptr);
  ~InfluenceOperator();
  InfluenceOperator(InfluenceOperator&&) noexcept;
  InfluenceOperator& operator=(InfluenceOperator&&) noexcept;

  /// As given.
  const OperatorShape& shape() const;

  /// Doubles in a field, a multiple of eight.
  int fieldSize() const;

  /// Place in a field of a stored cell (row and column counted as in Grid): the sum of these two.
  int rowOffset(int row) const { return row_offsets_[static_cast<std::size_t>(row)]; }
  /// The column's part of the place.
  int columnOffset(int column) const { return column_offsets_[static_cast<std::size_t>(column)]; }

  /// displacement = A pressure. Padding of `pressure` must be zero; that of `displacement` is then zero too.
  void multiply(const double* pressure, double* displacement, Workspace& workspace) const;

  /// Whether `displacement` is the product with `pressure`, as far as one weighted sum over all cells tells (to 1e-9 of
  /// its value): any change of single cells shows.
  bool isProduct(const double* pressure, const double* displacement) const;

  /// Approximate inverse: that of the same kernel repeated with the grid's own period.
  void precondition(const double* residual, double* direction, Workspace& workspace) const;

 private:
  void fillOffsets();
  void fillProbe();

  struct Tables;
  std::unique_ptr<Tables> tables_;
  std::vector<int> row_offsets_, column_offsets_;
};
}  // namespace wheel_rail_contact::core
