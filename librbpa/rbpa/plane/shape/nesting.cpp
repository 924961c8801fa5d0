#include "rbpa/plane/shape/nesting.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>

#include "rbpa/plane/shape/below.h"

namespace rbpa {
namespace {

struct Edge : SweptEdge {
  std::uint32_t polygon;
  std::uint32_t ring;  // 0 is the shell, k is hole k − 1
  bool opens_shell;    // whether this is the first edge of a shell: the lower of the two at its first point
  bool solid_above;    // whether the polygon is above the edge
};

std::vector<Edge> edges_of(std::span<const Polygon> polygons, std::span<const Point> points, Steps& step) {
  std::size_t corners = 0;
  for (const Polygon& polygon : polygons) {
    corners += polygon.shell.points.size();
    for (const Ring& hole : polygon.holes) corners += hole.points.size();
  }
  std::vector<Edge> edges;
  edges.reserve(corners);
  for (std::uint32_t p = 0; p < polygons.size(); ++p) {
    const auto add = [&](const Ring& ring, std::uint32_t number) {
      step(ring.points.size());
      for (std::size_t i = 0; i < ring.points.size(); ++i) {
        const Point& a = points[ring.points[i]];
        const Point& b = points[ring.points[i + 1 == ring.points.size() ? 0 : i + 1]];
        if (a == b) continue;  // a repeated point, which rings from outside may have
        edges.push_back({{std::min(a, b), std::max(a, b)}, p, number, number == 0 && i == 0, a < b});
      }
    };
    add(polygons[p].shell, 0);
    for (std::uint32_t h = 0; h < polygons[p].holes.size(); ++h) add(polygons[p].holes[h], h + 1);
  }
  return edges;
}

/// A vertical line that moves to the right, and the edges that it crosses, from bottom to top.
class Sweep {
 public:
  using Edges = std::set<const Edge*, Below>;

  Sweep(const std::vector<Edge>& edges, Steps& step) : step_(step), first_(edges.data()), place_(edges.size()) {
    starts_.reserve(edges.size());
    for (const Edge& edge : edges) starts_.push_back(&edge);
    ends_ = starts_;
    sort(starts_, step_, [](const Edge* a, const Edge* b) { return a->low < b->low; });
    sort(ends_, step_, [](const Edge* a, const Edge* b) { return a->high < b->high; });
    start_ = starts_.begin();
    end_ = ends_.begin();
  }

  /// Returns the place where the next edges begin; absent after the last.
  std::optional<Point> next_start() const {
    if (start_ == starts_.end()) return std::nullopt;
    return (*start_)->low;
  }

  /// Removes the edges that end at `at` or before. Inserts and returns the edges that begin at `at`.
  std::span<const Edge* const> move_to_start(const Point& at) {
    step_();
    move_past_ends(at);
    const auto first = start_;
    for (; start_ != starts_.end() && (*start_)->low == at; ++start_)
      place_[number(*start_)] = crossed_.insert(*start_).first;
    return std::span(starts_).subspan(static_cast<std::size_t>(first - starts_.begin()),
                                      static_cast<std::size_t>(start_ - first));
  }
  void move_past_ends(const Point& at) {
    for (; end_ != ends_.end() && (*end_)->high <= at; ++end_) crossed_.erase(place_[number(*end_)]);
  }

  const Edges& crossed() const { return crossed_; }
  Edges::const_iterator place_of(const Edge* edge) const { return place_[number(edge)]; }

 private:
  std::size_t number(const Edge* edge) const { return static_cast<std::size_t>(edge - first_); }

  Steps& step_;
  const Edge* first_;
  std::vector<const Edge*> starts_, ends_;
  std::vector<const Edge*>::const_iterator start_, end_;  // the next edges
  Edges crossed_;
  std::vector<Edges::iterator> place_;
};

/// Returns for each polygon the edge next below the first point of its shell; null if there is none.
std::vector<const Edge*> edges_below(std::size_t polygons, const std::vector<Edge>& edges, Steps& step) {
  std::vector<const Edge*> below(polygons, nullptr);
  Sweep sweep(edges, step);
  while (const std::optional<Point> at = sweep.next_start()) {
    for (const Edge* opening : sweep.move_to_start(*at)) {
      const auto place = sweep.place_of(opening);
      if (opening->opens_shell && place != sweep.crossed().begin()) below[opening->polygon] = *std::prev(place);
    }
  }
  return below;
}

}  // namespace

std::vector<std::optional<HoleOf>> nesting(std::span<const Polygon> polygons, std::span<const Point> points,
                                           Steps& step) {
  const std::vector<Edge> edges = edges_of(polygons, points, step);
  const std::vector<const Edge*> below = edges_below(polygons.size(), edges, step);
  std::vector<std::optional<HoleOf>> inside(polygons.size());
  std::vector<bool> known(polygons.size(), false);
  std::vector<std::size_t> waiting;
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    // A polygon directly above the shell of another lies in the same hole as the other. The walk goes down to a hole,
    // to nothing, or to a polygon whose nesting is known.
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

std::vector<std::optional<std::uint32_t>> polygons_around(std::span<const Polygon> polygons,
                                                          std::span<const Point> points, std::span<const Point> queries,
                                                          Steps& step) {
  const std::vector<Edge> edges = edges_of(polygons, points, step);
  std::vector<std::size_t> order(queries.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  sort(order, step, [&](std::size_t a, std::size_t b) { return queries[a] < queries[b]; });
  std::vector<std::optional<std::uint32_t>> around(queries.size());
  Sweep sweep(edges, step);
  for (const std::size_t q : order) {
    step();
    const Point& at = queries[q];
    for (auto start = sweep.next_start(); start && *start < at; start = sweep.next_start()) sweep.move_to_start(*start);
    sweep.move_past_ends(at);
    const auto above = sweep.crossed().lower_bound(at);
    if (above == sweep.crossed().begin()) continue;
    // No other edge lies between the edge `below` and the point.
    const Edge* below = *std::prev(above);
    if (below->solid_above) around[q] = below->polygon;
  }
  return around;
}

}  // namespace rbpa
