// What: `rbpa mesh`: from a file of points to files of triangles and pictures.
#pragma once

#include <optional>
#include <string>

#include "cli/complex_run.h"

namespace rbpa::app {

/// What the command line says, as text; run_mesh() judges it.
struct MeshArguments : ComplexArguments {
  std::string complex = "solid";
  std::optional<std::string> levels;
  bool compact = false;
};

/// Throws WrongUsage before anything is read; BadInput, Failure, Cancelled. No file is left behind then.
void run_mesh(const MeshArguments& arguments);

}  // namespace rbpa::app
