#include "rbpa/space/levels/neighborhood_subset.h"

#include <algorithm>
#include <cstddef>

#include "rbpa/base/distinct.h"
#include "rbpa/space/cells/cells.h"

namespace rbpa::space {

NeighborhoodSubset neighborhood_subset(std::span<const Point3> points, std::span<const Point3> normals,
                                       std::span<const Duplicate> duplicates, const std::vector<std::uint8_t>& wanted,
                                       double radius) {
  std::vector<std::uint8_t> is_near(points.size(), 0);
  std::vector<std::uint32_t> distinct;
  std::vector<Point3> places;
  for_each_distinct(points.size(), duplicates, [&](std::uint32_t i) {
    distinct.push_back(i);
    places.push_back(points[i]);
  });

  Threads threads;
  const Cells cells(places, radius, threads);
  const auto index_of = [&](Site site) { return distinct[cells.input_index()[site]]; };
  Cells::Around around(cells);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    bool is_wanted = false;
    for (Site p = cells.first_in(i); p < cells.first_in(i + 1); ++p) is_wanted = is_wanted || wanted[index_of(p)] != 0;
    if (is_wanted)
      around.for_each_run(i, [&](Site first, Site last) {
        for (Site p = first; p < last; ++p) is_near[index_of(p)] = 1;
      });
  }
  for (const Duplicate& d : duplicates) is_near[d.index] = is_near[d.stands_for];

  NeighborhoodSubset result;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (is_near[i] == 0) continue;
    result.input.push_back(i);
    result.points.push_back(points[i]);
    if (!normals.empty()) result.normals.push_back(normals[i]);
  }
  return result;
}

}  // namespace rbpa::space
