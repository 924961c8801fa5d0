#include "rbpa/plane/partial/rings.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "rbpa/base/arrays/sort_unique.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/predicate/predicates.h"
#include "rbpa/plane/shape/split_curve.h"

namespace rbpa {
namespace {

void begin_with_least(CornerRing& ring) {
  const auto less = [](const Corner& a, const Corner& b) { return a.at < b.at; };
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), less), ring.end());
}

void add_ring(OpenComponent& component, CornerRing&& ring) {
  if (ring.size() < 3)
    throw InvalidInput("a boundary ring of " + std::to_string(ring.size()) + " points, expected at least 3");
  begin_with_least(ring);
  component.least = std::min(component.least, ring[0].at);
  component.rings.push_back(std::move(ring));
}

void add_edges(BoundaryMeasure& boundary, const CornerRing& ring) {
  const Corner* from = &ring.back();
  for (const Corner& to : ring) boundary.add_edge(std::exchange(from, &to)->at, to.at);
}

/// Returns whether a ring is a shell. A ring always turns at its lexicographically least point.
bool is_shell(const CornerRing& ring) {
  return Predicates<long double>::orientation(ring.back().at, ring[0].at, ring[1].at) > 0;
}

}  // namespace

void add_curve(OpenComponent& component, std::vector<Corner>&& curve) {
  std::vector<std::uint64_t> points;
  points.reserve(curve.size());
  for (const Corner& corner : curve) points.push_back(corner.index);
  sort_unique(points);
  if (points.size() == curve.size()) return add_ring(component, std::move(curve));

  // Numbers points by their position among those of the curve.
  std::vector<std::uint32_t> numbers;
  std::vector<const Corner*> corners(points.size());
  for (const Corner& corner : curve) {
    const auto place = std::lower_bound(points.begin(), points.end(), corner.index) - points.begin();
    numbers.push_back(static_cast<std::uint32_t>(place));
    corners[static_cast<std::size_t>(place)] = &corner;
  }
  std::vector<Ring> rings;
  CurveSplitter(points.size()).split(numbers, rings);
  for (const Ring& ring : rings) {
    CornerRing made;
    for (const std::uint32_t number : ring.points) made.push_back(*corners[number]);
    add_ring(component, std::move(made));
  }
}

bool ring_before(const CornerRing& a, const CornerRing& b) {
  return std::pair(a[0].at, a[1].at) < std::pair(b[0].at, b[1].at);
}

CornerPolygon polygon_of(OpenComponent&& component) {
  std::vector<CornerRing>& rings = component.rings;
  std::sort(rings.begin(), rings.end(), ring_before);
  const auto shell = std::find_if(rings.begin(), rings.end(), is_shell);
  if (shell == rings.end())
    throw InvalidInput("a component of " + std::to_string(rings.size()) +
                       " boundary rings, expected one of them to run counter-clockwise");
  BoundaryMeasure boundary;
  for (const CornerRing& ring : rings) add_edges(boundary, ring);
  CornerPolygon polygon{.shell = std::move(*shell), .points = component.points};
  rings.erase(shell);
  polygon.holes = std::move(rings);
  for (HoleSums& taken : component.taken) {
    boundary += taken.measure;
    polygon.taken_holes = taken.holes;
    polygon.names = std::move(taken.names);
  }
  polygon.area = boundary.area();
  polygon.perimeter = boundary.perimeter();
  return polygon;
}

std::vector<CornerRing> holes_out_of(OpenComponent& component, const ComponentName& name, std::size_t min_corners) {
  const auto corners = [](auto ring, auto last) {
    std::size_t count = 0;
    for (; ring != last; ++ring) count += ring->size();
    return count;
  };
  if (corners(component.rings.begin(), component.rings.end()) < min_corners) return {};
  const auto first = std::partition(component.rings.begin(), component.rings.end(), is_shell);
  if (corners(first, component.rings.end()) < min_corners) return {};
  std::vector<CornerRing> holes(std::make_move_iterator(first), std::make_move_iterator(component.rings.end()));
  component.rings.erase(first, component.rings.end());
  if (holes.empty()) return holes;
  std::sort(holes.begin(), holes.end(), ring_before);
  HoleSums sums{.holes = holes.size(), .names = {name}};
  for (const CornerRing& hole : holes) add_edges(sums.measure, hole);
  OpenComponent taken;
  taken.taken.push_back(std::move(sums));
  add_taken(component, std::move(taken));
  return holes;
}

void add_taken(OpenComponent& to, OpenComponent&& from) {
  if (to.taken.empty()) std::swap(to.taken, from.taken);
  if (from.taken.empty()) return;
  HoleSums &sums = to.taken[0], &added = from.taken[0];
  sums.holes += added.holes;
  sums.measure += added.measure;
  std::vector<ComponentName> names;
  std::set_union(sums.names.begin(), sums.names.end(), added.names.begin(), added.names.end(),
                 std::back_inserter(names));
  sums.names = std::move(names);
}

}  // namespace rbpa
