#include "oracle/cgal_normals.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include <utility>
#include <vector>

namespace rbpa_test {

Points3 normals_by_cgal(const Points3& points, std::size_t neighbors) {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;
  std::vector<Oriented> all;
  for (const rbpa::Point3& p : points) all.push_back({{p.x, p.y, p.z}, {}});
  CGAL::pca_estimate_normals<CGAL::Sequential_tag>(
      all, static_cast<unsigned>(neighbors),
      CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
          .normal_map(CGAL::Second_of_pair_property_map<Oriented>()));
  Points3 normals;
  for (const auto& [at, normal] : all) normals.push_back({normal.x(), normal.y(), normal.z()});
  return normals;
}

}  // namespace rbpa_test
