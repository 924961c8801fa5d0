#include "rbpa/space/repair/closing/triangle_sides.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>

#include "meshops/core/contract.h"
#include "rbpa/base/run/steps.h"

namespace rbpa::space {
namespace {

auto key(const TriangleSide& side) { return std::tie(side.from, side.to); }

/// Returns the side from `from` to `to`, or the end of `sides`.
std::vector<TriangleSide>::const_iterator find(const std::vector<TriangleSide>& sides, std::uint32_t from,
                                               std::uint32_t to) {
  const auto found = std::lower_bound(sides.begin(), sides.end(), std::tie(from, to),
                                      [](const TriangleSide& side, const auto& wanted) { return key(side) < wanted; });
  return found != sides.end() && found->from == from && found->to == to ? found : sides.end();
}

}  // namespace

std::vector<TriangleSide> sorted_sides(std::span<const std::array<std::uint32_t, 3>> triangles,
                                       const std::vector<bool>& is_wanted, meshops::Steps& step) {
  std::vector<TriangleSide> sides;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = triangles[t][k], to = triangles[t][(k + 1) % 3];
      if (is_wanted.empty() || (is_wanted[from] && is_wanted[to]))
        sides.push_back({from, to, triangles[t][(k + 2) % 3], t});
    }
  sort(sides, step, [](const TriangleSide& s, const TriangleSide& t) {
    return std::tie(s.from, s.to, s.triangle) < std::tie(t.from, t.to, t.triangle);
  });
  return sides;
}

std::vector<std::vector<std::uint32_t>> loops_of(std::span<const std::array<std::uint32_t, 3>> triangles,
                                                 meshops::Steps& step) {
  const std::vector<TriangleSide> sides = sorted_sides(triangles, {}, step);
  meshops::require(
      std::adjacent_find(sides.begin(), sides.end(),
                         [](const TriangleSide& s, const TriangleSide& t) { return key(s) == key(t); }) == sides.end(),
      "boundary_loops: two triangles have a side in the same direction, expected triangles oriented alike");
  std::uint32_t vertices = 0;
  for (const TriangleSide& side : sides) vertices = std::max(vertices, side.from + 1);
  constexpr std::uint32_t none = 0xffffffff;
  std::vector<std::uint32_t> next(vertices, none);  // next vertex along the boundary, with the triangles to the right
  for (const TriangleSide& side : sides) {
    step(2);
    if (find(sides, side.to, side.from) != sides.end()) continue;
    meshops::require(next[side.to] == none, "boundary_loops: several boundary curves pass a vertex, expected one");
    next[side.to] = side.from;
  }
  std::vector<std::vector<std::uint32_t>> loops;
  for (std::uint32_t start = 0; start < vertices; ++start) {
    if (next[start] == none) continue;
    std::vector<std::uint32_t>& loop = loops.emplace_back();
    for (std::uint32_t at = start; next[at] != none;) {
      loop.push_back(at);
      at = std::exchange(next[at], none);
    }
  }
  return loops;
}

BoundarySides::BoundarySides(std::span<const std::array<std::uint32_t, 3>> triangles,
                             std::span<const std::vector<std::uint32_t>> loops, meshops::Steps& step) {
  std::uint32_t vertices = 0;
  for (const auto& t : triangles) vertices = std::max({vertices, t[0] + 1, t[1] + 1, t[2] + 1});
  std::vector<bool> is_wanted(vertices, false);
  for (const auto& loop : loops) {
    meshops::require(!loop.empty(), "fill_holes: a loop is empty, expected its vertices");
    for (const std::uint32_t vertex : loop) {
      meshops::require(vertex < vertices, "fill_holes: a loop has a vertex that no triangle has");
      is_wanted[vertex] = true;
    }
  }
  if (loops.empty()) return;
  const std::vector<TriangleSide> sides = sorted_sides(triangles, is_wanted, step);
  std::vector<bool> is_used(sides.size(), false);
  for (const auto& loop : loops) {
    std::vector<std::uint32_t>& across = across_.emplace_back();
    for (std::size_t k = 0; k < loop.size(); ++k) {
      step(2);
      const std::uint32_t from = loop[k], to = loop[(k + 1) % loop.size()];
      const auto side = find(sides, to, from);
      if (side == sides.end() || find(sides, from, to) != sides.end())
        throw meshops::ContractViolation("fill_holes: found the edge from vertex " + std::to_string(from) +
                                         " to vertex " + std::to_string(to) +
                                         " in a loop, expected a boundary side with its triangle to the right (loops "
                                         "of boundary_loops() of these triangles)");
      const auto number = static_cast<std::size_t>(side - sides.begin());
      if (is_used[number])
        throw meshops::ContractViolation("fill_holes: the loops pass the edge from vertex " + std::to_string(from) +
                                         " to vertex " + std::to_string(to) + " twice, expected once");
      is_used[number] = true;
      across.push_back(side->across);
    }
  }
}

}  // namespace rbpa::space
