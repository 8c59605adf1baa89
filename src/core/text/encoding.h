// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace wheel_rail_contact::core
{
/// Text of a file in UTF-8, with lines that end with \n.
///
/// A byte order mark shows UTF-8 and UTF-16 of both byte orders. Without a mark, bytes that are not valid UTF-8 are
/// taken as Latin-1. Lines of the file may end with \n, \r\n or \r.
/// @return nothing if the bytes are not a text: they contain control characters.
std::optional<std::string> decodedText(const std::string& bytes);
}  // namespace wheel_rail_contact::core
