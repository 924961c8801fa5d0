// What: reads points, and finds their critical and recommended radii, for the verbs alpha and report.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rbpa/plane/delaunay.h"
#include "report/radii.h"
#include "shared/run.h"
#include "shared/stats.h"
#include "shared/verbs.h"

namespace rbpa::app {

/// Parses --components and --cover into a Radii whose other members have their defaults. Throws WrongUsage that names
/// the value.
Radii parse_radii(const RadiiArguments& arguments);

/// Sets filtration, least_covering and least_connected of `radii`, and with `with_plateaus` also plateaus. Requires:
/// max_components and cover are set. Throws Cancelled after a signal.
void find_radii(const Delaunay& delaunay, Radii& radii, bool with_plateaus);

/// Returns the reason why the points have no triangle at any radius, or nothing if they have a triangle.
std::optional<std::string> why_no_radius(const Filtration& filtration);

struct RadiiRun : Run {
  /// Reads the points, and finds their radii with the settings of `request`. Prints warnings unless quiet. Throws
  /// BadInput, Failure, Cancelled.
  RadiiRun(const PointSource& source, const std::vector<std::string>& outputs, const RunOptions& options,
           const Radii& request, bool with_plateaus);

  /// Writes the report of --stats. Requires: all other files are written, so that the time of writing is known.
  void write_stats(OutputFile& file);
  /// Prints why the points have no radius, even if quiet; prints nothing if they have one.
  void say_empty() const;

  PointFile file;
  Radii radii;
  Stats stats = {};

  /// Returns the triangulation of file.points.
  const Delaunay& delaunay() const { return *delaunay_; }

 private:
  std::optional<Delaunay> delaunay_ = std::nullopt;
};

}  // namespace rbpa::app
