#include "rbpa/space/surface/split_fans.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/arrays/fans.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/base/triangle_arrays.h"
#include "rbpa/space/surface/levels/sub_surface.h"

namespace rbpa {
namespace {

/// A side of a triangle.
struct Side {
  std::uint32_t low, high;  // the vertices at its ends
  std::uint32_t triangle;
  std::uint32_t across;
};

/// Calls visit(first, last) for the sides between each pair of vertices.
template <typename Visit>
void for_each_edge(const SplitFans& fans, const GoOn& go_on, const Visit& visit) {
  Steps step(go_on);
  std::vector<Side> sides;
  sides.reserve(3 * fans.triangles.size());
  for (std::uint32_t t = 0; t < fans.triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(fans.triangles[t][(k + 1) % 3], fans.triangles[t][(k + 2) % 3]);
      sides.push_back({low, high, t, k});
    }
  sort(sides, step, [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  for (auto first = sides.begin(); first != sides.end();) {
    const auto last =
        std::find_if(first, sides.end(), [&](const Side& s) { return s.low != first->low || s.high != first->high; });
    visit(first, last);
    first = last;
  }
}

}  // namespace

SplitFans split_fans(const Surface& surface, const GoOn& go_on) {
  require_linked(space::arrays_of(surface), std::numeric_limits<std::uint32_t>::max(), go_on);
  Steps step(go_on);
  meshops::DisjointSets fans = fans_of(space::arrays_of(surface), step);
  SplitFans result;
  result.triangles = surface.triangles;
  const auto corners = static_cast<std::uint32_t>(fans.size());
  const auto at = [&](std::uint32_t corner) -> std::uint32_t& { return result.triangles[corner / 3][corner % 3]; };

  std::vector<std::uint32_t> first;  // first corner of each fan
  for (std::uint32_t corner = 0; corner < corners; ++corner)
    if (fans.find(corner) == corner) first.push_back(corner);
  sort(first, step, [&](std::uint32_t f, std::uint32_t g) { return at(f) != at(g) ? at(f) < at(g) : f < g; });
  for (const std::uint32_t corner : first) result.point.push_back(at(corner));
  // The first corner of each fan is numbered first; the other corners of the fan copy the number.
  for (std::uint32_t v = 0; v < first.size(); ++v) at(first[v]) = v;
  for (std::uint32_t corner = 0; corner < corners; ++corner) at(corner) = at(fans.find(corner));
  return result;
}

Surface indexable_surface(const Surface& surface, const GoOn& go_on) {
  Surface result = surface;
  const auto across = [&](const Side& side) -> std::uint32_t& { return result.neighbors[side.triangle][side.across]; };
  // If a fan is cut everywhere that it meets the edge, each of its parts meets the edge only at its two ends.
  for_each_edge(split_fans(surface, go_on), go_on, [&](auto first, auto last) {
    if (last - first > 2)
      for (auto side = first; side != last; ++side) across(*side) = Surface::none;
  });
  for_each_edge(split_fans(result, go_on), go_on, [&](auto first, auto last) {
    if (last - first != 2 || across(*first) != Surface::none) return;
    across(first[0]) = first[1].triangle;
    across(first[1]) = first[0].triangle;
  });
  return result;
}

}  // namespace rbpa
