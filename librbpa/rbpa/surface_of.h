// What: a Surface of triangles that come from elsewhere, for all that works on surfaces: surface_components(),
//       fill_holes(), close_surface(), refine_filling() and so on. Of a halfedge mesh: surface_mesh.h.
// Law:  a function of the points and the set of triangles. Two triangles that run along an edge in opposite directions
//       and are alone there are glued. Where more meet, sides that face each other are, as a ball rolls over them
//       (facing_sides.h; indexable_surface() parts bodies that touch along an edge); those of triangles that lie on each
//       other, or have no area, stay open. Exact.
// Cost: a sort of the points, the sides and the triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/surface.h"

namespace rbpa {

/// In canonical order, without levels.
struct SurfaceOfTriangles : Surface {
  std::vector<std::uint32_t> given;  ///< of each triangle: which of those that were given it is
};

/// Corners on equal points become the lowest of them. Triangles are neither turned nor dropped: those that run along an
/// edge in the same direction are not glued there (meshops::repair() makes a manifold of any).
/// Requires: finite points, fewer than 2^32 − 1; the corners of each triangle are three of the points, at different
///           places; fewer than 2^32 corners.
/// Throws:   InvalidInput that names what is not so.
RBPA_API SurfaceOfTriangles surface_of(std::span<const Point3> points,
                                       std::span<const std::array<std::uint32_t, 3>> triangles);

/// The same, glued as `neighbors` says: number k of a triangle is the one across from its corner k, or Surface::none.
/// Requires: also that each is a neighbor of its neighbors, across the side between the same corners. Throws
///           ContractViolation.
RBPA_API SurfaceOfTriangles surface_of(std::span<const Point3> points,
                                       std::span<const std::array<std::uint32_t, 3>> triangles,
                                       std::span<const std::array<std::uint32_t, 3>> neighbors);

}  // namespace rbpa
