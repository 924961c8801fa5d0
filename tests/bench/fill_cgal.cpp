#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "bench/fill_contest.h"
#include "bench/stopwatch.h"

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

FillRun fill_by_cgal(const std::vector<rbpa::Point>& ring, double longest) {
  const Stopwatch watch;
  Constrained mesh = constrained(ring);
  constexpr double usual_shape = 0.125;  // the squared sine of 20.7°
  CGAL::Delaunay_mesher_2<Constrained, Criteria> mesher(mesh, Criteria(usual_shape, longest));
  mesher.refine_mesh();
  const double seconds = watch.processor_seconds();
  std::size_t triangles = 0;
  for (const auto face : mesh.finite_face_handles()) triangles += face->is_in_domain() ? std::size_t{1} : 0;
  return {triangles, seconds};
}

FillRun triangulate_by_cgal(const std::vector<rbpa::Point>& ring) {
  const Stopwatch watch;
  const Constrained mesh = constrained(ring);
  return {mesh.number_of_faces(), watch.processor_seconds()};
}

}  // namespace rbpa_bench
