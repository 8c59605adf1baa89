// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "ros/evaluation/contact_evaluator.h"

namespace wheel_rail_contact
{
/// Meaning of a line of text, which is shown by its colour.
enum class Tone
{
  normal,   ///< no fault
  warning,  ///< usable result with a warning, or a wheel without load
  error     ///< result that is not usable
};

/// Line of text with its meaning.
struct TextLine
{
  std::string text;          ///< UTF-8
  Tone tone = Tone::normal;  ///< its meaning
};

/// Status and reason of an output, as lines of at most `width` characters (longer only for a longer word). First line:
/// the status; further lines: the reason or the warning.
std::vector<TextLine> statusLines(const ContactOutput& output, std::size_t width);

/// A result as lines of text: stamp and statusLines(); y, yaw and roll of the wheelset, if it has a pose. For each
/// given side of a usable result: a line with Q, Y and highest pressure of the wheel, with the estimated error of this
/// pressure; a line with the displacement of the rail, if it is displaced; and a line for each patch with highest
/// pressure and its estimated error, area, normal force, contact angle and method. With creep forces, a line with the
/// parts of Q and Y by friction after that of the wheel, and one with creepages, spin, friction on the wheel and
/// adhesion share after that of the patch. After that of a patch with stresses, a line with the highest von Mises
/// stress of each body and its depth.
std::vector<TextLine> resultLines(const ContactOutput& output, const std::vector<core::Side>& sides);
}  // namespace wheel_rail_contact
