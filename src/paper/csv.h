// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace wheel_rail_contact::core::paper
{
/// A CSV file: a header line and rows. Each line is flushed at once to detect a full disk. Numbers have eight
/// significant digits.
class Csv
{
 public:
  /// @throw std::runtime_error if the file cannot be written (same for row())
  Csv(const std::filesystem::path& file, const std::string& columns) : file_(file), stream_(file)
  {
    stream_.precision(8);
    stream_ << columns << std::endl;
    check();
  }

  template <typename First, typename... Rest>
  void row(const First& first, const Rest&... rest)
  {
    stream_ << first;
    ((stream_ << ',' << rest), ...);
    stream_ << std::endl;
    check();
  }

 private:
  void check() const
  {
    if (!stream_)
    {
      throw std::runtime_error(file_.string() + ": cannot be written");
    }
  }

  std::filesystem::path file_;
  std::ofstream stream_;
};
}  // namespace wheel_rail_contact::core::paper
