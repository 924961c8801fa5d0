#include "rbpa/space/levels/excerpt.h"

#include <algorithm>
#include <cstddef>

#include "rbpa/space/search/cells.h"

namespace rbpa::space {

Excerpt excerpt(std::span<const Point3> points, std::span<const Point3> normals, std::span<const Duplicate> duplicates,
                const std::vector<std::uint8_t>& wanted, double radius) {
  std::vector<std::uint8_t> is_near(points.size(), 0), is_distinct(points.size(), 1);
  for (const Duplicate& d : duplicates) is_distinct[d.index] = 0;
  std::vector<std::uint32_t> distinct;
  std::vector<Point3> places;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (is_distinct[i] != 0) {
      distinct.push_back(i);
      places.push_back(points[i]);
    }

  const Cells cells(places, radius);
  std::vector<std::uint8_t> is_taken(cells.size(), 0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto inside = cells.points_in(i);
    if (std::none_of(inside.begin(), inside.end(), [&](std::uint32_t p) { return wanted[distinct[p]] != 0; })) continue;
    cells.for_each_around(i, [&](std::size_t cell) { is_taken[cell] = 1; });
  }
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (is_taken[i] != 0)
      for (const std::uint32_t p : cells.points_in(i)) is_near[distinct[p]] = 1;
  for (const Duplicate& d : duplicates) is_near[d.index] = is_near[d.stands_for];

  Excerpt result;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (is_near[i] == 0) continue;
    result.input.push_back(i);
    result.points.push_back(points[i]);
    if (!normals.empty()) result.normals.push_back(normals[i]);
  }
  return result;
}

}  // namespace rbpa::space
