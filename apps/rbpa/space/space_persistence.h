// What: reads points in space, and finds their radii and persistence pairs, for the verbs alpha and report.
#pragma once

#include <cstddef>
#include <functional>
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

/// Parses --dimension. Returns true for 3 and false for 2. Throws WrongUsage for other values.
bool is_in_space(const std::string& dimension);

/// Parses the options about the points. Throws WrongUsage that names a wrong value, or an option that applies only to
/// the plane.
SpacePointSource parse_space_points(const RadiiArguments& arguments);

struct SpacePersistence : Run {
  /// Reads the points, and finds radii and pairs. Prints warnings unless quiet. Throws WrongUsage for a wrong --threads
  /// or --cover, before it reads; BadInput, Failure, Cancelled.
  SpacePersistence(const SpacePointSource& source, const std::vector<std::string>& outputs,
                   const RadiiArguments& arguments);

  /// Returns the plateaus, the best first. Calls `beside` once, from any thread. Adds the time to the seconds of
  /// building. Throws Cancelled; what `beside` throws.
  std::vector<SolidPlateau> find_plateaus(const std::function<void(const GoOn&)>& beside);
  /// Frees the triangles and edges of the filtration.
  void drop_faces();
  void write_stats(OutputFile& file);

  SpacePoints file;
  SolidFiltration filtration;
  std::vector<SolidPair> pairs;
  double cover = 1;                 ///< share of the points that these radii cover
  double least = 0, automatic = 0;  ///< the radii "min" and "auto"

 private:
  double read_seconds_ = 0, build_seconds_ = 0;
};

}  // namespace rbpa::app
