#include "rbpa/space/solid/boundary/check_triangulation.h"

#include "meshops/core/contract.h"
#include "rbpa/base/arrays/simplices_at.h"
#include "rbpa/base/error.h"
#include "rbpa/base/run/input.h"

namespace rbpa::space {

void check_triangulation(const std::string& function, std::span<const Point3> points, const Solid& delaunay,
                         std::span<const double> radii) {
  meshops::require_one_each(function, radii.size(), "radii", delaunay.simplices.size(), "tetrahedra");
  meshops::require(
      delaunay.neighbors.size() == radii.size(),
      (function + ": the triangulation has no neighbors, expected solid() with the option neighbors").c_str());
  meshops::require(
      corner_bound<4>(delaunay.simplices) <= points.size(),
      (function + ": a tetrahedron has a corner that is not a point, expected solid() of these points").c_str());
}

Threads check_triangulation(const std::string& function, std::span<const Point3> points, const Solid& delaunay,
                            std::span<const double> radii, double alpha, unsigned threads) {
  check_triangulation(function, points, delaunay, radii);
  if (!(alpha > 0)) throw InvalidInput("alpha is " + text(alpha) + ", expected a radius above 0, or infinity");
  return threads_for(points.size(), threads);
}

}  // namespace rbpa::space
