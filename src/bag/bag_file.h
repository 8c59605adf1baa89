// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "bag/bag_record.h"

namespace wheel_rail_contact
{
/// A bag file (rosbag format 2.0), opened for reading record by record.
class BagFile
{
 public:
  /// @throw BagError if the file cannot be read, is not a bag of version 2.0 or is encrypted.
  explicit BagFile(const std::string& path);
  ~BagFile();
  BagFile(const BagFile&) = delete;
  BagFile& operator=(const BagFile&) = delete;

  /// Path passed to the constructor.
  const std::string& path() const { return path_; }
  /// Size of the file [B].
  std::uint64_t size() const { return size_; }

  /// Bytes of the file. Position and length in bytes.
  /// @throw BagError if they extend beyond the end of the file, or if `length` exceeds largest_record.
  std::string bytes(std::uint64_t position, std::uint64_t length) const;

  /// Header of a record and position of its data.
  struct Place
  {
    BagFields header;          ///< fields of the record
    std::uint64_t data = 0;    ///< position of the data in the file [B]
    std::uint64_t length = 0;  ///< length of the data [B]
    /// Position of the next record [B].
    std::uint64_t end() const { return data + length; }
  };
  /// Reads the header of the record at a position [B]. Its data may extend beyond the end of the file.
  /// @throw BagError if there is no valid header.
  Place recordAt(std::uint64_t position) const;
  /// Data of a record. @throw BagError as bytes().
  std::string dataOf(const Place& place) const { return bytes(place.data, place.length); }

  /// Position of the record after the bag header [B].
  std::uint64_t firstRecord() const { return first_record_; }
  /// Position of the index section [B]; 0 if the bag was not closed.
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
