// What: peers in space and on polygons, run as their users do, each in a library of its own, so that nothing else is
//       compiled with their options.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "bench/measure.h"
#include "bench/surface_points.h"
#include "rbpa/base/point.h"
#include "rbpa/base/point3.h"
#include "rbpa/plane/constrained_delaunay.h"

namespace rbpa_bench {

/// Runs CGAL's Delaunay_triangulation_3: points alone, default options, one thread. Counts the finite cells of
/// circumradius at most alpha, in rounded numbers.
Run solid_by_cgal(std::span<const rbpa::Point3> points, double alpha);

/// Runs CGAL's Delaunay refinement of a ring: angles of at least 20.7° and no edge longer than `longest`.
Run fill_by_cgal(const std::vector<rbpa::Point>& ring, double longest);

/// Runs CGAL's Constrained_Delaunay_triangulation_2. Counts the finite triangles.
Run constrained_by_cgal(std::span<const rbpa::Point> points, std::span<const rbpa::Segment> segments);

/// Runs CGAL's Delaunay_triangulation_2, and lists the circumcenter of each triangle, rounded, and for each edge the
/// two points and the triangles beside it: the arrays of a Voronoi diagram. Counts the circumcenters.
Run voronoi_by_cgal(std::span<const rbpa::Point> points);

struct PersistenceRun {
  Run complex = {}, all = {};             ///< until the simplices have radii, and to the pairs
  std::array<std::size_t, 3> pairs = {};  ///< for each dimension, the number of pairs that last longer than rounding
};

/// Runs GUDHI's AlphaComplex with precision "fast", and cohomology with coefficients in Z/2.
PersistenceRun persistence_by_gudhi(std::span<const rbpa::Point3> points);

/// Returns Open3D's TriangleMesh::CreateFromPointCloudBallPivoting as a contestant, whose result is a mesh; nothing if
/// Open3D was not available at compile time. Converting our points is not timed.
std::optional<Contestant> open3d(const SurfacePoints& samples, double radius);

}  // namespace rbpa_bench
