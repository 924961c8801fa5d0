// What: `rbpa surface`: from a file of points in space to files of triangles and pictures.
#pragma once

#include "cli/surface_arguments.h"

namespace rbpa::app {

/// Throws WrongUsage before anything is read; BadInput, Failure, Cancelled. No file is left behind then.
void run_surface(const SurfaceArguments& arguments);

}  // namespace rbpa::app
