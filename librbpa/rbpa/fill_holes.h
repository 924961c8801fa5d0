// What:   holes of a triangle mesh in space closed by triangles between their corners, so that nothing crosses.
// How:    for each boundary loop the triangulation that turns least over its worst edge, then of the least area (Liepa 2003), on
//         condition that no new triangle crosses any other, which is decided exactly: where the best one would, its crossing
//         edges and triangles are forbidden and the next best is sought, a number of times.
//         Loops that cross the mesh each by itself are closed together where a strip of two triangles joins them: the hole
//         around an island.
// Law:    a function of the mesh as a set of points and triangles: of no order and no number of threads. No point is added.
// Cost:   for a loop of n edges n³/6 steps of nanoseconds up to 256 edges, about n times a thousand beyond; and a tree of the
//         triangles' boxes. Pairs of triangles whose boxes meet are compared; where there are more than thousands for each
//         triangle, the holes that come then stay open.
// Source: Liepa, Filling holes in meshes (2003); Barequet and Sharir, Filling gaps in the boundary of a polyhedron (1995).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/holes.h"
#include "rbpa/surface.h"

namespace rbpa {

/// What became of a hole, and if it stays open, why.
enum class HoleOutcome : std::uint8_t {
  filled,
  crosses,  ///< each triangulation that was tried crosses the mesh, or itself
  edge_taken,  ///< each triangulation has an edge between points that an edge joins already, which would have a third triangle
  no_area,        ///< each triangulation has a triangle without an area: all corners are on a line
  too_much_work,  ///< not all was tried: too many triangles are near each other
};

struct HoleFill {
  HoleOutcome outcome = HoleOutcome::filled;
  /// New; a loop that touches itself may be filled in part. Of loops that are closed together the longest has all.
  std::size_t triangles = 0;
  double area = 0;  ///< theirs, in squared units of the points
  friend bool operator==(const HoleFill&, const HoleFill&) = default;
};

struct HoleFilling {
  /// Those that were given, in their order, then the new ones, loop by loop; at last those that close several loops together.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<HoleFill> loops;  ///< of each
};

/// The boundary loops of triangles, as vertices with the triangles to the right, a hole to the left. Each begins with its least
/// vertex, and they are sorted.
/// Requires: an oriented manifold: no two triangles have a side from one vertex to the same other; at a vertex the triangles are
///           one fan.
/// Throws:   ContractViolation where that is visibly not so.
RBPA_API std::vector<std::vector<std::uint32_t>> boundary_loops(
    std::span<const std::array<std::uint32_t, 3>> triangles);

/// Closes some of the boundary loops. A loop that comes to the same point several times is closed part by part there; where
/// it does so at different vertices, they become one, the least, in all triangles.
/// Requires: finite points; triangles and loops as boundary_loops() has them. Triangles without an area cross nothing.
/// Throws:   InvalidInput when a point is not finite; ContractViolation; Cancelled.
RBPA_API HoleFilling fill_holes(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 3>> triangles,
                                std::span<const std::vector<std::uint32_t>> loops, const SurfaceOptions& options = {});

struct FilledSurface {
  Surface surface;              ///< without levels
  std::vector<bool> is_new;     ///< of each triangle
  std::vector<HoleFill> holes;  ///< of each curve
};

/// The same for boundary curves of a surface. Requires: an indexable_surface() (split_fans.h), and curves of it.
RBPA_API FilledSurface fill_holes(std::span<const Point3> points, const Surface& surface, std::span<const Hole> curves,
                                  const SurfaceOptions& options = {});

/// The boundary curves of any surface as holes() has them, without causes.
/// Throws: as surface_components(). `go_on`: as there.
RBPA_API std::vector<Hole> surface_curves(std::span<const Point3> points, const Surface& surface,
                                          const std::function<bool()>& go_on = {});

}  // namespace rbpa
