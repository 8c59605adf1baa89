// SPDX-License-Identifier: BSD-3-Clause
#include <bzlib.h>
#include <roslz4/lz4s.h>

#include <algorithm>
#include <memory>
#include <new>
#include <utility>

#include "bag/bag_file.h"

namespace wheel_rail_contact
{
namespace
{
constexpr int lz4_block_size = 6;               ///< 1 MiB, roslz4_blockSizeFromIndex()
constexpr std::size_t bz2_step = 1 << 20;       ///< first size of the buffer [B]
constexpr std::size_t lz4_largest_ratio = 255;  ///< upper limit of content size to data size

void refuseDamagedIf(bool damaged)
{
  refuseBagIf(damaged, "compressed data is damaged");
}

/// Decompresses bz2 data. The buffer grows with the content, because the size in a damaged header may be far too large.
std::string unpackedBz2(std::string data, std::size_t size, ExpandedSize& expanded)
{
  std::string content;
  bz_stream stream = {};
  stream.next_in = data.data();
  stream.avail_in = static_cast<unsigned int>(data.size());
  if (BZ2_bzDecompressInit(&stream, 0, 0) != BZ_OK)
  {
    throw std::bad_alloc();
  }
  const std::unique_ptr<bz_stream, decltype(&BZ2_bzDecompressEnd)> end(&stream, BZ2_bzDecompressEnd);
  int state = BZ_OK;
  std::size_t done = 0;
  while (state == BZ_OK && done < size)
  {
    const std::size_t next = std::min(size, std::max(bz2_step, 2 * done));
    expanded.add(next - done);
    content.resize(next);
    stream.next_out = &content[done];
    stream.avail_out = static_cast<unsigned int>(content.size() - done);
    state = BZ2_bzDecompress(&stream);
    if (state == BZ_OK && stream.avail_out > 0)  // the data is truncated
    {
      state = BZ_UNEXPECTED_EOF;
    }
    done = content.size() - stream.avail_out;
  }
  refuseDamagedIf(state != BZ_STREAM_END || done != size);
  return content;
}

std::string unpackedLz4(std::string data, std::size_t size, ExpandedSize& expanded)
{
  refuseDamagedIf(size > lz4_largest_ratio * data.size());
  expanded.add(size);
  std::string content(size, '\0');
  auto length = static_cast<unsigned int>(size);
  refuseDamagedIf(roslz4_buffToBuffDecompress(data.data(), static_cast<unsigned int>(data.size()), content.data(),
                                              &length) != ROSLZ4_OK ||
                  length != size);
  return content;
}
}  // namespace

void ExpandedSize::add(std::uint64_t size)
{
  is_over_ = is_over_ || size > limit_ - sum_;
  refuseBagIf(is_over_, "the decompressed chunks would exceed ", limit_ >> 20U,
              " MiB; it and the following chunks are not read (--expand-up-to)");
  sum_ += size;
}

std::string decompressed(const std::string& compression, std::string data, std::size_t size, ExpandedSize& expanded)
{
  refuseBagIf(size > largest_record, "its header gives a size above 256 MiB");
  if (compression == "none")
  {
    return data;
  }
  if (compression == "bz2")
  {
    return unpackedBz2(std::move(data), size, expanded);
  }
  if (compression == "lz4")
  {
    return unpackedLz4(std::move(data), size, expanded);
  }
  throw BagError("unknown compression '" + compression + "'");
}

std::string compressed(const std::string& compression, std::string content)
{
  if (compression == "none")
  {
    return content;
  }
  refuseBagIf(compression != "lz4", "cannot compress with '" + compression + "'");
  // Incompressible data becomes larger by the headers of blocks and frame.
  std::string data(content.size() + content.size() / 100 + 1024, '\0');
  auto length = static_cast<unsigned int>(data.size());
  refuseBagIf(roslz4_buffToBuffCompress(content.data(), static_cast<unsigned int>(content.size()), data.data(), &length,
                                        lz4_block_size) != ROSLZ4_OK,
              "lz4 failed to compress a chunk");
  data.resize(length);
  return data;
}
}  // namespace wheel_rail_contact
