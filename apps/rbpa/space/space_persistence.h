// What: the part that the verbs alpha and report share for points in space: reading them, and finding radii and pairs.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/cloud/read_space_points.h"
#include "rbpa/space/persistence/solid_filtration.h"
#include "rbpa/space/persistence/solid_persistence.h"
#include "rbpa/space/persistence/solid_plateaus.h"
#include "shared/point_arguments.h"
#include "shared/run.h"
#include "shared/verbs.h"

namespace rbpa::app {

/// Parses --dimension: returns true for 3, false for 2. Throws WrongUsage for other values.
bool is_in_space(const std::string& dimension);

/// Parses the options about the points. Throws WrongUsage that names an option without meaning in space, or a wrong
/// value.
SpacePointSource parse_space_points(const RadiiArguments& arguments);

struct SpacePersistence : Run {
  /// Reads the points, and finds radii and pairs. Throws BadInput, Failure, Cancelled.
  SpacePersistence(const SpacePointSource& source, const std::vector<std::string>& outputs,
                   const RadiiArguments& arguments);

  /// Returns the plateaus, the best first. The seconds that it takes are added to those of building.
  std::vector<SolidPlateau> find_plateaus();
  void write_stats(OutputFile& file);

  SpacePoints file;
  SolidFiltration filtration;
  std::vector<SolidPair> pairs;
  double least = 0, automatic = 0;  ///< the radii "min" and "auto"

 private:
  double read_seconds_ = 0, build_seconds_ = 0;
};

}  // namespace rbpa::app
