// SPDX-License-Identifier: BSD-3-Clause
// The program simulate_wheelset: see usage() and doc/co_simulation.md.
#include <ros/ros.h>

#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "examples/simulate_wheelset/closed_loop.h"
#include "examples/simulate_wheelset/contact_ways.h"

namespace
{
using namespace simulate_wheelset;

std::unique_ptr<ContactSource> makeSource(const Options& options)
{
  switch (options.contact)
  {
    case ContactWay::topics:
      return std::make_unique<TopicContact>(options.node, options.frame);
    case ContactWay::service:
      return std::make_unique<ServiceContact>(options.node, options.frame);
    case ContactWay::in_process:
      break;
  }
  return std::make_unique<InProcessContact>(readContact(options.contact_config));
}

/// @param speed running speed [m/s]
void print(const RunSummary& summary, double speed)
{
  std::cout << std::fixed << std::setprecision(3) << summary.steps << " steps, " << summary.held
            << " with a held contact, " << summary.saturated << " at the friction limit\n"
            << "last third: " << summary.waves.text(speed) << '\n'
            << summary.times.text() << '\n';
}

void run(const Options& options)
{
  const Parameters parameters = parametersOf(options);
  const std::unique_ptr<ContactSource> source = makeSource(options);
  std::unique_ptr<MotionTable> table;
  if (!options.out.empty())
  {
    table = std::make_unique<MotionTable>(options.out);
  }
  const RunSummary summary = runClosedLoop(parameters, *source, table.get());
  if (table)
  {
    table->close();
  }
  print(summary, parameters.run.speed);
}
}  // namespace

int main(int argc, char** argv)
{
  try
  {
    std::vector<std::string> arguments;
    ros::removeROSArgs(argc, argv, arguments);
    arguments.erase(arguments.begin());
    const Options options = parseOptions(arguments);
    if (options.help)
    {
      std::cout << usage();
      return EXIT_SUCCESS;
    }
    if (options.contact != ContactWay::in_process)
    {
      ros::init(argc, argv, "simulate_wheelset");
    }
    run(options);
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error)
  {
    std::cerr << "simulate_wheelset: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
