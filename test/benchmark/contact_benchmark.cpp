// SPDX-License-Identifier: BSD-3-Clause
// Speed of complete evaluations, of their steps and of contact_replay. To report medians:
//   contact_benchmark --benchmark_repetitions=9 --benchmark_report_aggregates_only
#include <benchmark/benchmark.h>

#include "benchmarks.h"

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
  {
    return 1;
  }
  wheel_rail_contact::registerWheelsets();
  wheel_rail_contact::registerLines();
  wheel_rail_contact::registerSteps();
  wheel_rail_contact::registerReplay();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
