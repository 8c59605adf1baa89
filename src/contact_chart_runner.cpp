// SPDX-License-Identifier: BSD-3-Clause
// Measures every method on every grid in the scenes of the chart. Writes the results to standard output:
// comma-separated values under a header line, in SI units. Lines that begin with # contain information on the build and
// the progress. Called by contact_chart, which draws the results.
//
//   contact_chart_runner [--quick]
#include <cstdio>
#include <cstring>
#include <exception>

#include "chart/gap_scene.h"
#include "chart/rows.h"
#include "chart/wheelset_scene.h"

namespace
{
using namespace wheel_rail_contact::core::chart;

Plan quickPlan()
{
  return {2, 0.005, true, {128, 256}, {64, 128}, 1};
}

void run(const Plan& plan)
{
  std::printf("# version: %s\n# compiler: %s\n# build: %s\n", CHART_VERSION, CHART_COMPILER, CHART_BUILD_TYPE);
  std::printf("# truth: %d x %d\n# reach: %g mm\n", plan.truth.along, plan.truth.across, 1e3 * plan.reach * step);
  writeHeader(stdout);
  std::fflush(stdout);
  std::vector<std::unique_ptr<Scene>> scenes = gapScenes();
  for (std::unique_ptr<Scene>& scene : wheelsetScenes())
  {
    scenes.push_back(std::move(scene));
  }
  const std::vector<Choice> choices = allChoices();
  const int total = static_cast<int>(scenes.size()) * stepsOf(plan);
  int done = 0;
  for (const std::unique_ptr<Scene>& scene : scenes)
  {
    const Result result = compare(*scene, choices, plan,
                                  [&]
                                  {
                                    std::printf("# progress: %d %d %s\n", ++done, total, scene->title().c_str());
                                    std::fflush(stdout);
                                  });
    writeRows(stdout, *scene, result);
  }
}
}  // namespace

int main(int argc, char** argv)
{
  const bool quick = argc == 2 && std::strcmp(argv[1], "--quick") == 0;
  if (argc > 1 && !quick)
  {
    std::fprintf(stderr, "usage: contact_chart_runner [--quick]\n");
    return 2;
  }
  try
  {
    run(quick ? quickPlan() : Plan());
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "contact_chart_runner: %s\n", error.what());
    return 1;
  }
  return 0;
}
