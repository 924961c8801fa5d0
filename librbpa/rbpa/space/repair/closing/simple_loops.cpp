#include "rbpa/space/repair/closing/simple_loops.h"

#include <algorithm>
#include <cstddef>
#include <map>

namespace rbpa::space {
namespace {

/// Returns the corner from which the sequence of the loop's points is lexicographically least.
std::size_t canonical_start(std::span<const Point3> points, const std::vector<std::uint32_t>& loop,
                            meshops::Steps& step) {
  const auto at = [&](std::size_t i) -> const Point3& { return points[loop[i % loop.size()]]; };
  std::size_t best = 0;
  for (std::size_t start = 1; start < loop.size(); ++start)
    for (std::size_t k = 0; k < loop.size(); ++k) {
      step();
      if (at(start + k) == at(best + k)) continue;
      if (at(start + k) < at(best + k)) best = start;
      break;
    }
  return best;
}

}  // namespace

std::vector<SimpleLoop> simple_loops(std::span<const Point3> points, std::span<const std::vector<std::uint32_t>> loops,
                                     meshops::Steps& step) {
  std::vector<SimpleLoop> result;
  for (std::uint32_t l = 0; l < loops.size(); ++l) {
    const std::vector<std::uint32_t>& loop = loops[l];
    const std::size_t start = canonical_start(points, loop, step);
    std::vector<LoopCorner> open;
    std::map<Point3, std::size_t> place;  // for each point: its position in `open`
    for (std::size_t k = 0; k < loop.size(); ++k) {
      step(4);
      const auto edge = static_cast<std::uint32_t>((start + k) % loop.size());
      const std::uint32_t vertex = loop[edge];
      const auto [found, is_new] = place.try_emplace(points[vertex], open.size());
      if (is_new) {
        open.push_back({vertex, vertex, edge});
        continue;
      }
      // The corners since the last visit become a loop of their own. The earlier corners continue with the next ones.
      const auto first = open.begin() + static_cast<std::ptrdiff_t>(found->second);
      SimpleLoop part{l, {first, open.end()}};
      for (auto corner = first + 1; corner != open.end(); ++corner) place.erase(points[corner->in]);
      open.erase(first + 1, open.end());
      part.corners.front().in = vertex;
      open.back().out = vertex;
      open.back().edge = edge;
      result.push_back(std::move(part));
    }
    result.push_back({l, std::move(open)});
  }
  const auto is_before = [&](const LoopCorner& c, const LoopCorner& d) { return points[c.in] < points[d.in]; };
  std::stable_sort(result.begin(), result.end(), [&](const SimpleLoop& p, const SimpleLoop& q) {
    step();
    if (p.corners.size() != q.corners.size()) return p.corners.size() < q.corners.size();
    return std::lexicographical_compare(p.corners.begin(), p.corners.end(), q.corners.begin(), q.corners.end(),
                                        is_before);
  });
  return result;
}

}  // namespace rbpa::space
