// What:   the topology of the full alpha complex of points in space, and its voids as a solid of their own.
// Law:    exact, for any finite input; a function of the set of points and alpha.
// How:    a void is a bounded component of what is outside of tetrahedra and triangles alike: a set of tetrahedra of the triangulation, connected
//         through triangles that are not in the complex.
// Cost:   about linear in the Delaunay triangulation; microseconds a simplex where points are cospherical.
// Source: Edelsbrunner and Mücke, Three-dimensional alpha shapes (1994); Delfinado and Edelsbrunner, An incremental algorithm for Betti numbers
//         of simplicial complexes on the 3-sphere (1995); docs/solid.md, section 11.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/solid.h"
#include "rbpa/surface.h"
#include "rbpa/voids.h"

namespace rbpa {

struct FullCounts {
  std::size_t points = 0, edges = 0, triangles = 0, tetrahedra = 0;  ///< of the complex
  std::size_t components = 0, tunnels = 0, voids = 0;                ///< Betti numbers 0 to 2
};

/// Requires: as dangling_faces() does. Throws: as dangling_faces() does; Cancelled when `go_on`, which here and below is called every few
///           milliseconds, by one thread at a time, returns false.
RBPA_API FullCounts count_full(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                               double alpha, unsigned threads = 0, const std::function<bool()>& go_on = {});

/// The voids: tetrahedra of the triangulation that are not in the complex, and cannot be left through triangles that are not. Its components
/// through triangles (solid_components()) are the voids, each with its volume; its boundary (solid_boundary()) is what is around them, seen from there,
/// where a triangle with a void on both sides comes twice. Points of no void are isolated.
/// Requires: as dangling_faces() does. Throws: as dangling_faces() does.
RBPA_API Solid void_space(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                          double alpha, unsigned threads = 0, const std::function<bool()>& go_on = {});

struct FullVoids {
  Surface boundary;  ///< around all of them, seen from within; a triangle with a void on both sides comes twice
  std::vector<SolidVoid> all;  ///< their triangles being those of this boundary; the largest volume first
};

/// The same, one by one, each also with the volume outside of the balls of radius alpha around the points. An island is
/// a piece of triangles within a void that are connected through points.
/// Requires: void_space() of these points at this alpha.
RBPA_API FullVoids full_voids(std::span<const Point3> points, const Solid& space, double alpha, unsigned threads = 0,
                              const std::function<bool()>& go_on = {});

}  // namespace rbpa
