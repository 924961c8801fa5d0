// What: what the verbs alpha and report share of points in space: from a file to all radii and pairs.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cli/point_arguments.h"
#include "cli/run.h"
#include "cli/verbs.h"
#include "io/cloud/read_space_points.h"
#include "rbpa/solid_filtration.h"
#include "rbpa/solid_persistence.h"
#include "rbpa/solid_plateaus.h"

namespace rbpa::app {

/// Of `--dimension`. Throws WrongUsage.
bool is_in_space(const std::string& dimension);

/// Throws WrongUsage naming an option that was given and has no meaning in space, or the value of one.
SpacePointSource parse_space_points(const RadiiArguments& arguments);

struct SpacePersistence : Run {
  /// Reads the points, and finds radii and pairs. Throws BadInput, Failure, Cancelled.
  SpacePersistence(const SpacePointSource& source, const std::vector<std::string>& outputs,
                   const RadiiArguments& arguments);

  /// Counts as building.
  std::vector<SolidPlateau> find_plateaus();
  /// The stats.
  void write_stats(OutputFile& file);

  SpacePoints file;
  SolidFiltration filtration;
  std::vector<SolidPair> pairs;
  double least = 0, automatic = 0;  ///< "min" and "auto"

 private:
  double read_seconds_ = 0, build_seconds_ = 0;
};

}  // namespace rbpa::app
