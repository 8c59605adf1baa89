// SPDX-License-Identifier: BSD-3-Clause
#include "scratch_folder.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace wheel_rail_contact::fuzz
{
ScratchFolder::ScratchFolder() : path_((std::filesystem::temp_directory_path() / "fuzz_XXXXXX").string())
{
  if (mkdtemp(path_.data()) == nullptr)
  {
    throw std::runtime_error("cannot create the folder " + path_);
  }
}

ScratchFolder::~ScratchFolder()
{
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string ScratchFolder::write(const std::string& name, const std::uint8_t* data, std::size_t size) const
{
  const std::string file = path_ + "/" + name;
  std::ofstream(file, std::ios::binary) << std::string(data, data + size);
  return file;
}
}  // namespace wheel_rail_contact::fuzz
