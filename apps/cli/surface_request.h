// What: what the command line of `rbpa surface` asks for, from text to meaning.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/arguments.h"
#include "cli/point_arguments.h"
#include "cli/run.h"
#include "cli/verbs.h"
#include "io/mesh/single_precision.h"
#include "rbpa/base/point3.h"
#include "triangulation/component_choice.h"
#include "triangulation/hole_choice.h"

namespace rbpa::app {

enum class NormalSource { file, estimate, none };

struct SurfaceRequest {
  SpacePointSource source;
  std::vector<double> radii;               ///< empty: auto
  std::optional<double> most_radius;       ///< of auto
  std::size_t neighbors;                   ///< of which normals are estimated
  std::vector<Point3> viewpoints;          ///< one or none; none where columns of the file have one of each point
  std::optional<NormalSource> normals;     ///< absent: of the file if it has any, else estimated
  bool colors_normals;                     ///< by their certainty
  std::optional<double> outlier_factor;    ///< absent: no point is left out
  std::optional<std::size_t> scale_space;  ///< steps, 0 for auto; absent: none
  ComponentChoice components;
  std::optional<HoleChoice> filled;  ///< absent: none are filled
  std::vector<Target> targets;
  std::optional<Shift> shift;  ///< of those in single precision
  int width;
  RunOptions run;
};

/// Throws WrongUsage that names the option.
SurfaceRequest parse(const SurfaceArguments& arguments);

}  // namespace rbpa::app
