// A program that uses arrays, in the plane and in space, without a mesh. It includes all headers that need no mesh.
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "rbpa/fill/polygons_of_rings.h"
#include "rbpa/fill/validity.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/boundary_curves.h"
#include "rbpa/plane/collinear.h"
#include "rbpa/plane/corner_polygon.h"
#include "rbpa/plane/filtration.h"
#include "rbpa/plane/filtration_arrays.h"
#include "rbpa/plane/level_topology.h"
#include "rbpa/plane/link_triangles.h"
#include "rbpa/plane/locate.h"
#include "rbpa/plane/outline_polygons.h"
#include "rbpa/plane/partial.h"
#include "rbpa/plane/partial_bytes.h"
#include "rbpa/plane/persistence.h"
#include "rbpa/plane/plateaus.h"
#include "rbpa/plane/polygon_of_points.h"
#include "rbpa/plane/region.h"
#include "rbpa/plane/smallest_covering_alpha.h"
#include "rbpa/plane/topology.h"
#include "rbpa/space/normals/estimate_normals.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/surface/auto_radii.h"
#include "rbpa/space/surface/facing_sides.h"
#include "rbpa/space/surface/holes.h"
#include "rbpa/space/surface/rolling_ball.h"
#include "rbpa/space/surface/surface.h"
#include "rbpa/space/surface/surface_levels.h"
#include "rbpa/space/surface/unused_points.h"

int main() {
  const std::vector<rbpa::Point> points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {9, 9}};
  rbpa::AlphaComplexOptions options;
  options.neighbors = true;
  const rbpa::AlphaComplex found = rbpa::alpha_complex(points, 1, options);
  const bool has_triangles = found.triangles == std::vector<std::array<std::uint32_t, 3>>{{0, 1, 3}, {1, 2, 3}} &&
                             found.neighbors[0][0] == 1 && found.neighbors[1][1] == 0 &&
                             found.isolated == std::vector<std::uint32_t>{4};
  std::puts(has_triangles ? "two triangles" : "not the triangles that are expected");

  const std::vector<rbpa::Polygon> polygons = rbpa::outline_polygons(points, found);
  const auto delaunay = rbpa::alpha_complex(points, std::numeric_limits<double>::infinity(), options);
  const rbpa::Filtration filtration = rbpa::filtration(delaunay, points);
  const bool has_shape = polygons.size() == 1 && polygons[0].area == 1 && filtration.steps.front().triangles == 2 &&
                         !rbpa::plateaus(delaunay, points, filtration).empty() &&
                         rbpa::persistence(delaunay, points, filtration).front().dimension == 0;
  std::puts(has_shape ? "a square" : "not the shape that is expected");

  std::vector<rbpa::Point3> sphere;
  for (int i = 0; i < 200; ++i) {
    const double z = (2 * i + 1) / 200.0 - 1, r = std::sqrt(1 - z * z);
    sphere.push_back({r * std::cos(2.4 * i), r * std::sin(2.4 * i), z});
  }
  const std::vector<rbpa::Point3> normals = rbpa::estimate_normals(sphere);
  const rbpa::Surface surface = rbpa::surface(sphere, normals, 0.5);
  const bool is_closed = surface.triangles.size() == 396;  // 2 n - 4
  std::puts(is_closed ? "a sphere" : "not the surface that is expected");

  sphere.push_back({0, 0, 0});
  const rbpa::Solid solid = rbpa::solid(sphere, 0.6);
  const bool is_full = solid.simplices.size() == 396;  // each triangle with the center
  std::puts(is_full ? "a ball" : "not the solid that is expected");
  return has_triangles && has_shape && is_closed && is_full ? 0 : 1;
}
