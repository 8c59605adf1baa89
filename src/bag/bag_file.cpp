// SPDX-License-Identifier: BSD-3-Clause
#include "bag/bag_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace wheel_rail_contact
{
namespace
{
constexpr std::uint32_t longest_header = 1 << 20;  ///< a record with a longer header is damaged [B]
}

BagFile::BagFile(const std::string& path) : path_(path), descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC))
{
  struct stat status = {};
  if (descriptor_ < 0 || fstat(descriptor_, &status) != 0)
  {
    throw BagError(path + ": " + std::generic_category().message(errno));
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
  try
  {
    readBagHeader();
  }
  catch (...)
  {
    close(descriptor_);
    throw;
  }
}

BagFile::~BagFile()
{
  close(descriptor_);
}

void BagFile::readBagHeader()
{
  if (size_ < bag_magic.size() || bytes(0, bag_magic.size()) != bag_magic)
  {
    throw BagError(path_ + ": not a bag of version 2.0 (older versions: rosbag fix)");
  }
  const Place header = recordAt(bag_magic.size());
  if (header.header.op() != BagOp::bag_header)
  {
    throw BagError(path_ + ": the first record is not a bag header");
  }
  if (header.header.has("encryptor") && !header.header.text("encryptor").empty())
  {
    throw BagError(path_ + ": the bag is encrypted (decrypt it with rosbag decrypt)");
  }
  first_record_ = header.end();
  index_section_ = header.header.number<std::uint64_t>("index_pos");
}

std::string BagFile::bytes(std::uint64_t position, std::uint64_t length) const
{
  if (position > size_ || length > size_ - position)
  {
    throw BagError(path_ + ": the file ends within a record");
  }
  if (length > largest_record)
  {
    throw BagError(path_ + ": " + std::to_string(length >> 20U) + " MiB in one record, more than 256 MiB");
  }
  std::string result(length, '\0');
  std::uint64_t done = 0;
  while (done < length)
  {
    const ssize_t got = pread(descriptor_, &result[done], length - done, static_cast<off_t>(position + done));
    if (got < 0 && errno == EINTR)
    {
      continue;
    }
    if (got <= 0)
    {
      throw BagError(path_ + ": " +
                     (got == 0 ? "the file was truncated while it was read" : std::generic_category().message(errno)));
    }
    done += static_cast<std::uint64_t>(got);
  }
  return result;
}

BagFile::Place BagFile::recordAt(std::uint64_t position) const
{
  const auto header_length = numberAt<std::uint32_t>(bytes(position, sizeof(std::uint32_t)));
  if (header_length > longest_header)
  {
    throw BagError(path_ + ": no valid record at byte " + std::to_string(position));
  }
  const std::string header = bytes(position + sizeof(std::uint32_t), header_length + sizeof(std::uint32_t));
  Place place;
  place.header = BagFields(std::string_view(header).substr(0, header_length));
  place.length = numberAt<std::uint32_t>(std::string_view(header).substr(header_length));
  place.data = position + 2 * sizeof(std::uint32_t) + header_length;
  return place;
}
}  // namespace wheel_rail_contact
