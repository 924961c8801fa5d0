#include "rbpa/shape/nesting.h"

#include <algorithm>
#include <cstdint>
#include <set>

#include "rbpa/predicate/predicates.h"

namespace rbpa {
namespace {

int orientation(const Point& a, const Point& b, const Point& c) {
  return Predicates<long double>::orientation(a, b, c);
}

/// A boundary edge, its lexicographically lower end first.
struct Edge {
  Point low, high;
  std::uint32_t polygon;
  std::uint32_t ring;  // 0 is the shell, k is hole k − 1
  bool opens_shell;    // it is the first edge of the shell: the lower of the two at the shell's first point
};

/// Lower first, of edges that some point between two events of the sweep sees both of. They meet in common ends at
/// most, so that no orientation is zero.
struct Below {
  bool operator()(const Edge* a, const Edge* b) const {
    if (a == b) return false;
    if (a->low == b->low) return orientation(a->low, a->high, b->high) > 0;
    return a->low < b->low ? orientation(a->low, a->high, b->low) > 0 : orientation(b->low, b->high, a->low) < 0;
  }
};

std::vector<Edge> edges_of(std::span<const Polygon> polygons, std::span<const Point> points) {
  std::vector<Edge> edges;
  for (std::uint32_t p = 0; p < polygons.size(); ++p) {
    const auto add = [&](const Ring& ring, std::uint32_t number) {
      for (std::size_t i = 0; i < ring.points.size(); ++i) {
        const Point& a = points[ring.points[i]];
        const Point& b = points[ring.points[i + 1 == ring.points.size() ? 0 : i + 1]];
        edges.push_back({std::min(a, b), std::max(a, b), p, number, number == 0 && i == 0});
      }
    };
    add(polygons[p].shell, 0);
    for (std::uint32_t h = 0; h < polygons[p].holes.size(); ++h) add(polygons[p].holes[h], h + 1);
  }
  return edges;
}

/// For each polygon the edge next below the first point of its shell.
std::vector<const Edge*> edges_below(std::size_t polygons, const std::vector<Edge>& edges) {
  std::vector<const Edge*> starts, ends;
  for (const Edge& edge : edges) starts.push_back(&edge);
  ends = starts;
  std::sort(starts.begin(), starts.end(), [](const Edge* a, const Edge* b) { return a->low < b->low; });
  std::sort(ends.begin(), ends.end(), [](const Edge* a, const Edge* b) { return a->high < b->high; });

  std::vector<const Edge*> below(polygons, nullptr);
  std::set<const Edge*, Below> crossed;
  std::vector<std::set<const Edge*, Below>::iterator> position(edges.size());
  const auto number = [&](const Edge* edge) { return static_cast<std::size_t>(edge - edges.data()); };
  auto end = ends.begin();
  for (auto start = starts.begin(); start != starts.end();) {
    const Point at = (*start)->low;
    for (; end != ends.end() && (*end)->high <= at; ++end) crossed.erase(position[number(*end)]);
    const auto first = start;
    for (; start != starts.end() && (*start)->low == at; ++start)
      position[number(*start)] = crossed.insert(*start).first;
    for (auto opening = first; opening != start; ++opening) {
      const auto place = position[number(*opening)];
      if ((*opening)->opens_shell && place != crossed.begin()) below[(*opening)->polygon] = *std::prev(place);
    }
  }
  return below;
}

}  // namespace

std::vector<std::optional<HoleOf>> nesting(std::span<const Polygon> polygons, std::span<const Point> points) {
  const std::vector<Edge> edges = edges_of(polygons, points);
  const std::vector<const Edge*> below = edges_below(polygons.size(), edges);
  std::vector<std::optional<HoleOf>> inside(polygons.size());
  std::vector<bool> known(polygons.size(), false);
  std::vector<std::size_t> waiting;
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    // Over a shell lies what lies beside it: go down until a hole, the ground, or a polygon that knows.
    std::size_t at = p;
    for (; !known[at]; at = below[at]->polygon) {
      waiting.push_back(at);
      const Edge* edge = below[at];
      if (edge != nullptr && edge->ring == 0) continue;
      if (edge != nullptr) inside[at] = HoleOf{edge->polygon, edge->ring - 1};
      known[at] = true;
      break;
    }
    for (const std::size_t q : waiting) {
      inside[q] = inside[at];
      known[q] = true;
    }
    waiting.clear();
  }
  return inside;
}

}  // namespace rbpa
