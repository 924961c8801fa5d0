#include "oracle/cgal_natural_neighbors.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/natural_neighbor_coordinates_2.h>

#include <iterator>
#include <utility>
#include <vector>

namespace rbpa_test {

std::map<std::uint32_t, double> natural_neighbor_coordinates(std::span<const rbpa::Point> points,
                                                             const rbpa::Point& query) {
  using K = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  using P = K::Point_2;
  CGAL::Delaunay_triangulation_2<K> triangulation;
  std::map<P, std::uint32_t> number;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const P p(points[i].x, points[i].y);
    number[p] = i;
    triangulation.insert(p);
  }
  std::vector<std::pair<P, K::FT>> found;
  const K::FT sum =
      CGAL::natural_neighbor_coordinates_2(triangulation, P(query.x, query.y), std::back_inserter(found)).second;
  std::map<std::uint32_t, double> shares;
  for (const auto& [p, area] : found) shares[number.at(p)] = CGAL::to_double(K::FT(area / sum));
  return shares;
}

}  // namespace rbpa_test
