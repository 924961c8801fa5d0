// What: parses the command line of `rbpa surface`.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/mesh/single_precision.h"
#include "rbpa/base/point3.h"
#include "shared/arguments.h"
#include "shared/point_arguments.h"
#include "shared/run.h"
#include "shared/verbs.h"
#include "triangulation/component_choice.h"
#include "triangulation/hole_choice.h"

namespace rbpa::app {

enum class NormalSource { file, estimate, none };

struct SurfaceRequest {
  SpacePointSource source;
  std::vector<double> radii;               ///< empty: auto
  std::optional<double> most_radius;       ///< the largest radius that auto may choose
  std::size_t neighbors;                   ///< from which a normal is estimated
  std::vector<Point3> viewpoints;          ///< one or none; none if columns of the file have one for each point
  std::optional<NormalSource> normals;     ///< absent: those of the file if it has any, else estimated
  bool colors_normals;                     ///< colors show the confidence of normals
  std::optional<double> outlier_factor;    ///< absent: no point is left out
  std::optional<std::size_t> scale_space;  ///< steps, 0 for auto; absent: none
  ComponentChoice components;
  std::optional<HoleChoice> filled;  ///< absent: no hole is filled
  std::vector<Target> targets;
  std::optional<Shift> shift;  ///< of targets in single precision
  int width;
  RunOptions run;
};

/// Parses the arguments. Throws WrongUsage that names the option.
SurfaceRequest parse(const SurfaceArguments& arguments);

}  // namespace rbpa::app
