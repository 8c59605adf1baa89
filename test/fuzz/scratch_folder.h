// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace wheel_rail_contact::fuzz
{
/// Temporary folder for inputs that must be files. The destructor removes it.
class ScratchFolder
{
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  /// Writes the input to a file of this name and replaces an earlier one. @return path of the file
  std::string write(const std::string& name, const std::uint8_t* data, std::size_t size) const;

 private:
  std::string path_;
};
}  // namespace wheel_rail_contact::fuzz
