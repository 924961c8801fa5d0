// What: reconstructs a surface from points in space in one call: leaves outliers out, estimates normals, chooses radii,
//       rolls the ball, keeps components, fills holes or makes the surface watertight, and explains where it ends.
// How:  calls, as far as the options say, outliers(), scale_space(), estimate_normals_and_confidence(), auto_radii(),
//       surface() or exposed_triangles(), unused_points(), radius_with_triangles(), holes(), suggested_repairs(),
//       indexable_surface(), choose_components(), fill_holes() or make_watertight(), and refine_filling(), in this
//       order.
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

/// The steps whose begin is announced. `counting` stands for all other work, and is announced several times. With
/// `watertight`, `filling` includes refining.
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
  std::optional<double> outlier_factor = {};  ///< leaves out the outliers() by this factor; absent: no point
  /// Moves the points by so many steps of scale_space(); 0: scale_space() chooses the number. Absent: no step.
  std::optional<std::size_t> scale_space = {};
  bool moved = false;                       ///< whether the result has the moved points in place of the given ones
  std::vector<Point3> normals = {};         ///< one for each point, or none
  std::optional<NormalSource> source = {};  ///< absent: given normals if there are any, else estimated ones
  /// Number of nearest other points from which a normal is estimated.
  std::size_t neighbors = NormalOptions{}.neighbors;
  std::vector<Point3> viewpoints = {};  ///< toward which normals are turned: none, one, or one for each point
  bool flip = false;                    ///< turns all normals around
  /// The radii of the balls, ascending; without normals one. Empty: auto_radii(), without normals the last of them.
  std::vector<double> radii = {};
  /// Limit for the radii of auto_radii(): larger ones are replaced by it. Given radii are not limited.
  double max_radius = std::numeric_limits<double>::infinity();
  /// Finds the unused points and the causes of boundary curves; if there is no triangle, also a radius at which there
  /// are some.
  bool explain = false;
  bool repairs = false;                   ///< suggests repairs of holes; implies `explain`
  ComponentChoice components = {};        ///< a choice of shells requires the source `none`
  bool manifold = false;                  ///< takes the indexable_surface(), as `filled` and `watertight` do
  std::optional<HoleChoice> filled = {};  ///< fills these holes; absent: none
  bool watertight = false;                ///< make_watertight() of the kept components, in place of `filled`
  bool refine = false;                    ///< refines the fillings
  MaxThreads threads = 0;
  /// Called repeatedly, as the functions of the steps do; the number of triangles is that of the step. Returning false
  /// cancels the run.
  OnProgress progress = {};
  /// Called by the calling thread when a step begins, never at the same time as `progress`.
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
  std::size_t scale_space = 0;           ///< number of steps
  Outliers outliers = {};                ///< points left out
  std::vector<UnusedPoint> unused = {};  ///< with `explain` or `repairs`: before components are dropped
  /// A radius with triangles where the given radii have none; absent: auto_radii() have none either, or it was not
  /// looked for.
  std::optional<double> larger_ball = {};
  /// The components, with measures by `points`. Computed, as are `holes` and `kinds`, only with `explain`, `repairs`,
  /// `manifold`, `filled`, `watertight` or a choice of components.
  SurfaceComponents components = {};
  /// The boundary curves. Causes are known only with `explain` or `repairs`, and without `watertight`; edges that
  /// became boundary later have none. An edge without a known cause has the default one. Lengths are those between the
  /// points over which the ball rolled, unless fillings were refined: then by `points`.
  std::vector<Hole> holes = {};
  std::vector<CurveKind> kinds = {};  ///< for each of `holes`
  /// With `repairs`, one entry for each of `holes`; absent if its kind is not `hole`. The repair is of kind `none` also
  /// if the curve has changed since it was sought.
  std::vector<std::optional<SuggestedRepair>> repairs = {};
  DroppedComponents dropped = {};       ///< all 0, the totals too, if nothing was dropped, except with `watertight`
  std::vector<HoleFill> fillings = {};  ///< of each hole that was to be filled
  std::vector<bool> filled = {};        ///< for each triangle whether it fills a hole; empty: none does
  std::size_t given_up = 0;             ///< number of triangles removed by `watertight`, islands not counted
  AddedPoints added = {};               ///< points that refining added
  /// With `watertight`, the pairs of triangles that cross, sorted: the first most_crossing_pairs (watertight.h).
  std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing = {};
  /// For each component, the number of others inside which it lies. Empty unless the surface is made watertight.
  std::vector<std::size_t> inside = {};

  /// Returns whether there are triangles, none at a boundary, and none that cross. Requires: the option `watertight`.
  bool is_watertight() const { return !surface.triangles.empty() && holes.empty() && crossing.empty(); }
};

/// Reconstructs a surface.
/// Requires: finite points, fewer than 2^32 − 1, and what the steps require of their options.
/// Throws:   InvalidInput that names the violated requirement; Cancelled.
RBPA_API Reconstruction reconstruct(std::vector<Point3> points, ReconstructionOptions options = {});

/// Replaces each point number i in the reconstruction by number[i]; arrays keep their order.
/// Requires: ascending numbers, one for each point.
RBPA_API void renumber(Reconstruction& made, std::span<const std::uint32_t> number);

}  // namespace rbpa
