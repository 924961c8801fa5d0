// What: makes a Surface of triangles from any source, for functions on surfaces such as surface_components(),
//       fill_holes(), close_surface() and refine_filling(); see surface_mesh.h for halfedge meshes.
// Law:  exact; a function of the points and the triangles. Two triangles are glued along an edge if they run along the
//       edge in opposite directions and no other triangle has the edge. At an edge of more triangles, sides that face
//       each other are glued, as a ball rolls over them (facing_sides.h); except sides of triangles without area, and
//       of triangles that lie on each other with equal orientation. indexable_surface() separates bodies that touch
//       along an edge.
// Cost: a sort of the points, the sides and the triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa {

/// A surface in canonical order, without levels.
struct SurfaceOfTriangles : Surface {
  std::vector<std::uint32_t> given;  ///< for each triangle, its number among the given triangles
};

/// Glues triangles to a surface. Of equal points, the one of lowest index becomes the corner. Triangles are neither
/// reversed nor dropped; triangles that run along an edge in one direction are not glued. To make a manifold of any
/// triangles, call meshops::repair().
/// Requires: finite points, fewer than 2^32 − 1; the corners of each triangle are three of the points, at different
///           places; fewer than 2^32 corners.
/// Throws:   InvalidInput that names the violated requirement.
RBPA_API SurfaceOfTriangles surface_of(std::span<const Point3> points,
                                       std::span<const std::array<std::uint32_t, 3>> triangles);

/// Glues triangles to a surface as `neighbors` specifies: neighbors[t][k] is the triangle across from corner k of
/// triangle t, or Surface::none.
/// Requires: what surface_of() without neighbors requires; each triangle is a neighbor of its neighbors, across the
///           side between the same corners.
/// Throws:   InvalidInput that names the violated requirement; ContractViolation if it is about `neighbors`.
RBPA_API SurfaceOfTriangles surface_of(std::span<const Point3> points,
                                       std::span<const std::array<std::uint32_t, 3>> triangles,
                                       std::span<const std::array<std::uint32_t, 3>> neighbors);

}  // namespace rbpa
