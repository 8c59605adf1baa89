// SPDX-License-Identifier: BSD-3-Clause
#include "bag/bag_record.h"

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
  if (bytes.size() < length)
  {
    throw BagError("a record is truncated");
  }
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
    if (equals == std::string_view::npos)
    {
      throw BagError("a header field has no '='");
    }
    fields_[std::string(field.substr(0, equals))] = field.substr(equals + 1);
  }
}

const std::string& BagFields::text(const std::string& name) const
{
  const auto found = fields_.find(name);
  if (found == fields_.end())
  {
    throw BagError("a header has no field '" + name + "'");
  }
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
}  // namespace wheel_rail_contact
