#include "rbpa/space/repair/closing/bridges.h"

#include <algorithm>
#include <tuple>

#include "rbpa/space/cells/box_scale.h"
#include "rbpa/space/cells/box_tree.h"
#include "rbpa/space/predicate/orientation.h"

namespace rbpa::space {
namespace {

std::uint32_t at(std::span<const std::uint32_t> loop, std::size_t i) { return loop[i % loop.size()]; }

}  // namespace

std::vector<Bridge> nearest_bridges(std::span<const Point3> points, std::span<const std::uint32_t> loop,
                                    std::span<const std::uint32_t> other, std::size_t most, Work& work) {
  Box box;
  for (const auto& of : {loop, other})
    for (const std::uint32_t v : of) box.include(points[v]);
  const BoxScale scale(box.low, box.high);
  const auto places_of = [&](std::span<const std::uint32_t> of) {
    std::vector<Vector3<double>> places;
    places.reserve(of.size() + 1);
    for (const std::uint32_t v : of) places.push_back(scale.place(points[v]));
    places.push_back(places.front());
    return places;
  };
  const std::vector<Vector3<double>> from = places_of(loop), to = places_of(other);
  const auto square = [](const Vector3<double>& p, const Vector3<double>& q) {
    const Vector3<double> d = {q.x - p.x, q.y - p.y, q.z - p.z};
    return dot(d, d);
  };
  struct Found {
    double length;
    Bridge bridge;
  };
  const auto is_before = [&](const Found& f, const Found& g) {
    const auto key = [&](const Found& of) {
      return std::tuple(of.length, points[loop[of.bridge.edge]], points[other[of.bridge.other]]);
    };
    return key(f) < key(g);
  };
  std::vector<Found> found;            // a heap; the worst of the best is first
  constexpr std::size_t at_once = 16;  // pairs of edges that are compared as fast as one pair of triangles
  for (std::uint32_t i = 0; i < loop.size(); ++i) {
    work(other.size() / at_once + 1);
    if (work.is_over()) return {};
    for (std::uint32_t j = 0; j < other.size(); ++j) {
      const double length = square(from[i], to[j + 1]) + square(from[i + 1], to[j]);
      if (!(length > 0) || (found.size() == most && length > found.front().length)) continue;
      const Found pair{length, {i, j}};
      if (found.size() == most) {
        if (!is_before(pair, found.front())) continue;
        std::pop_heap(found.begin(), found.end(), is_before);
        found.back() = pair;
      } else {
        found.push_back(pair);
      }
      std::push_heap(found.begin(), found.end(), is_before);
    }
  }
  std::sort_heap(found.begin(), found.end(), is_before);
  std::vector<Bridge> bridges;
  for (const Found& f : found) bridges.push_back(f.bridge);
  return bridges;
}

std::array<std::array<std::uint32_t, 3>, 2> strip_of(const Bridge& bridge, std::span<const std::uint32_t> loop,
                                                     std::span<const std::uint32_t> other) {
  const std::uint32_t from = loop[bridge.edge], to = at(loop, bridge.edge + 1), other_from = other[bridge.other],
                      other_to = at(other, bridge.other + 1);
  return {{{from, to, other_from}, {from, other_from, other_to}}};
}

std::vector<std::uint32_t> joined_loop(const Bridge& bridge, std::span<const std::uint32_t> loop,
                                       std::span<const std::uint32_t> other) {
  std::vector<std::uint32_t> joined;
  for (std::size_t k = 1; k <= loop.size(); ++k) joined.push_back(at(loop, bridge.edge + k));
  for (std::size_t k = 1; k <= other.size(); ++k) joined.push_back(at(other, bridge.other + k));
  return joined;
}

}  // namespace rbpa::space
