#include "rbpa/space/persistence/pairing/triangle_radii.h"

#include "rbpa/space/persistence/pairing/values_of_faces.h"

namespace rbpa::space {

std::vector<double> triangle_radii(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                                   const NumberedTriangles& triangles, Threads& threads, const GoOn& go_on) {
  return values_of_triangles(RadiusRule(points), delaunay, radii, triangles, threads, go_on);
}

}  // namespace rbpa::space
