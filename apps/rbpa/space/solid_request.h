// What: parses the command line of `rbpa solid`.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "rbpa/base/alpha_choice.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"
#include "rbpa/space/solid/voids.h"
#include "shared/arguments.h"
#include "shared/point_arguments.h"
#include "shared/run.h"
#include "shared/verbs.h"

namespace rbpa::app {

struct SolidRequest {
  SpacePointSource source;
  AlphaChoice alpha;
  std::optional<Point3> box;  ///< sides of the periodic box; all 0 for --box auto, the cell of the input
  std::vector<Target> targets;
  std::optional<Target> boundary, voids, pockets;
  std::optional<Shift> shift = std::nullopt;  ///< shift of files of the boundary in single precision
  double voids_above = 0;
  std::size_t top =
      std::numeric_limits<std::size_t>::max();  ///< the most voids, and the most pockets, that are written
  ComplexKind walls;  ///< kind of the complex whose voids are counted; by default full for --voids, --pockets and
                      ///< --box, else solid
  int width;
  RunOptions run;
};

/// Parses the arguments. Throws WrongUsage that names the option.
SolidRequest parse(const SolidArguments& arguments);

/// Returns a text such as "12.0 M points, 1.20 M/s" for the progress line after `seconds`.
std::string text_of_progress(const Progress& progress, double seconds);

/// Returns a text such as "alpha auto = 0.3".
std::string text_of(const AlphaChoice& alpha, double radius);

}  // namespace rbpa::app
