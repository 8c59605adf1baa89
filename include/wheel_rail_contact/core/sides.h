// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <type_traits>
#include <utility>

namespace wheel_rail_contact::core
{
/// Side of the track, seen in the direction of travel (+x).
enum class Side
{
  left = 0,  ///< y > 0
  right = 1  ///< y < 0
};

/// Both sides, left first.
constexpr std::array<Side, 2> sides{Side::left, Side::right};

/// "left" or "right".
constexpr const char* nameOf(Side side)
{
  return side == Side::left ? "left" : "right";
}

/// A value for each side. One value sets both sides: `option = value`; each side can be set alone: `option.left =
/// value`.
template <typename Value>
struct Sides
{
  Value left;   ///< of the left side
  Value right;  ///< of the right side

  /// Default values.
  Sides() : left(), right() {}
  /// The same value on both sides.
  template <typename Same, typename = std::enable_if_t<std::is_convertible_v<Same, Value>>>
  Sides(const Same& both) : left(both), right(both)
  {
  }
  /// The value that `make` returns for each Side.
  template <typename Make, typename = std::invoke_result_t<Make, Side>, typename = void>
  explicit Sides(Make make) : left(make(Side::left)), right(make(Side::right))
  {
  }
  /// Different values.
  Sides(Value of_left, Value of_right) : left(std::move(of_left)), right(std::move(of_right)) {}

  /// Value of a side.
  Value& operator[](Side side) { return side == Side::left ? left : right; }
  /// Value of a side.
  const Value& operator[](Side side) const { return side == Side::left ? left : right; }
};

/// True if the values of both sides are equal.
template <typename Value>
bool operator==(const Sides<Value>& a, const Sides<Value>& b)
{
  return a.left == b.left && a.right == b.right;
}
}  // namespace wheel_rail_contact::core
