#include "oracle/cgal_periodic.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>

#include <algorithm>
#include <cstddef>
#include <map>

namespace rbpa_test {

std::vector<std::array<PeriodicCorner, 4>> periodic_by_cgal(std::span<const rbpa::Point3> points, double side) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Delaunay = CGAL::Periodic_3_Delaunay_triangulation_3<CGAL::Periodic_3_Delaunay_triangulation_traits_3<Kernel>>;
  Delaunay delaunay(Delaunay::Iso_cuboid(0, 0, 0, side, side, side));
  std::map<std::array<double, 3>, int> number;
  std::vector<Delaunay::Point> all;
  for (const rbpa::Point3& p : points) {
    number.emplace(std::array{p.x, p.y, p.z}, static_cast<int>(all.size()));
    all.emplace_back(p.x, p.y, p.z);
  }
  delaunay.insert(all.begin(), all.end());
  std::vector<std::array<PeriodicCorner, 4>> result;
  for (auto t = delaunay.periodic_tetrahedra_begin(Delaunay::UNIQUE);
       t != delaunay.periodic_tetrahedra_end(Delaunay::UNIQUE); ++t) {
    std::array<PeriodicCorner, 4> row{};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& [point, offset] = (*t)[k];
      row[k] = {number.at({point.x(), point.y(), point.z()}), offset[0], offset[1], offset[2]};
    }
    std::sort(row.begin(), row.end());
    const PeriodicCorner first = row[0];
    for (PeriodicCorner& corner : row)
      for (std::size_t axis = 1; axis < 4; ++axis) corner[axis] -= first[axis];
    result.push_back(row);
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace rbpa_test
