// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/bag/bag_compression.h"

#include <bzlib.h>
#include <roslz4/lz4s.h>

#include "wheel_rail_contact/bag/bag_record.h"

namespace wheel_rail_contact
{
namespace
{
constexpr int lz4_block_size = 6;               ///< 1 MiB, roslz4_blockSizeFromIndex()
constexpr std::size_t largest_chunk = 1 << 30;  ///< [B] a damaged header shall not fill the memory

/// Runs `work(content, length of the content)`, which must fill the content to its end.
template <typename Work>
std::string filled(std::size_t size, const Work& work)
{
  if (size > largest_chunk)
  {
    throw BagError("a chunk claims to be larger than 1 GiB");
  }
  std::string content(size, '\0');
  auto length = static_cast<unsigned int>(size);
  if (!work(content.data(), length) || length != size)
  {
    throw BagError("compressed data is damaged");
  }
  return content;
}
}  // namespace

std::string decompressed(const std::string& compression, std::string data, std::size_t size)
{
  const auto length = static_cast<unsigned int>(data.size());
  if (compression == "none")
  {
    return data;
  }
  if (compression == "bz2")
  {
    return filled(size, [&](char* content, unsigned int& room)
                  { return BZ2_bzBuffToBuffDecompress(content, &room, data.data(), length, 0, 0) == BZ_OK; });
  }
  if (compression == "lz4")
  {
    return filled(size, [&](char* content, unsigned int& room)
                  { return roslz4_buffToBuffDecompress(data.data(), length, content, &room) == ROSLZ4_OK; });
  }
  throw BagError("unknown compression '" + compression + "'");
}

std::string compressed(const std::string& compression, std::string content)
{
  if (compression == "none")
  {
    return content;
  }
  if (compression != "lz4")
  {
    throw BagError("cannot compress by '" + compression + "'");
  }
  // Room for data that cannot be made smaller: block and frame headers.
  std::string data(content.size() + content.size() / 100 + 1024, '\0');
  auto length = static_cast<unsigned int>(data.size());
  if (roslz4_buffToBuffCompress(content.data(), static_cast<unsigned int>(content.size()), data.data(), &length,
                                lz4_block_size) != ROSLZ4_OK)
  {
    throw BagError("lz4 cannot compress a chunk");
  }
  data.resize(length);
  return data;
}
}  // namespace wheel_rail_contact
