// What:   closes holes of a triangle mesh in space by triangles between corners of the holes; no new triangle crosses
//         another.
// How:    for each boundary loop, finds the triangulation that turns least over its worst edge, and among several the
//         one of least area (Liepa 2003). No new triangle may cross any other, which is decided exactly: if the best
//         triangulation crosses something, its crossing edges and triangles are forbidden, and the next best one is
//         sought, 10 to 100 times. Loops that cannot be closed alone without a crossing, such as the two loops of a
//         hole with an island in it, are closed together if a strip of two triangles can join the loops.
// Law:    the result is a function of the mesh as a set of points and triangles, not of any order or number of threads.
//         No point is added.
// Cost:   for each triangulation of a loop of n edges, n³/6 steps of a few nanoseconds up to 256 edges, about 1000 n
//         beyond; and a tree of the bounding boxes of triangles. Triangles whose boxes meet are compared pair by pair,
//         at most 2²⁴ pairs plus 4096 for each triangle. Holes that remain after that many pairs stay open.
// Source: Liepa, Filling holes in meshes (2003); Barequet and Sharir, Filling gaps in the boundary of a polyhedron
//         (1995).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/surface/curve_kinds.h"
#include "rbpa/space/surface/holes.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa {

/// The outcome for a hole: filled, or the reason why it stays open.
enum class HoleOutcome : std::uint8_t {
  filled,   ///< the hole is closed
  crosses,  ///< each triangulation that was tried crosses the mesh or itself
  /// Each triangulation that was tried gives a third triangle to an edge that exists already.
  edge_taken,
  no_area,        ///< each triangulation has a triangle of no area, because corners are on a line
  too_much_work,  ///< not all triangulations were tried, because too many triangles are near each other
};

/// The outcome for a hole, and the size of its filling.
struct HoleFill {
  HoleOutcome outcome = HoleOutcome::filled;
  /// Number of new triangles. May be above 0 for other outcomes than `filled`: a loop that touches itself may be filled
  /// in part. If loops are closed together, one of the loops counts all triangles, the others 0.
  std::size_t triangles = 0;
  double area = 0;  ///< area of the new triangles, in squared units of the points
  friend bool operator==(const HoleFill&, const HoleFill&) = default;
};

/// The result of fill_holes() of loops.
struct HoleFilling {
  /// The given triangles in order; then new ones, loop by loop; then triangles that close several loops together.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<HoleFill> loops;  ///< the outcome for each given loop
};

/// Returns the boundary loops of triangles as lists of vertices, with the triangles to the right and a hole to the
/// left. Each loop begins with its least vertex; the loops are sorted.
/// Requires: `triangles` are an oriented manifold: each has three different corners, no directed side has two
///           triangles, and the triangles at a vertex form one fan.
/// Throws:   ContractViolation when two triangles have a side in the same direction, or several boundary curves pass
///           through a vertex. The rest is not checked.
/// Cost:     a sort of the sides; memory for each vertex up to the greatest.
RBPA_API std::vector<std::vector<std::uint32_t>> boundary_loops(
    std::span<const std::array<std::uint32_t, 3>> triangles);

/// Closes the given boundary loops. A loop that visits a point several times is cut at the point, and the parts are
/// closed one by one. If a closed part has several vertices at a point, the lowest replaces the others everywhere.
/// Requires: finite points, fewer than 2^32 − 1; `loops` of `triangles`, in the form of boundary_loops(), in any order.
/// Throws:   InvalidInput that names the violated requirement on points; ContractViolation when a corner is not an
///           index of a point, a loop is empty or has an edge that is not a boundary side, or the loops contain an edge
///           twice; Cancelled.
RBPA_API HoleFilling fill_holes(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 3>> triangles,
                                std::span<const std::vector<std::uint32_t>> loops, const SurfaceOptions& options = {});

/// The result of fill_holes() of a surface.
struct FilledSurface {
  Surface surface;              ///< the surface with the new triangles, in canonical order; without levels
  std::vector<bool> is_new;     ///< for each triangle, whether it is new; the others keep their order
  std::vector<HoleFill> holes;  ///< the outcome for each given curve

  /// Returns whether some hole is filled.
  bool has_filled() const {
    return std::any_of(holes.begin(), holes.end(), [](const HoleFill& h) { return h.outcome == HoleOutcome::filled; });
  }
};

/// Closes the given boundary curves of a surface, as fill_holes() of loops does.
/// Requires: `surface` is an indexable_surface() (split_fans.h) of `points`; `curves` are boundary curves of `surface`.
/// Throws:   what fill_holes() of loops throws; ContractViolation when the curves are visibly of another surface.
RBPA_API FilledSurface fill_holes(std::span<const Point3> points, const Surface& surface, std::span<const Hole> curves,
                                  const SurfaceOptions& options = {});

/// Closes the boundary curves that `choice` chooses, of the indexable_surface() of any surface of `points`. `holes` has
/// the outcomes for the chosen curves, in the order of the surface_curves() of the indexable surface.
/// Throws: what fill_holes() of loops throws; ContractViolation as require_linked() (triangle_arrays.h) throws it.
RBPA_API FilledSurface fill_holes(std::span<const Point3> points, const Surface& surface, const HoleChoice& choice,
                                  const SurfaceOptions& options = {});

}  // namespace rbpa
