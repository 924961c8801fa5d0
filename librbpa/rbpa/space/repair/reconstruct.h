// What: reconstructs a surface from points in space in one call: leaves out outliers, estimates normals, chooses radii,
//       rolls the ball, drops components, fills holes or makes the surface watertight, decimates the surface, and
//       explains where it ends.
// How:  calls, in this order and as far as the options require: outliers(), scale_space(),
//       estimate_normals_and_confidence() or turn_toward(), auto_radii(), surface() or exposed_triangles(),
//       unused_points(), radius_with_triangles(), holes(), suggested_repairs(), indexable_surface(),
//       choose_components(), fill_holes() or make_watertight(), refine_filling(), and decimate().
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
#include "rbpa/space/normals/estimate_normals.h"
#include "rbpa/space/repair/refine_filling.h"
#include "rbpa/space/repair/suggested_repairs.h"
#include "rbpa/space/simplify/decimate.h"
#include "rbpa/space/surface/curve_kinds.h"
#include "rbpa/space/surface/outliers.h"
#include "rbpa/space/surface/surface_components.h"
#include "rbpa/space/surface/unused_points.h"

namespace rbpa {

/// The normals that decide on which side the ball rolls.
enum class NormalSource : std::uint8_t {
  given,     ///< the normals of the options
  estimate,  ///< estimated normals, also if the options have normals
  none,      ///< no normals: the result is the exposed_triangles() of one radius
};

/// The steps of reconstruct(), each announced when it begins. `larger_ball` is the search for a radius that has
/// triangles. `counting` stands for all other work, and is announced several times. With the option `watertight`,
/// `filling` includes refining.
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
  decimating,
};

struct ReconstructionOptions {
  std::optional<double> outlier_factor = {};  ///< factor of outliers() to leave out; if absent, all points are kept
  /// Number of steps of scale_space() that move the points; 0 if scale_space() is to choose. If absent, the points do
  /// not move.
  std::optional<std::size_t> scale_space = {};
  bool moved = false;                       ///< whether the result has the moved points in place of the given ones
  std::vector<Point3> normals = {};         ///< one for each point, or none
  std::optional<NormalSource> source = {};  ///< if absent: `given` if there are normals, else `estimate`
  /// Number of nearest other points from which a normal is estimated.
  std::size_t neighbors = NormalOptions{}.neighbors;
  std::vector<Point3> viewpoints = {};  ///< places toward which normals are turned: none, one, or one for each point
  bool flip = false;                    ///< reverses all normals, unless the source is `none`
  /// The radii of the balls, strictly ascending; one radius if the source is `none`. If empty, the auto_radii() are
  /// taken; with the source `none`, only the last of them.
  std::vector<double> radii = {};
  /// Upper limit, above 0, to which radii of auto_radii() are cut. Given radii are not limited.
  double max_radius = std::numeric_limits<double>::infinity();
  /// Finds the unused points and the causes of boundary curves; if there is no triangle, also a radius that has some.
  bool explain = false;
  bool repairs = false;             ///< suggests repairs for curves of kind `hole`; implies `explain`
  ComponentChoice components = {};  ///< a choice of shells requires the source `none`
  /// Replaces the surface by its indexable_surface(); `filled` and `watertight` imply this.
  bool manifold = false;
  std::optional<HoleChoice> filled = {};  ///< fills the holes of this choice; if absent, none
  bool watertight = false;                ///< calls make_watertight() for the kept components; then `filled` is ignored
  bool refine = false;                    ///< refines the fillings of `filled` or `watertight` by refine_filling()
  /// Decimates the surface by these options. `go_on` is not used. With `watertight`, no collapse makes triangles cross,
  /// so the surface stays watertight. `holes`, `kinds`, `repairs`, `fillings` and `crossing` of the result, and the
  /// triangle numbers in them, are those of the surface before decimation.
  std::optional<DecimationOptions> decimation = {};
  MaxThreads threads = 0;
  /// Called repeatedly by the functions of the steps, with their Progress. Returning false cancels the run.
  OnProgress progress = {};
  /// Called by the calling thread when a step begins, never at the same time as `progress`.
  std::function<void(ReconstructionStep)> on_step = {};
};

