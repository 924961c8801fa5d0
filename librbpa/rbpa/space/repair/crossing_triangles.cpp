#include "rbpa/space/repair/crossing_triangles.h"

#include <algorithm>
#include <mutex>
#include <string>

#include "meshops/core/contract.h"
#include "meshops/core/progress.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/space/cells/box_tree.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/predicate/crossing.h"
#include "rbpa/space/predicate/orientation.h"

namespace rbpa {

std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing_triangles(
    std::span<const Point3> points, std::span<const std::array<std::uint32_t, 3>> triangles, std::size_t most,
    const SurfaceOptions& options) {
  space::check_points(points);
  for (const std::array<std::uint32_t, 3>& t : triangles)
    for (const std::uint32_t vertex : t)
      if (vertex >= points.size())
        throw meshops::ContractViolation("crossing_triangles: found corner " + std::to_string(vertex) +
                                         " of triangle " + std::to_string(&t - triangles.data()) +
                                         ", expected an index below " + std::to_string(points.size()) +
                                         ", the number of points");
  std::vector<space::Corners> corners;
  std::vector<space::Box> boxes;
  std::vector<std::uint32_t> number;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const space::Corners of = {points[triangles[t][0]], points[triangles[t][1]], points[triangles[t][2]]};
    if (space::are_collinear(of[0], of[1], of[2])) continue;
    corners.push_back(of);
    boxes.push_back(space::box_of(of));
    number.push_back(t);
  }
  Threads threads(options.threads);
  std::mutex mutex;
  const GoOn go_on = [&] {
    const std::lock_guard<std::mutex> lock(mutex);
    return !options.progress || options.progress({triangles.size(), points.size()});
  };
  meshops::Steps build_step(go_on);
  const space::BoxTree tree(boxes, build_step);
  constexpr std::size_t part = 4096;
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> found((corners.size() + part - 1) / part);
  for_each_part(threads, corners.size(), part, [&](std::size_t first, std::size_t last) {
    auto& pairs = found[first / part];
    meshops::Steps step(go_on);
    for (std::size_t i = first; i < last && pairs.size() < most; ++i) {
      tree.for_each_meeting(boxes[i], [&](std::uint32_t j) {
        step(10);
        if (j > i && space::triangles_cross(corners[i], corners[j])) pairs.emplace_back(number[i], number[j]);
      });
    }
  });
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const auto& some : found) pairs.insert(pairs.end(), some.begin(), some.end());
  std::sort(pairs.begin(), pairs.end());
  if (pairs.size() > most) pairs.resize(most);
  return pairs;
}

}  // namespace rbpa
