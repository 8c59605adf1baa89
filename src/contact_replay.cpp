// SPDX-License-Identifier: BSD-3-Clause
#include <atomic>
#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <system_error>

#include "replay/replay.h"

namespace
{
enum ExitStatus
{
  done = 0,
  failed = 1,
  wrong_arguments = 2,
  input_damaged = 3,
  few_results = 4,
  doubtful_loads = 5,
  ended_by_signal = 130
};

std::atomic<bool> interrupted{false};

void interrupt(int signal)
{
  interrupted = true;
  std::signal(signal, SIG_DFL);  // a second signal ends the program immediately
}

/// Removes the files of a run without any result: the corrected command may use their names.
void removeOutputs(const wheel_rail_contact::ReplayOptions& options)
{
  std::error_code ignored;
  std::filesystem::remove(options.output, ignored);
  if (!options.csv.empty())
  {
    std::filesystem::remove(options.csv, ignored);
  }
}

ExitStatus run(const wheel_rail_contact::ReplayOptions& options)
{
  std::signal(SIGXFSZ, SIG_IGN);  // a file at its size limit is then reported like a full disk
  wheel_rail_contact::Replay replay(options);
  for (const std::string& note : replay.notes())
  {
    std::cout << note << '\n';
  }
  std::cout << std::flush;  // before the evaluation, which may take long
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  replay.run(interrupted);
  replay.printSummary(std::cout);
  if (interrupted)
  {
    std::cerr << "contact_replay: interrupted; the same command with --resume continues\n";
    return ended_by_signal;
  }
  for (const std::string& fault : replay.faults())
  {
    std::cerr << "contact_replay: " << options.input << ": " << fault << '\n';
  }
  if (replay.results() == 0 && options.span.isWhole())
  {
    std::cerr << "contact_replay: " << options.input << ": contains no pair of pose and load; " << replay.poses()
              << " poses were dropped, for the reasons above\n";
    removeOutputs(options);
    return failed;
  }
  if (replay.lacksMostResults())
  {
    std::cerr << "contact_replay: " << options.input << ": only " << replay.resultsOfUsableInput() << " of "
              << replay.poses() << " poses have a result of usable input\n";
    return few_results;
  }
  if (const std::string doubt = replay.loadDoubt(); !doubt.empty())
  {
    std::cerr << "contact_replay: " << options.input << ": " << doubt << '\n';
    return doubtful_loads;
  }
  return replay.faults().empty() ? done : input_damaged;
}
}  // namespace

int main(int argc, char** argv)
{
  try
  {
    const auto options = wheel_rail_contact::parseReplayOptions({argv + 1, argv + argc});
    if (options.help)
    {
      wheel_rail_contact::printReplayUsage(std::cout);
      return done;
    }
    return run(options);
  }
  catch (const std::invalid_argument& error)
  {
    std::cerr << "contact_replay: " << error.what() << "\n(contact_replay --help)\n";
    return wrong_arguments;
  }
  catch (const std::exception& error)
  {
    std::cerr << "contact_replay: " << error.what() << '\n';
    return failed;
  }
}
