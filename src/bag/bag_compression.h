// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace wheel_rail_contact
{
/// The content of a chunk.
/// @param compression as its header says: none, bz2 or lz4
/// @param size of the content in bytes, as its header says
/// @throw BagError if the data is damaged or the compression unknown.
std::string decompressed(const std::string& compression, std::string data, std::size_t size);

/// A chunk's data for its content.
/// @param compression none or lz4
std::string compressed(const std::string& compression, std::string content);
}  // namespace wheel_rail_contact
