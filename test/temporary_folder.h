// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace wheel_rail_contact
{
/// Temporary folder for the files of a test. It is removed with the object.
class Folder
{
 public:
  Folder() : path_((std::filesystem::temp_directory_path() / "wheel_rail_contact.XXXXXX").string())
  {
    if (mkdtemp(path_.data()) == nullptr)
    {
      throw std::runtime_error("cannot create the folder " + path_);
    }
  }
  ~Folder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  /// Writes a file and returns its path.
  std::string write(const std::string& name, const std::string& content) const
  {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }
  /// Path of a file in the folder.
  std::string path(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};
}  // namespace wheel_rail_contact
