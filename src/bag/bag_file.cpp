// SPDX-License-Identifier: BSD-3-Clause
#include "bag/bag_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

namespace wheel_rail_contact
{
namespace
{
constexpr std::uint64_t second = 1000000000;  ///< [ns]

/// Removes a length and that number of bytes from the beginning of `bytes`. @return the bytes after the length
std::string_view takeCounted(std::string_view& bytes)
{
  const auto length = numberAt<std::uint32_t>(bytes);
  bytes.remove_prefix(sizeof(length));
  refuseBagIf(bytes.size() < length, "a record is truncated");
  const std::string_view taken = bytes.substr(0, length);
  bytes.remove_prefix(length);
  return taken;
}
}  // namespace

std::uint64_t timeAt(std::string_view bytes)
{
  const auto seconds = numberAt<std::uint32_t>(bytes);
  return seconds * second + numberAt<std::uint32_t>(bytes.substr(sizeof(seconds)));
}

std::string timeBytes(std::uint64_t nanoseconds)
{
  return bytesOf(static_cast<std::uint32_t>(nanoseconds / second)) +
         bytesOf(static_cast<std::uint32_t>(nanoseconds % second));
}

BagFields::BagFields(std::string_view bytes)
{
  while (!bytes.empty())
  {
    const std::string_view field = takeCounted(bytes);
    const auto equals = field.find('=');
    refuseBagIf(equals == std::string_view::npos, "a header field has no '='");
    fields_[std::string(field.substr(0, equals))] = field.substr(equals + 1);
  }
}

const std::string& BagFields::text(const std::string& name) const
{
  const auto found = fields_.find(name);
  refuseBagIf(found == fields_.end(), "a header has no field '", name, "'");
  return found->second;
}

BagFields& BagFields::set(const std::string& name, std::string value)
{
  fields_[name] = std::move(value);
  return *this;
}

std::string BagFields::bytes() const
{
  std::string bytes;
  for (const auto& [name, value] : fields_)
  {
    bytes += bytesOf(static_cast<std::uint32_t>(name.size() + 1 + value.size()));
    bytes += name;
    bytes += '=';
    bytes += value;
  }
  return bytes;
}

BagRecord recordAt(std::string_view bytes)
{
  const std::size_t before = bytes.size();
  BagRecord record;
  record.header = BagFields(takeCounted(bytes));
  record.data = takeCounted(bytes);
  record.length = before - bytes.size();
  return record;
}

void appendRecord(const BagFields& header, std::string_view data, std::string& bytes)
{
  const std::string fields = header.bytes();
  bytes += bytesOf(static_cast<std::uint32_t>(fields.size()));
  bytes += fields;
  bytes += bytesOf(static_cast<std::uint32_t>(data.size()));
  bytes += data;
}

constexpr std::uint32_t longest_header = 1 << 20;  ///< a record with a longer header is damaged [B]

BagFile::BagFile(const std::string& path, std::uint64_t most_expanded)
    : path_(path), descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK))
{
  struct stat status = {};
  const bool is_open = descriptor_ >= 0 && fstat(descriptor_, &status) == 0;
  refuseBagIf(!is_open, path, ": ", std::generic_category().message(errno));
  size_ = static_cast<std::uint64_t>(status.st_size);
  most_expanded_ = most_expanded > 0 ? most_expanded : std::max(largest_record, usual_expansion * size_);
  try
  {
    refuseBagIf(!S_ISREG(status.st_mode), path + ": not a regular file");
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
  const std::string magic = bytes(0, std::min<std::uint64_t>(size_, bag_magic.size()));
  const bool is_ros2 = magic.find("MCAP") != std::string::npos || magic.find("SQLite") != std::string::npos;
  refuseBagIf(magic != bag_magic,
              path_ + (is_ros2 ? ": a recording of ROS 2; convert it to a bag of ROS 1 (rosbags-convert)"
                               : ": not a bag of version 2.0 (older versions: rosbag fix)"));
  const Place header = recordAt(bag_magic.size());
  refuseBagIf(header.header.op() != BagOp::bag_header, path_ + ": the first record is not a bag header");
  refuseBagIf(header.header.has("encryptor") && !header.header.text("encryptor").empty(),
              path_ + ": the bag is encrypted (decrypt it with rosbag decrypt)");
  first_record_ = header.end();
  index_section_ = header.header.number<std::uint64_t>("index_pos");
}

std::string BagFile::bytes(std::uint64_t position, std::uint64_t length) const
{
  refuseBagIf(position > size_ || length > size_ - position, path_, ": the file ends within a record");
  refuseBagIf(length > largest_record, path_, ": ", length >> 20U, " MiB in one record, more than 256 MiB");
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
  refuseBagIf(header_length > longest_header, path_, ": no valid record at byte ", position);
  const std::string header = bytes(position + sizeof(std::uint32_t), header_length + sizeof(std::uint32_t));
  Place place;
  place.header = BagFields(std::string_view(header).substr(0, header_length));
  place.length = numberAt<std::uint32_t>(std::string_view(header).substr(header_length));
  place.data = position + 2 * sizeof(std::uint32_t) + header_length;
  return place;
}
}  // namespace wheel_rail_contact
