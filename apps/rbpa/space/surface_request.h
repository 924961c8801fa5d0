// What: parses the command line of `rbpa surface`.
#pragma once

#include <optional>
#include <vector>

#include "io/mesh/single_precision.h"
#include "rbpa/space/repair/reconstruct.h"
#include "shared/arguments.h"
#include "shared/point_arguments.h"
#include "shared/run.h"
#include "shared/verbs.h"

namespace rbpa::app {

struct SurfaceRequest {
  SpacePointSource source;
  ReconstructionOptions how = {};  ///< without the data of the file: normals, and viewpoints from columns
  bool colors_normals = false;     ///< whether colors show the confidence of normals
  std::vector<Target> targets = {};
  std::optional<Shift> shift = {};  ///< shift of targets in single precision
  int width = 0;
  RunOptions run = {};
};

/// Parses the arguments. Throws WrongUsage that names the option.
SurfaceRequest parse(const SurfaceArguments& arguments);

}  // namespace rbpa::app
