#include <cmath>

#include "meshops/core/contract.h"
#include "rbpa/space/repair/refine_filling.h"

namespace rbpa {

std::vector<Point3> normals_between(std::span<const Point3> normals,
                                    std::span<const std::array<std::uint32_t, 3>> between) {
  std::vector<Point3> added;
  for (const auto& corners : between) {
    Point3 sum = {0, 0, 0}, first = {0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      meshops::require(corners[k] < normals.size() + added.size(),
                       "normals_between: a point lies between points that come after it, expected earlier ones");
      const Point3& n = corners[k] < normals.size() ? normals[corners[k]] : added[corners[k] - normals.size()];
      const double length = std::hypot(n.x, n.y, n.z);
      const Point3 unit = {n.x / length, n.y / length, n.z / length};
      if (k == 0) first = unit;
      sum = {sum.x + unit.x, sum.y + unit.y, sum.z + unit.z};
    }
    const double length = std::hypot(sum.x, sum.y, sum.z);
    added.push_back(length > 0 ? Point3{sum.x / length, sum.y / length, sum.z / length} : first);
  }
  return added;
}

}  // namespace rbpa
