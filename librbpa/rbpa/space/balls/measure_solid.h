// What: computes and measures the solid of points in space at a given or chosen radius, in one call: boundary, volume
//       and area, Betti numbers, voids, components, and the union of balls.
// How:  calls solid(), circumradii(), choose_solid_alpha(), within(), solid_boundary(), measure(), voids(),
//       full_topology(), solid_components() and union_of_balls(), in this order, as far as the options require.
// Law:  a function of the points and options, not of the number of threads.
// Cost: the sum of the steps. A rule, `full` and `triangulation` require all tetrahedra of the points; `balls` computes
//       all tetrahedra once more.
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

/// The steps of measure_solid(), each announced when it begins. `counting`: measures, voids, full complex, components.
enum class SolidStep : std::uint8_t { tetrahedra, choosing, boundary, counting, balls };

struct MeasureSolidOptions {
  AlphaChoice alpha = {};      ///< a radius, by default infinity, or a rule
  bool boundary = true;        ///< finds the boundary triangles
  bool counts = true;          ///< measures, counts and finds voids of the solid; implies `boundary`
  bool full = false;           ///< counts the full complex, and finds its voids in place of those of the solid
  bool balls = false;          ///< measures the union of balls of radius alpha, unless alpha is infinity
  bool components = false;     ///< lists the solid components; implies `boundary`
  bool triangulation = false;  ///< keeps all tetrahedra and their radii even if neither a rule nor `full` needs them
  MaxThreads threads = 0;
  /// Called repeatedly while tetrahedra are computed, as SolidOptions::progress. Later, Progress::triangles is 0; calls
  /// are repeated while the radius is chosen, the full complex is counted (unless all points are in a plane), and the
  /// tetrahedra of the balls are computed, and otherwise made only between steps. Returning false cancels the run.
  OnProgress progress = {};
  /// Called by the calling thread when a step begins, never at the same time as `progress`.
  std::function<void(SolidStep)> on_step = {};
};

struct MeasuredSolid {
  /// The complex at `alpha`; has neighbors if a boundary or all tetrahedra were needed.
  Solid solid = {};
  double alpha = 0;                         ///< the radius, given or chosen; infinity if a rule finds no tetrahedron
  std::vector<SolidPlateau> plateaus = {};  ///< all plateaus, the best first, if the rule is `plateau`
  Solid triangulation = {};                 ///< all tetrahedra of the points, if they were needed
  std::vector<double> radii = {};           ///< circumradii of the tetrahedra of `triangulation`
  SolidBoundary boundary = {};              ///< with `boundary`, `counts` or `components`
  BoundaryMeasures measures = {};           ///< with `counts`: volume and area of the solid
  SolidCounts counts = {};                  ///< with `counts`: simplices and Betti numbers of the solid
  std::optional<FullCounts> full = {};      ///< with `full`: simplices and Betti numbers of the full complex
  /// The voids, the largest volume first: voids of the full complex with `full`, else voids of the solid with `counts`.
  /// Their triangles are numbered in around_voids().
  std::vector<SolidVoid> voids = {};
  Surface full_void_boundary = {};              ///< the walls of the voids of the full complex
  std::optional<BallUnion> balls = {};          ///< with `balls`; absent if alpha is infinite
  std::vector<SolidComponent> components = {};  ///< with `components`; the largest volume first

  /// Returns the surface whose triangles the voids refer to.
  const Surface& around_voids() const { return full ? full_void_boundary : boundary.surface; }
};

/// Computes the solid at the radius of the options, and the results that the options request.
/// Requires: what solid() requires; for rules that take a cover, 0 < cover ≤ 1; for the rule `plateau`, a rank from 1
///           to the number of plateaus if there are any; for `balls`, what union_of_balls() requires.
/// Throws:   InvalidInput that names the violated requirement; ContractViolation if a rule takes a cover that is not
///           above 0 and at most 1; Cancelled.
RBPA_API MeasuredSolid measure_solid(std::span<const Point3> points, const MeasureSolidOptions& options = {});

}  // namespace rbpa
