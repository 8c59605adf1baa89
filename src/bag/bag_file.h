// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "bag/bag_record.h"

namespace wheel_rail_contact
{
/// A bag open for reading, record by record.
class BagFile
{
 public:
  /// @throw BagError if the file cannot be read or is no bag of version 2.0.
  explicit BagFile(const std::string& path);
  ~BagFile();
  BagFile(const BagFile&) = delete;
  BagFile& operator=(const BagFile&) = delete;

  /// As given.
  const std::string& path() const { return path_; }
  /// Of the file [B].
  std::uint64_t size() const { return size_; }

  /// @throw BagError if they go beyond the end of the file, or are more than largest_record.
  std::string bytes(std::uint64_t position, std::uint64_t length) const;

  /// A record's header, and where its data stands.
  struct Place
  {
    BagFields header;          ///< its fields
    std::uint64_t data = 0;    ///< position in the file [B]
    std::uint64_t length = 0;  ///< of the data [B]
    /// Where the next record begins [B].
    std::uint64_t end() const { return data + length; }
  };
  /// @throw BagError if there is no header of a record here; the data may go beyond the end of the file.
  Place recordAt(std::uint64_t position) const;
  /// A record's data. @throw BagError if they go beyond the end of the file, or are more than largest_record.
  std::string dataOf(const Place& place) const { return bytes(place.data, place.length); }

  /// Where the record after the bag header begins.
  std::uint64_t firstRecord() const { return first_record_; }
  /// Where the index section begins; 0 if the bag was not closed.
  std::uint64_t indexSection() const { return index_section_; }

 private:
  void readBagHeader();

  std::string path_;
  int descriptor_;
  std::uint64_t size_ = 0;
  std::uint64_t first_record_ = 0;
  std::uint64_t index_section_ = 0;
};
}  // namespace wheel_rail_contact