/// A surface, and intermediate results. Point numbers are input indices, followed by numbers of added points.
struct Reconstruction {
  Surface surface;
  std::vector<Point3> points;  ///< position of each point, added points included
  /// A normal for each point; for an outlier, the given normal or 0. Empty if normals were neither given nor estimated.
  std::vector<Point3> normals;
  std::vector<double> confidence;  ///< one for each normal, 0 for outliers; empty if no normal was estimated
  NormalSource source = NormalSource::given;
  std::vector<double> radii;    ///< given or chosen; empty if auto_radii() finds none: the ball then has radius 1
  std::size_t distinct = 0;     ///< number of distinct points over which the ball rolled
  std::size_t scale_space = 0;  ///< number of steps of scale_space()
  Outliers outliers = {};       ///< the points that were left out
  std::vector<UnusedPoint> unused = {};  ///< with `explain` or `repairs`; without points of dropped components
  /// A radius that has triangles, if the radii used have none; absent if no such radius was found or sought.
  std::optional<double> larger_ball = {};
  /// The components, with measures by `points`. `components`, `holes` and `kinds` are computed only with `explain`,
  /// `repairs`, `manifold`, `filled`, `watertight` or a choice of components.
  SurfaceComponents components = {};
  /// The boundary curves. Causes are known only with `explain` or `repairs`, and without `watertight`. An edge without
  /// a known cause, or one that became boundary later, has the default cause. Lengths are between the points over which
  /// the ball rolled, or between `points` if fillings were refined.
  std::vector<Hole> holes = {};
  std::vector<CurveKind> kinds = {};  ///< the kind of each of `holes`
  /// With the option `repairs`, one entry for each of `holes`, absent if the kind of the curve is not `hole`. A repair
  /// is also of kind `none` if the curve changed after the repair was sought.
  std::vector<std::optional<SuggestedRepair>> repairs = {};
  /// Counts of dropped components. If none was dropped, the totals are 0, too, except with `watertight`.
  DroppedComponents dropped = {};
  /// The outcome for each hole that was to be filled, in the order of the boundary curves before filling.
  std::vector<HoleFill> fillings = {};
  std::vector<bool> filled = {};  ///< for each triangle, whether it fills a hole; empty if no hole was to be filled
  std::optional<Decimation> decimated = {};  ///< counts of the decimation, if there was one
  std::size_t given_up = 0;  ///< number of triangles that were removed from kept components with `watertight`
  AddedPoints added = {};    ///< points that refining added
  /// With `watertight`, the pairs of crossing triangles, sorted: the first most_crossing_pairs (watertight.h).
  std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing = {};
  /// With `watertight`, for each component, the number of other components around it; empty unless is_watertight().
  std::vector<std::size_t> inside = {};

  /// Returns whether there are triangles, none at a boundary, and none that cross. Requires: the option `watertight`.
  bool is_watertight() const { return !surface.triangles.empty() && holes.empty() && crossing.empty(); }
};

/// Reconstructs a surface from points, by the steps that the options request.
/// Requires: finite points, fewer than 2^32 − 1, and what the steps require of their options.
/// Throws:   InvalidInput that names the violated requirement; ContractViolation when an option of the decimation is
///           out of its range, or refining leads to 2^31 points or triangles; Cancelled.
RBPA_API Reconstruction reconstruct(std::vector<Point3> points, ReconstructionOptions options = {});

/// Replaces each point number i in `made` by number[i]. Arrays keep their order.
/// Requires: `number` ascends and has an entry for each point of `made`; neither is checked.
RBPA_API void renumber(Reconstruction& made, std::span<const std::uint32_t> number);

}  // namespace rbpa
