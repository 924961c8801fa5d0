#include "rbpa/plane/partial/state.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "rbpa/base/error.h"
#include "rbpa/plane/partial/rings.h"

namespace rbpa {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void expect(bool holds, const char* what) {
  if (!holds)
    throw InvalidInput(std::string("partial result: found bytes that to_bytes() never writes, expected ") + what +
                       " (compute the partial result again)");
}

/// Returns whether each item comes before the next.
template <typename Items, typename Less>
bool ascends(const Items& items, Less less) {
  return std::adjacent_find(items.begin(), items.end(), [&](const auto& a, const auto& b) { return !less(a, b); }) ==
         items.end();
}

void check_path(const std::vector<Corner>& path) {
  expect(path.size() >= 3, "at least 3 points on each ring and boundary chain");
  for (const Corner& corner : path) expect(is_finite(corner.at), "finite coordinates");
  expect(std::adjacent_find(path.begin(), path.end(),
                            [](const Corner& a, const Corner& b) { return a.index == b.index || a.at == b.at; }) ==
             path.end(),
         "different points at the ends of each boundary edge");
}

void check_rings(const std::vector<CornerRing>& rings) {
  for (const CornerRing& ring : rings) {
    check_path(ring);
    expect(std::all_of(ring.begin() + 1, ring.end(), [&](const Corner& c) { return ring[0].at < c.at; }),
           "the lexicographically least point first in each ring");
  }
  expect(ascends(rings, ring_before), "rings in ascending order");
}

void check_names(const std::vector<ComponentName>& names, std::uint64_t holes) {
  expect(ascends(names, std::less<>()), "names of components in ascending order");
  expect(names.empty() == (holes == 0) && names.size() <= holes,
         "at least one removed hole for each name of a component");
}

void check_polygons(const std::vector<CornerPolygon>& polygons) {
  for (const CornerPolygon& polygon : polygons) {
    check_rings({polygon.shell});
    check_rings(polygon.holes);
    check_names(polygon.names, polygon.taken_holes);
    expect(polygon.area >= 0 && polygon.perimeter >= 0, "areas and perimeters of 0 or more");
  }
  expect(ascends(polygons, comes_before), "polygons in ascending order");
}

void check_cover(const Cover& cover) {
  for (const Quadrant& quadrant : cover.quadrants())
    expect(quadrant.at.x < infinity && quadrant.at.y < infinity && quadrant.weight != 0,
           "corners of regions below infinity, each with a weight other than 0");
  expect(ascends(cover.quadrants(), [](const Quadrant& a, const Quadrant& b) { return a.at < b.at; }),
         "corners of regions in ascending order");
  expect(!cover.wrong(), "regions that do not overlap");
}

void check_shared(const PartialState& state) {
  std::size_t components = 0;
  for (const SharedTriangle& triangle : state.shared) {
    const auto& [a, b, c] = triangle.corners;
    expect(a < b && a < c && b != c, "three different corners of each shared triangle, the smallest first");
    expect(triangle.owned == 1 || triangle.owned == 2,
           "one or two corners of each shared triangle in the merged regions");
    expect(triangle.component <= components, "open components numbered in the order of their first shared triangle");
    if (triangle.component == components) ++components;
  }
  expect(ascends(state.shared, [](const auto& a, const auto& b) { return a.corners < b.corners; }),
         "shared triangles in ascending order");
  expect(components == state.open.size(), "as many open components as the shared triangles name");
}

void check_open(const PartialState& state) {
  std::uint32_t groups = 0;
  for (const OpenComponent& component : state.open) {
    expect(component.group <= groups, "groups numbered in the order of their first open component");
    if (component.group == groups) ++groups;
    const bool no_boundary = component.least == Point{infinity, infinity};
    expect(no_boundary || is_finite(component.least), "a finite least point of each open component with a boundary");
    check_rings(component.rings);
    expect(component.taken.size() <= 1, "at most one sum of removed holes in each open component");
    for (const HoleSums& sums : component.taken) check_names(sums.names, sums.holes);
  }
  for (const Chain& chain : state.chains) {
    expect(chain.component < state.open.size(), "boundary chains of open components");
    check_path(chain.path);
  }
  const auto edge = [](const Chain& chain) { return std::pair(chain.path[0].index, chain.path[1].index); };
  expect(ascends(state.chains, [&](const Chain& a, const Chain& b) { return edge(a) < edge(b); }),
         "boundary chains in the order of their first edges");
}

void check_pinches(const PartialState& state) {
  for (const Pinch& pinch : state.pinches) {
    expect(pinch.members.size() >= 2 && pinch.members.front() < state.open.size() &&
               pinch.members.back() < state.open.size() + state.held.size(),
           "in each pinch at least two open components or held polygons, one of them an open component");
    expect(ascends(pinch.members, std::less<>()), "members of each pinch in ascending order");
  }
  expect(ascends(state.pinches, [](const Pinch& a, const Pinch& b) { return a.members < b.members; }),
         "pinches in the order of their members");
}

}  // namespace

void check_state(const PartialState& state) {
  const bool is_empty = state.alpha == 0;
  expect(is_empty || (state.alpha > 0 && std::isfinite(state.alpha)), "a finite radius");
  expect(!is_empty || (state.counts == PartialCounts{} && state.cover.quadrants().empty() && state.shared.empty() &&
                       state.open.empty() && state.chains.empty() && state.pinches.empty() && state.held.empty() &&
                       state.polygons.empty()),
         "an empty state without regions");
  check_cover(state.cover);
  check_shared(state);
  check_open(state);
  check_polygons(state.held);
  check_polygons(state.polygons);
  check_pinches(state);
}

}  // namespace rbpa
