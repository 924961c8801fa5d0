// What: makes a surface of points in space watertight as far as possible, and tests exactly whether each side has a
//       neighbor and no triangles cross.
// How:  drops the islands, fills all boundary curves as close_surface() does, refines the fillings on request, and
//       lists the curves that stay open and the crossing_triangles().
// Law:  a function of the points and the triangles, not of any order or number of threads.
// Cost: that of close_surface(), of refine_filling() on request, and of crossing_triangles().
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/repair/close_surface.h"
#include "rbpa/space/repair/refine_filling.h"
#include "rbpa/space/surface/holes.h"
#include "rbpa/space/surface/surface.h"
#include "rbpa/space/surface/surface_components.h"

namespace rbpa {

/// Maximum number of pairs of crossing triangles that make_watertight() lists.
inline constexpr std::size_t most_crossing_pairs = 1000;

struct WatertightOptions {
  const SurfaceComponents* components = nullptr;  ///< the surface_components(), if they are known
  /// For each component of the surface, whether it may stay. If empty, all may.
  std::vector<bool> kept = {};
  /// The final position of each point, by which fillings are refined and crossings found. If empty, the given position.
  /// Holes are filled by the given positions. The two differ if scale_space() moved the points.
  std::span<const Point3> places = {};
  bool refine = false;  ///< refines the fillings
};

/// A surface closed as far as possible. `kept` has a flag for each triangle of the given surface, islands included.
struct WatertightSurface : ClosedSurface {
  std::vector<bool> components = {};  ///< for each component of the given surface, whether it stays
  AddedPoints added = {};             ///< points inside refined fillings; none without `refine`
  /// Boundary curves that stay open. `holes` has the reasons, in the order of the curves before filling. Lengths are
  /// between the given points, or between `places` if fillings are refined.
  std::vector<Hole> open = {};
  /// Pairs of triangles that cross, sorted: the first most_crossing_pairs.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing = {};

  /// Returns whether there are triangles, none of them at a boundary, and none that cross.
  bool is_watertight() const { return !surface.triangles.empty() && open.empty() && crossing.empty(); }
};

/// Drops islands and the components that may not stay, and closes the surface as far as possible. The result lists
/// dropped components, open curves and crossing triangles.
/// Requires: `surface` is a surface of `points`; options.components, if given, are its components; options.kept has one
///           value for each component, or none; options.places one for each point, or none.
/// Throws:   what close_surface(), refine_filling() and crossing_triangles() throw; ContractViolation when sizes do not
///           match.
RBPA_API WatertightSurface make_watertight(std::span<const Point3> points, const Surface& surface,
                                           const WatertightOptions& options = {}, const SurfaceOptions& run = {});

}  // namespace rbpa
