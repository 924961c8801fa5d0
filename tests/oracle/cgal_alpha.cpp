#include "oracle/cgal_alpha.h"

#include <CGAL/Alpha_shape_2.h>
#include <CGAL/Alpha_shape_face_base_2.h>
#include <CGAL/Alpha_shape_vertex_base_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <cmath>

namespace rbpa_test {

ProposedAlphas cgal_alphas(std::span<const rbpa::Point> points, std::span<const std::size_t> max_components) {
  using K = CGAL::Exact_predicates_exact_constructions_kernel;
  using Storage =
      CGAL::Triangulation_data_structure_2<CGAL::Alpha_shape_vertex_base_2<K>, CGAL::Alpha_shape_face_base_2<K>>;
  using Shape = CGAL::Alpha_shape_2<CGAL::Delaunay_triangulation_2<K, Storage>>;
  std::vector<K::Point_2> at;
  for (const rbpa::Point& p : points) at.emplace_back(p.x, p.y);
  Shape shape(at.begin(), at.end(), K::FT(0), Shape::REGULARIZED);

  const auto radius = [](const K::FT& squared) { return std::sqrt(CGAL::to_double(squared.exact())); };
  ProposedAlphas alphas{radius(shape.find_alpha_solid()), {}};
  for (const std::size_t k : max_components) {
    auto found = shape.find_optimal_alpha(k);
    if (found != shape.alpha_begin()) {
      const auto before = found - 1;
      if (*before >= shape.find_alpha_solid() && shape.number_of_solid_components(*before) <= k) found = before;
    }
    alphas.optimal.push_back(radius(*found));
  }
  return alphas;
}

}  // namespace rbpa_test
