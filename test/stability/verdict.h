// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../standard_headers.h"

namespace wheel_rail_contact::core::stability
{
/// Class of the relative error of the highest pressure.
struct ErrorClass
{
  double upper;      ///< largest error [-]
  const char* text;  ///< entry on the page
};

/// The classes of doc/stability.md, from small to large errors.
constexpr std::array<ErrorClass, 4> error_classes{{{0.02, "right"},
                                                   {0.1, "error 2–10 %"},
                                                   {0.5, "error 10–50 %"},
                                                   {std::numeric_limits<double>::infinity(), "error > 50 %"}}};

/// Largest relative distance of a computed value from a border at which the page may give the class on the other side
/// [-].
constexpr double border_margin = 0.2;

/// An entry of doc/stability.md: the text of the computed class, and the texts that the page may also contain because a
/// value is close to a border.
class Verdict
{
 public:
  /// Text without a border.
  Verdict(const char* text) : texts_{text} {}

  /// `above` if value > limit or NaN, otherwise `below`.
  static Verdict byLimit(double value, double limit, const Verdict& above, const Verdict& below);
  /// Class of a relative error of the highest pressure [-].
  static Verdict ofError(double error);
  /// The nearest multiple of `unit`; the page may also contain the one on the other side of the value.
  static Verdict rounded(double value, double unit);
  /// No result, for the given reason.
  static Verdict refused(const std::string& reason);

  /// Appends another verdict after a separator, unless it is empty.
  Verdict with(const Verdict& other, const char* separator = ", ") const;
  /// Appends "flagged" to results that are not right if their error estimate is above the tolerance.
  Verdict withFlag(double estimate, double tolerance) const;

  const std::string& text() const { return texts_.front(); }
  /// Reason of a refusal; empty for other verdicts.
  const std::string& reason() const { return reason_; }
  /// True if the page may contain this text.
  bool allows(const std::string& written) const;
  /// True if the result is right, refused, flagged or without contact.
  bool isReliable() const;

 private:
  std::vector<std::string> texts_;  ///< the computed one first
  std::string reason_;
};
}  // namespace wheel_rail_contact::core::stability
