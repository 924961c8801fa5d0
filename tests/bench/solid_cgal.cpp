#include "bench/solid_cgal.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <vector>

#include "bench/stopwatch.h"

namespace rbpa_bench {

SolidRun solid_by_cgal(std::span<const rbpa::Point3> points, double alpha) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> own;
  own.reserve(points.size());
  for (const rbpa::Point3& p : points) own.emplace_back(p.x, p.y, p.z);
  const Stopwatch watch;
  const CGAL::Delaunay_triangulation_3<Kernel> delaunay(own.begin(), own.end());
  std::size_t count = 0;
  if (std::isinf(alpha)) {
    count = delaunay.number_of_finite_cells();
  } else if (delaunay.dimension() == 3) {
    for (auto c = delaunay.finite_cells_begin(); c != delaunay.finite_cells_end(); ++c)
      count += CGAL::squared_radius(c->vertex(0)->point(), c->vertex(1)->point(), c->vertex(2)->point(),
                                    c->vertex(3)->point()) <= alpha * alpha;
  }
  return {count, watch.processor_seconds()};
}

}  // namespace rbpa_bench
