// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace wheel_rail_contact
{
/// Content of a chunk.
/// @param compression from the header of the chunk: none, bz2 or lz4
/// @param data of the chunk, compressed
/// @param size of the content, from the header of the chunk [B]
/// @throw BagError if the data is damaged, the size exceeds largest_record or the compression is unknown.
std::string decompressed(const std::string& compression, std::string data, std::size_t size);

/// Compressed data of a chunk.
/// @param compression none or lz4
/// @throw BagError for another compression, or if lz4 fails.
std::string compressed(const std::string& compression, std::string content);
}  // namespace wheel_rail_contact
