// What: computes the solid of points in space at a given or chosen radius with what is to be known of it, in one call:
//       boundary, volume and area, Betti numbers, voids, components, balls.
// How:  calls solid(), choose_solid_alpha(), within(), solid_boundary(), measure(), voids(), full_topology(),
//       union_of_balls() and solid_components(), as far as the options say.
// Law:  as of these: a function of the points and options, not of the number of threads.
// Cost: the sum of the steps. A rule, the full complex and `triangulation` need all tetrahedra of the points.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/alpha_choice.h"
#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"
#include "rbpa/space/balls/full_topology.h"
#include "rbpa/space/balls/union_of_balls.h"
#include "rbpa/space/persistence/solid_plateaus.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/solid/solid_boundary.h"
#include "rbpa/space/solid/solid_components.h"
#include "rbpa/space/solid/solid_topology.h"
#include "rbpa/space/solid/voids.h"

namespace rbpa {

/// The steps whose begin is announced.
enum class SolidStep : std::uint8_t { tetrahedra, choosing, boundary, counting, balls };

struct MeasureSolidOptions {
  AlphaChoice alpha = {};      ///< a radius, by default infinity, or a rule
  bool boundary = true;        ///< finds the boundary
  bool counts = true;          ///< measures, counts and finds voids; implies `boundary`
  bool full = false;           ///< counts the full complex too, and finds its voids in place of those of the solid
  bool balls = false;          ///< measures the union of balls of radius alpha, unless it is infinity
  bool components = false;     ///< lists the solid components
  bool triangulation = false;  ///< keeps all tetrahedra and their radii even if neither a rule nor `full` needs them
  /// Maximum number of threads, the calling one included. 0 = all processors; larger values are capped.
  unsigned threads = 0;
  /// Called repeatedly, as SolidOptions::progress. Returning false cancels the run.
  OnProgress progress = {};
  /// Called by the calling thread when a step begins, between two calls of `progress`.
  std::function<void(SolidStep)> on_step = {};
};

struct MeasuredSolid {
  Solid solid = {};
  double alpha = 0;                         ///< given or chosen; infinity if a rule finds no tetrahedron
  std::vector<SolidPlateau> plateaus = {};  ///< all of them, the best first, if the rule is `plateau`
  Solid triangulation = {};                 ///< all tetrahedra of the points, if they were needed
  std::vector<double> radii = {};           ///< circumradii of the tetrahedra of `triangulation`
  SolidBoundary boundary = {};
  BoundaryMeasures measures = {};
  SolidCounts counts = {};
  std::optional<FullCounts> full = {};
  std::vector<SolidVoid> voids = {};  ///< the largest volume first; their triangles are those of around_voids()
  Surface full_void_boundary = {};    ///< the walls of the voids of the full complex
  std::optional<BallUnion> balls = {};
  std::vector<SolidComponent> components = {};

  /// Returns the surface whose triangles are numbered by the voids.
  const Surface& around_voids() const { return full ? full_void_boundary : boundary.surface; }
};

/// Computes the solid.
/// Requires: as solid(); a rank of a plateau that exists; for `full` and `balls`, as full_topology(), union_of_balls().
/// Throws:   InvalidInput that names the violated requirement; Cancelled.
RBPA_API MeasuredSolid measure_solid(std::span<const Point3> points, const MeasureSolidOptions& options = {});

}  // namespace rbpa
