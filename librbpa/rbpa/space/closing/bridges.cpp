#include "rbpa/space/closing/bridges.h"

#include <algorithm>
#include <tuple>

#include "rbpa/space/box_scale.h"
#include "rbpa/space/closing/box_tree.h"
#include "rbpa/space/predicate/orientation.h"

namespace rbpa::space {
namespace {

std::uint32_t at(std::span<const std::uint32_t> loop, std::size_t i) { return loop[i % loop.size()]; }

}  // namespace

std::vector<Bridge> nearest_bridges(std::span<const Point3> points, std::span<const std::uint32_t> loop,
                                    std::span<const std::uint32_t> other, std::size_t most) {
  Box box;
  for (const auto& of : {loop, other})
    for (const std::uint32_t v : of) box.include(points[v]);
  const BoxScale scale(box.low, box.high);
  const auto square = [&](std::uint32_t v, std::uint32_t w) {
    const Vector3<double> p = scale.place(points[v]), q = scale.place(points[w]);
    const Vector3<double> d = {q.x - p.x, q.y - p.y, q.z - p.z};
    return dot(d, d);
  };
  struct Found {
    double length;
    Bridge bridge;
  };
  std::vector<Found> found;
  for (std::uint32_t i = 0; i < loop.size(); ++i)
    for (std::uint32_t j = 0; j < other.size(); ++j) {
      const double length = square(loop[i], at(other, j + 1)) + square(at(loop, i + 1), other[j]);
      if (length > 0) found.push_back({length, {i, j}});
    }
  const auto is_before = [&](const Found& f, const Found& g) {
    const auto key = [&](const Found& of) {
      return std::tuple(of.length, points[loop[of.bridge.edge]], points[other[of.bridge.other]]);
    };
    return key(f) < key(g);
  };
  const std::size_t count = std::min(most, found.size());
  std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count), found.end(), is_before);
  found.resize(count);
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
