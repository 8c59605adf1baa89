// SPDX-License-Identifier: BSD-3-Clause
#include "replay/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace wheel_rail_contact
{
namespace
{
constexpr std::chrono::milliseconds bar_period(200);
constexpr std::chrono::seconds line_period(10);
constexpr int bar_width = 30;
}  // namespace

Progress::Progress(std::uint64_t total)
    : total_(total), terminal_(isatty(STDERR_FILENO) != 0), next_(terminal_ ? start_ : start_ + line_period)
{
}

double Progress::elapsed() const
{
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void Progress::show(std::uint64_t read, std::uint64_t results)
{
  if (Clock::now() >= next_)
  {
    print(read, results);
    next_ = Clock::now() + (terminal_ ? Clock::duration(bar_period) : Clock::duration(line_period));
  }
}

void Progress::finish(std::uint64_t read, std::uint64_t results)
{
  if (terminal_)
  {
    print(read, results);
    std::fputc('\n', stderr);
  }
}

void Progress::print(std::uint64_t read, std::uint64_t results) const
{
  const double share = total_ > 0 ? std::min(1.0, static_cast<double>(read) / static_cast<double>(total_)) : 1.0;
  const double rate = static_cast<double>(results) / std::max(elapsed(), 1e-3);
  const double left = share > 0 ? elapsed() * (1 - share) / share : 0;
  const auto filled = static_cast<std::size_t>(std::lround(share * bar_width));
  const std::string bar =
      terminal_ ? "\r[" + std::string(filled, '#') + std::string(bar_width - filled, '.') + "] " : std::string();
  std::fprintf(stderr, "%s%5.1f %%  %llu results, %.0f/s, %.0f s left %s", bar.c_str(), 100 * share,
               static_cast<unsigned long long>(results), rate, std::ceil(left), terminal_ ? "  " : "\n");
}
}  // namespace wheel_rail_contact
