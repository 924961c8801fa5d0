#include "oracle/delaunay.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

#include "oracle/circumradius.h"

namespace rbpa_test {
namespace {

template <typename K>
std::vector<Triangle> delaunay(std::span<const rbpa::Point> points) {
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, K>;
  using Storage = CGAL::Triangulation_data_structure_2<VertexBase, CGAL::Triangulation_face_base_2<K>>;
  CGAL::Delaunay_triangulation_2<K, Storage> triangulation;

  const std::vector<std::uint32_t> lowest = lowest_equal(points);
  std::vector<std::pair<typename K::Point_2, std::uint32_t>> distinct;
  distinct.reserve(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (lowest[i] == i) distinct.push_back({typename K::Point_2(points[i].x, points[i].y), i});
  triangulation.insert(distinct.begin(), distinct.end());  // sorts along a Hilbert curve

  std::vector<Triangle> triangles;
  triangles.reserve(triangulation.number_of_faces());
  for (const auto face : triangulation.finite_face_handles())
    triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return canonical(std::move(triangles));
}

}  // namespace

Kernel fitting_kernel(std::span<const rbpa::Point> points) {
  const auto moderate = [](double value) {
    return value == 0 || (std::abs(value) < 0x1p150 && std::abs(value) > 0x1p-150);
  };
  const bool fits =
      std::all_of(points.begin(), points.end(), [&](const rbpa::Point& p) { return moderate(p.x) && moderate(p.y); });
  return fits ? Kernel::filtered : Kernel::rational;
}

DelaunayOracle::DelaunayOracle(std::span<const rbpa::Point> points, Kernel kernel)
    : points_(points.begin(), points.end()),
      delaunay_(kernel == Kernel::filtered ? delaunay<CGAL::Exact_predicates_inexact_constructions_kernel>(points)
                                           : delaunay<CGAL::Simple_cartesian<CGAL::Exact_rational>>(points)) {}

std::vector<Triangle> DelaunayOracle::triangles(double alpha) const {
  std::vector<Triangle> kept;
  kept.reserve(delaunay_.size());
  std::copy_if(delaunay_.begin(), delaunay_.end(), std::back_inserter(kept), [&](const Triangle& t) {
    return circumradius_at_most(points_[t[0]], points_[t[1]], points_[t[2]], alpha);
  });
  return kept;
}

}  // namespace rbpa_test
