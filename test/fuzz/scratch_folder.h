// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace wheel_rail_contact::fuzz
{
/// A folder for what is to be read as a file; gone with the process.
class ScratchFolder
{
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  /// Writes the input as a file of this name, in place of one written before. @return its path
  std::string write(const std::string& name, const std::uint8_t* data, std::size_t size) const;

 private:
  std::string path_;
};
}  // namespace wheel_rail_contact::fuzz
