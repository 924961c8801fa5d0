#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "bench/peers.h"

namespace rbpa_bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Constrained = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>,
                                                 CGAL::Delaunay_mesh_face_base_2<Kernel>>>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Constrained>;

Constrained constrained(const std::vector<rbpa::Point>& ring) {
  std::vector<Kernel::Point_2> places;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    places.emplace_back(ring[i].x, ring[i].y);
    edges.emplace_back(i, (i + 1) % ring.size());
  }
  Constrained result;
  result.insert_constraints(places.begin(), places.end(), edges.begin(), edges.end());
  return result;
}

}  // namespace

Run fill_by_cgal(const std::vector<rbpa::Point>& ring, double longest) {
  const Stopwatch watch;
  Constrained mesh = constrained(ring);
  constexpr double usual_shape = 0.125;  // the squared sine of 20.7°
  CGAL::Delaunay_mesher_2<Constrained, Criteria> mesher(mesh, Criteria(usual_shape, longest));
  mesher.refine_mesh();
  Run run = watch.run(0);
  for (const auto face : mesh.finite_face_handles()) run.count += face->is_in_domain() ? 1U : 0U;
  return run;
}

Run solid_by_cgal(std::span<const rbpa::Point3> points, double alpha) {
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
  return watch.run(count);
}

}  // namespace rbpa_bench
