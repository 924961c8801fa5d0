#include "rbpa/fill/simple_rings.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

#include "rbpa/core/error.h"
#include "rbpa/predicate/predicates.h"
#include "rbpa/run/input.h"
#include "rbpa/shape/below.h"
#include "rbpa/shape/steps.h"

namespace rbpa {
namespace {

int orientation(const Point& a, const Point& b, const Point& c) {
  return Predicates<long double>::orientation(a, b, c);
}

struct Edge : SweptEdge {
  RingsMeet::Side side;
  std::uint32_t from, to;  // as it runs
  bool runs_up;            // from the lower end to the higher
};

/// Beyond a common end that they may have.
bool meet(const Edge& a, const Edge& b) {
  const int b_low = orientation(a.low, a.high, b.low), b_high = orientation(a.low, a.high, b.high);
  const int a_low = orientation(b.low, b.high, a.low), a_high = orientation(b.low, b.high, a.high);
  if (b_low * b_high < 0 && a_low * a_high < 0) return true;
  const auto is_inside = [](const Edge& edge, const Point& p) { return edge.low < p && p < edge.high; };
  return (b_low == 0 && is_inside(a, b.low)) || (b_high == 0 && is_inside(a, b.high)) ||
         (a_low == 0 && is_inside(b, a.low)) || (a_high == 0 && is_inside(b, a.high)) ||
         (a.low == b.low && a.high == b.high);
}

class RingSweep {
 public:
  RingSweep(std::span<const Point> points, std::span<const Ring> rings, const RingName& name,
            const std::function<bool()>& go_on)
      : points_(points), rings_(rings), name_(name), step_(go_on) {
    nested_.place.resize(rings.size());
    for (std::size_t r = 0; r < rings.size(); ++r) {
      const std::vector<std::uint32_t>& ring = rings[r].points;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::uint32_t from = ring[i], to = ring[i + 1 == ring.size() ? 0 : i + 1];
        const Point &a = points[from], &b = points[to];
        edges_.push_back({{std::min(a, b), std::max(a, b)}, {r, i}, from, to, a < b});
      }
    }
  }

  NestedRings run() {
    if (!find_repeated()) sweep();
    return std::move(nested_);
  }

 private:
  using Status = std::set<const Edge*, Below>;

  std::string edge_text(const Edge& edge) const {
    const std::size_t next = (edge.side.edge + 1) % rings_[edge.side.ring].points.size();
    return "the edge from vertex " + std::to_string(edge.side.edge) + " " + place_of(points_[edge.from]) +
           " to vertex " + std::to_string(next) + " " + place_of(points_[edge.to]) + " of " + name_(edge.side.ring);
  }
  std::string vertex_text(const RingsMeet::Side& at) const {
    return "vertex " + std::to_string(at.edge) + " " + place_of(points_[rings_[at.ring].points[at.edge]]) + " of " +
           name_(at.ring);
  }
  void found(std::string why, const RingsMeet::Side& a, const RingsMeet::Side& b) {
    nested_.meet = RingsMeet{std::move(why), a, b};
  }

  /// Points that come twice, in one ring or in two.
  bool find_repeated() {
    std::vector<RingsMeet::Side> vertices;
    for (const Edge& edge : edges_) vertices.push_back(edge.side);
    const auto at = [&](const RingsMeet::Side& v) { return points_[rings_[v.ring].points[v.edge]]; };
    sort(vertices, step_, [&](const RingsMeet::Side& a, const RingsMeet::Side& b) {
      return std::tuple(at(a), a.ring, a.edge) < std::tuple(at(b), b.ring, b.edge);
    });
    const auto twice = std::adjacent_find(vertices.begin(), vertices.end(),
                                          [&](const auto& a, const auto& b) { return at(a) == at(b); });
    if (twice == vertices.end()) return false;
    found(vertex_text(*twice) + " and " + vertex_text(twice[1]) + " are one place", *twice, twice[1]);
    return true;
  }

  bool test(const Edge& a, const Edge& b) {
    if (!meet(a, b)) return false;
    const bool crosses = orientation(a.low, a.high, b.low) * orientation(a.low, a.high, b.high) < 0 &&
                         orientation(b.low, b.high, a.low) * orientation(b.low, b.high, a.high) < 0;
    const bool in_order = std::pair(a.side.ring, a.side.edge) < std::pair(b.side.ring, b.side.edge);
    const Edge &first = in_order ? a : b, &second = in_order ? b : a;
    found(edge_text(first) + (crosses ? " crosses " : " touches ") + edge_text(second), first.side, second.side);
    return true;
  }

