#include "rbpa/space/full/check_triangulation.h"

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/base/input.h"

namespace rbpa::space {

Threads check_triangulation(const std::string& function, std::span<const Point3> points, const Solid& delaunay,
                            std::span<const double> radii, double alpha, unsigned threads) {
  meshops::require(radii.size() == delaunay.simplices.size(),
                   (function + ": expected a radius for each tetrahedron").c_str());
  meshops::require(delaunay.neighbors.size() == radii.size(),
                   (function + ": the triangulation has no neighbors").c_str());
  if (!(alpha > 0)) throw InvalidInput("alpha is " + text(alpha) + ", expected a radius above 0, or infinity");
  if (delaunay.simplices.empty() && delaunay.distinct > 1)
    throw InvalidInput("the points are in a plane, expected some that have a tetrahedron");
  return threads_for(points.size(), threads);
}

}  // namespace rbpa::space
