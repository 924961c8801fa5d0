// What: what the command line of `rbpa solid` asks for, from text to meaning.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/alpha_choice.h"
#include "cli/arguments.h"
#include "cli/point_arguments.h"
#include "cli/run.h"
#include "cli/verbs.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"
#include "rbpa/solid.h"
#include "rbpa/solid_radii.h"
#include "rbpa/voids.h"

namespace rbpa::app {

/// A radius, or the rule by which the triangulation of the points gives it.
struct SolidAlpha {
  AlphaRule rule = AlphaRule::given;
  double radius = std::numeric_limits<double>::infinity();
  double cover = 1;      ///< share of the points, of a rule
  std::size_t rank = 1;  ///< of the plateau: the best is 1

  /// By a rule other than plateaus, of all tetrahedra.
  double choose(const Solid& delaunay, std::span<const double> radii) const {
    return rule == AlphaRule::least ? min_alpha(delaunay, radii, cover, until_interrupted())
                                    : auto_alpha(delaunay, radii, cover, until_interrupted());
  }
};

struct SolidRequest {
  SpacePointSource source;
  SolidAlpha alpha;
  std::optional<Point3> box;  ///< sides of a box that repeats; all 0 where they are those of the input's cell
  std::vector<Target> targets;
  std::optional<Target> boundary, voids, pockets;
  std::optional<Shift> shift = std::nullopt;  ///< of the boundary in single precision
  double voids_above = 0;
  std::size_t top = std::numeric_limits<std::size_t>::max();  ///< of voids, and of pockets
  VoidWalls walls;  ///< of voids: given by --complex; else full where voids are requested
  int width;
  RunOptions run;
};

/// Throws WrongUsage that names the option.
SolidRequest parse(const SolidArguments& arguments);

/// For progress: "12 M points, 1.2 M/s".
std::string text_of_progress(const Progress& progress, double seconds);

/// "alpha auto = 0.3".
std::string text_of(const SolidAlpha& alpha, double radius);

}  // namespace rbpa::app