  void sweep() {
    std::vector<const Edge*> starts, ends;
    for (const Edge& edge : edges_) starts.push_back(&edge);
    ends = starts;
    sort(starts, step_, [](const Edge* a, const Edge* b) { return a->low < b->low; });
    sort(ends, step_, [](const Edge* a, const Edge* b) { return a->high < b->high; });
    place_.resize(edges_.size(), crossed_.end());
    std::vector<bool> seen(rings_.size(), false);
    auto end = ends.begin();
    for (auto start = starts.begin(); start != starts.end();) {
      step_();
      const Point at = (*start)->low;
      for (; end != ends.end() && (*end)->high <= at; ++end)
        if (remove(*end)) return;
      const auto above = crossed_.lower_bound(at);
      if (above != crossed_.end() && orientation((*above)->low, (*above)->high, at) == 0) {
        found(vertex_text(starts_at(**start)) + " lies on " + edge_text(**above), starts_at(**start), (*above)->side);
        return;
      }
      const auto first = start;
      for (; start != starts.end() && (*start)->low == at; ++start)
        if (insert(*start)) return;
      if (const std::size_t ring = (*first)->side.ring; !seen[ring]) {
        seen[ring] = true;
        nest(ring, *first, *std::next(first));
      }
    }
    for (; end != ends.end(); ++end)
      if (remove(*end)) return;
  }

  /// The vertex at the lower end.
  RingsMeet::Side starts_at(const Edge& edge) const {
    return {edge.side.ring,
            edge.runs_up ? edge.side.edge : (edge.side.edge + 1) % rings_[edge.side.ring].points.size()};
  }

  bool insert(const Edge* edge) {
    const auto above = crossed_.lower_bound(edge);
    if (above != crossed_.end() && test(*edge, **above)) return true;
    if (above != crossed_.begin() && test(*edge, **std::prev(above))) return true;
    place_[number(edge)] = crossed_.insert(above, edge);
    return false;
  }
  bool remove(const Edge* edge) {
    const auto place = place_[number(edge)], above = std::next(place);
    const bool between = place != crossed_.begin() && above != crossed_.end();
    const Edge* below = between ? *std::prev(place) : nullptr;
    crossed_.erase(place);
    return between && test(*below, **above);
  }

  /// At the first point of a ring, at which two edges begin.
  void nest(std::size_t ring, const Edge* a, const Edge* b) {
    const Edge* lower = Below()(a, b) ? a : b;
    const auto place = place_[number(lower)];
    nested_.place[ring].is_counter_clockwise = lower->runs_up;
    if (place == crossed_.begin()) return;
    const Edge* below = *std::prev(place);
    const std::size_t other = below->side.ring;
    const bool other_is_above = below->runs_up == nested_.place[other].is_counter_clockwise;
    nested_.place[ring].inside = other_is_above ? std::optional(other) : nested_.place[other].inside;
    nested_.place[ring].depth = other_is_above ? nested_.place[other].depth + 1 : nested_.place[other].depth;
  }

  std::size_t number(const Edge* edge) const { return static_cast<std::size_t>(edge - edges_.data()); }

  std::span<const Point> points_;
  std::span<const Ring> rings_;
  const RingName& name_;
  Steps step_;
  std::vector<Edge> edges_;
  Status crossed_;
  std::vector<Status::const_iterator> place_;
  NestedRings nested_;
};

}  // namespace

std::string place_of(const Point& p) {
  std::string place = "(";
  return place.append(text(p.x)).append(", ").append(text(p.y)).append(")");
}

void check_points(std::span<const Point> points, std::span<const Ring> rings, const RingName& name) {
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const std::vector<std::uint32_t>& ring = rings[r].points;
    if (ring.size() < 3)
      throw InvalidInput(name(r) + ": found " + std::to_string(ring.size()) + " points, expected 3 or more");
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::string vertex = "vertex " + std::to_string(i) + " of " + name(r);
      if (ring[i] >= points.size())
        throw InvalidInput(vertex + ": found point " + std::to_string(ring[i]) + ", expected one of " +
                           std::to_string(points.size()));
      if (!is_finite(points[ring[i]]))
        throw InvalidInput(vertex + ": found " + place_of(points[ring[i]]) + ", expected finite coordinates");
    }
    const Point& a = points[ring[0]];
    const auto other = std::find_if(ring.begin(), ring.end(), [&](std::uint32_t i) { return points[i] != a; });
    const Point& b = other == ring.end() ? a : points[*other];
    if (std::all_of(ring.begin(), ring.end(), [&](std::uint32_t i) { return orientation(a, b, points[i]) == 0; }))
      throw InvalidInput(name(r) + " at " + place_of(a) + ": found no area, expected a ring around some");
  }
}

NestedRings nest_rings(std::span<const Point> points, std::span<const Ring> rings, const RingName& name,
                       const std::function<bool()>& go_on) {
  return RingSweep(points, rings, name, go_on).run();
}

}  // namespace rbpa
