// SPDX-License-Identifier: BSD-3-Clause
#include "chart/rows.h"

#include "chart/quantile.h"

namespace wheel_rail_contact::core::chart
{
namespace
{
void writeRow(std::FILE* out, const Scene& scene, double truth_error, const Choice& choice, const char* start,
              const Series& series)
{
  const bool run = series.status != Series::Status::not_run;
  const bool known = series.status == Series::Status::solved;
  const GridSize& grid = choice.isAutomatic() ? series.outcome.grid : choice.grid;
  std::fprintf(out, R"(%s,"%s",%s,%s,%d,%d,%g,%s,%s,"%s",)", scene.name().c_str(), scene.title().c_str(), scene.kind(),
               toString(choice.method), grid.along, grid.across, choice.tolerance, start, toString(series.status),
               series.reason.c_str());
  std::fprintf(out, "%.4g,%.4g,%.4g,", quantile(series.times, 0.5), quantile(series.times, 0.25),
               quantile(series.times, 0.75));
  if (series.longest() > 0)
  {
    std::fprintf(out, "%.4g", series.longest());
  }
  std::fprintf(out, ",%zu,", run ? series.times.size() : 0);
  if (known)
  {
    const Errors& errors = series.errors;
    std::fprintf(out, "%.4g,%.4g,%.4g,%.4g,%.4g,", errors.largest(), errors.max_pressure, errors.area, errors.approach,
                 series.estimate());
  }
  else
  {
    std::fputs(",,,,,", out);
  }
  std::fprintf(out, "%.4g\n", truth_error);
}
}  // namespace

void writeHeader(std::FILE* out)
{
  std::fputs(
      "scene,title,kind,method,cells_along,cells_across,tolerance,start,status,reason,time,time_quartile_1,"
      "time_quartile_3,time_longest,samples,error,error_max_pressure,error_area,error_approach,error_estimate,truth_"
      "error\n",
      out);
}

void writeRows(std::FILE* out, const Scene& scene, const Result& result)
{
  for (const Entry& entry : result.entries)
  {
    writeRow(out, scene, result.truth_error, entry.choice, "cold", entry.cold);
    writeRow(out, scene, result.truth_error, entry.choice, "warm", entry.warm);
  }
}
}  // namespace wheel_rail_contact::core::chart
