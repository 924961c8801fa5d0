// What: reconstructs a surface from points in space in one call: leaves outliers out, estimates normals, chooses radii,
//       rolls the ball, keeps components, fills holes or makes the surface watertight, and explains where it ends.
// How:  calls, as far as the options say, outliers(), scale_space(), estimate_normals_and_confidence(), auto_radii(),
//       surface(), unused_points(), holes(), suggested_repairs(), kept_components(), fill_holes() or make_watertight(),
//       and refine_filling(), in this order.
// Law:  a function of the points and options, not of the number of threads.
// Cost: the sum of the steps; without options, that of the normals, radii and surface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"
#include "rbpa/space/repair/refine_filling.h"
#include "rbpa/space/repair/suggested_repairs.h"
#include "rbpa/space/surface/curve_kinds.h"
#include "rbpa/space/surface/estimate_normals.h"
#include "rbpa/space/surface/outliers.h"
#include "rbpa/space/surface/surface_components.h"
#include "rbpa/space/surface/unused_points.h"

namespace rbpa {

/// The normals that decide on which side the ball rolls.
enum class NormalSource : std::uint8_t {
  given,
  estimate,
  none,  ///< the ball rolls on all sides that it can reach: exposed_triangles(), of one radius
};

/// The steps whose begin is announced; `counting` is any work between two others.
enum class ReconstructionStep : std::uint8_t {
  outliers,
  scale_space,
  normals,
  radii,
  rolling,
  unused,
  holes,
  repairs,
  larger_ball,
  counting,
  filling,
  refining,
};

struct ReconstructionOptions {
  std::optional<double> outlier_factor = {};    ///< leaves out the outliers() by this factor; absent: no point
  std::optional<std::size_t> scale_space = {};  ///< moves points by so many steps of scale_space(); absent: no point
  bool moved = false;                           ///< the result has the moved points; false: the given ones
  std::vector<Point3> normals = {};             ///< one for each point, or none
  std::optional<NormalSource> source = {};      ///< absent: given normals if there are any, else estimated ones
  std::size_t neighbors = NormalOptions{}.neighbors;  ///< number of points from which a normal is estimated
  std::vector<Point3> viewpoints = {};  ///< toward which normals are turned: none, one, or one for each point
  bool flip = false;                    ///< turns all normals around
  std::vector<double> radii = {};       ///< ascending; empty: auto_radii(), without normals the last of them
  double most_radius = std::numeric_limits<double>::infinity();  ///< replaces chosen radii above it
  bool explain = false;  ///< finds unused points and the causes of boundary curves, or a radius that has triangles
  bool repairs = false;  ///< suggests repairs of holes; implies `explain`
  ComponentChoice components = {};        ///< a choice of shells requires the source `none`
  bool manifold = false;                  ///< takes the indexable_surface(), as filling and closing do
  std::optional<HoleChoice> filled = {};  ///< fills these holes; absent: none
  bool watertight = false;                ///< makes the kept components watertight, in place of `filled`
  bool refine = false;                    ///< refines the fillings
  MaxThreads threads = 0;
  /// Called repeatedly during each step, as SurfaceOptions::progress. Returning false cancels the run.
  OnProgress progress = {};
  /// Called by the calling thread when a step begins, between two calls of `progress`.
  std::function<void(ReconstructionStep)> on_step = {};
};

/// A surface, and what was found on the way. Point numbers are input indices; added points follow all of these.
struct Reconstruction {
  Surface surface;
  std::vector<Point3> points;      ///< place of each point, the added ones included
  std::vector<Point3> normals;     ///< of each point, for outliers the given ones or 0; empty: there are none
  std::vector<double> confidence;  ///< of each estimated normal, for outliers 0; empty: none is estimated
  NormalSource source = NormalSource::given;
  std::vector<double> radii;  ///< given or chosen; empty if none could be chosen, as there is no triangle at any radius
  std::size_t distinct = 0;   ///< number of distinct points over which the ball rolled
  std::size_t scale_space = 0;  ///< number of steps
  Outliers outliers = {};       ///< points left out
  std::vector<UnusedPoint> unused = {};
  /// A radius with triangles where the given radii have none; absent: auto_radii() have none either, or it was not
  /// looked for.
  std::optional<double> larger_ball = {};
  /// The components, by `points`, and the boundary curves with their kinds. Only if options call for them: `explain`, a
  /// choice of components, filling or closing.
  SurfaceComponents components = {};
  std::vector<Hole> holes = {};
  std::vector<CurveKind> kinds = {};
  std::vector<std::optional<SuggestedRepair>> repairs = {};  ///< for each of `holes` of kind hole, if requested
  DroppedComponents dropped = {};
  std::vector<HoleFill> fillings = {};  ///< of each hole that was to be filled
  std::vector<bool> filled = {};        ///< for each triangle whether it fills a hole; empty: none does
  std::size_t given_up = 0;             ///< number of triangles removed by closing
  AddedPoints added = {};               ///< by refining
  /// With `watertight`: pairs of triangles that cross, at most most_crossing_pairs; and, if the surface is watertight,
  /// for each component inside how many others it lies.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing = {};
  std::vector<std::size_t> inside = {};

  /// Returns whether there are triangles, none at a boundary, and none that cross. Requires: the option `watertight`.
  bool is_watertight() const { return !surface.triangles.empty() && holes.empty() && crossing.empty(); }
};

/// Reconstructs a surface.
/// Requires: finite points, fewer than 2^32 − 1, and what the steps require of their options.
/// Throws:   InvalidInput that names the violated requirement; Cancelled.
RBPA_API Reconstruction reconstruct(std::vector<Point3> points, ReconstructionOptions options = {});

/// Replaces each point number i in the reconstruction by number[i], except in `added`; arrays keep their order.
/// Requires: ascending numbers, one for each point.
RBPA_API void renumber(Reconstruction& made, std::span<const std::uint32_t> number);

}  // namespace rbpa
