// What: what the verbs alpha and report share: from points to all radii that follow from them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/run.h"
#include "cli/stats.h"
#include "cli/verbs.h"
#include "rbpa/delaunay.h"
#include "report/radii.h"

namespace rbpa::app {

/// How many components, and what share of the points. Throws WrongUsage naming the value.
Radii parse_radii(const RadiiArguments& arguments);

/// What of the radii follows from a triangulation: all but `points`. Throws Cancelled after a signal.
void find_radii(const Delaunay& delaunay, Radii& radii, bool with_plateaus);

/// Why the points have no triangle at any radius, if so.
std::optional<std::string> why_no_radius(const Filtration& filtration);

struct RadiiRun : Run {
  /// Reads the points, and finds what of the radii follows from them. Throws BadInput, Failure, Cancelled.
  RadiiRun(const PointSource& source, const std::vector<std::string>& outputs, const RunOptions& options,
           const Radii& request, bool with_plateaus);

  /// The stats, once all other files are written.
  void write_stats(OutputFile& file);
  /// Prints why there is no radius, if there is none.
  void say_empty() const;

  PointFile file;
  Radii radii;
  Stats stats = {};

  /// Of the points of `file`.
  const Delaunay& delaunay() const { return *delaunay_; }

 private:
  std::optional<Delaunay> delaunay_ = std::nullopt;
};

}  // namespace rbpa::app
