#include "triangulation/surface_counts.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace rbpa::app {

using Index = std::uint32_t;

SurfaceCounts count(const SplitFans& fans, const SurfaceComponents& components) {
  SurfaceCounts counts{
      .triangles = fans.triangles.size(), .vertices = fans.point.size(), .components = components.all.size()};
  std::size_t boundary = 0;
  for (const SurfaceComponent& component : components.all) {
    boundary += component.boundary_sides;
    counts.boundary_curves += component.boundary_curves;
  }
  counts.edges = (3 * counts.triangles + boundary) / 2;
  for (std::size_t v = 0; v < fans.point.size(); ++v) {
    const bool is_first = v == 0 || fans.point[v] != fans.point[v - 1];
    const bool is_last = v + 1 == fans.point.size() || fans.point[v] != fans.point[v + 1];
    counts.points += is_first;
    counts.touching += is_first && !is_last;
  }
  // Euler: vertices - edges + triangles = 2 components - 2 genus - boundary curves.
  counts.genus =
      (2 * counts.components + counts.edges - counts.boundary_curves - counts.vertices - counts.triangles) / 2;
  return counts;
}

std::size_t non_manifold_edges(std::span<const std::array<Index, 3>> triangles) {
  // List for each point the other ends of the sides that have this point as their lesser end.
  Index most = 0;
  for (const auto& triangle : triangles) most = std::max({most, triangle[0], triangle[1], triangle[2]});
  std::vector<std::size_t> begin(std::size_t{most} + 2, 0);
  const auto for_each_side = [&](const auto& visit) {
    for (const auto& triangle : triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(triangle[k], triangle[(k + 1) % 3]);
        visit(low, high);
      }
  };
  for_each_side([&](Index low, Index) { ++begin[low + 1]; });
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  std::vector<Index> ends(begin.back());
  for_each_side([&](Index low, Index high) { ends[next[low]++] = high; });

  std::size_t edges = 0;
  for (std::size_t p = 0; p + 1 < begin.size(); ++p) {
    const auto first = ends.begin() + static_cast<std::ptrdiff_t>(begin[p]);
    const auto last = ends.begin() + static_cast<std::ptrdiff_t>(begin[p + 1]);
    std::sort(first, last);
    for (auto run = first; run != last;) {
      const auto end = std::upper_bound(run, last, *run);
      edges += end - run > 2;
      run = end;
    }
  }
  return edges;
}

std::vector<Index> by_shells(const SurfaceComponents& components) {
  const std::size_t triangles = components.number.size();
  std::vector<std::size_t> first(components.all.size(), triangles);  // first triangle of each component
  for (std::size_t t = triangles; t-- > 0;) first[components.number[t]] = t;
  const auto diagonal = [](const SurfaceComponent& component) {
    const Point3 &low = component.low, &high = component.high;
    // A quarter of the diagonal, which cannot overflow.
    return std::hypot(high.x / 4 - low.x / 4, high.y / 4 - low.y / 4, high.z / 4 - low.z / 4);
  };
  std::vector<Index> order(components.all.size()), rank(components.all.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](Index c, Index d) {
    const auto key = [&](Index i) {
      return std::make_tuple(-diagonal(components.all[i]), -components.all[i].volume, first[i]);
    };
    return key(c) < key(d);
  });
  for (Index place = 0; place < order.size(); ++place) rank[order[place]] = place;

  std::vector<Index> by_rank(triangles);
  std::iota(by_rank.begin(), by_rank.end(), Index{0});
  std::stable_sort(by_rank.begin(), by_rank.end(),
                   [&](Index t, Index u) { return rank[components.number[t]] < rank[components.number[u]]; });
  return by_rank;
}

}  // namespace rbpa::app
