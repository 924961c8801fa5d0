#include "rbpa/fill/rings/simple_rings.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

#include "rbpa/base/error.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/run/point_text.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/plane/predicate/plane_predicates.h"
#include "rbpa/plane/shape/below.h"

namespace rbpa {
namespace {

struct Edge : SweptEdge {
  RingsMeet::Side side;
  std::uint32_t from, to;  // in the direction of the ring
  bool runs_up;            // whether that direction is from `low` to `high`
};

/// Returns whether two edges have a point in common that is not an end of both, or are the same edge.
bool meet(const Edge& a, const Edge& b) {
  const int b_low = plane_orientation(a.low, a.high, b.low), b_high = plane_orientation(a.low, a.high, b.high);
  const int a_low = plane_orientation(b.low, b.high, a.low), a_high = plane_orientation(b.low, b.high, a.high);
  if (b_low * b_high < 0 && a_low * a_high < 0) return true;
  const auto is_inside = [](const Edge& edge, const Point& p) { return edge.low < p && p < edge.high; };
  return (b_low == 0 && is_inside(a, b.low)) || (b_high == 0 && is_inside(a, b.high)) ||
         (a_low == 0 && is_inside(b, a.low)) || (a_high == 0 && is_inside(b, a.high)) ||
         (a.low == b.low && a.high == b.high);
}

class RingSweep {
 public:
  RingSweep(std::span<const Point> points, std::span<const Ring> rings, const GoOn& go_on)
      : points_(points), rings_(rings), step_(go_on) {
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
    if (find_repeated()) return std::move(nested_);
    sweep();
    if (!nested_.meet) find_crossing_at_a_point();
    return std::move(nested_);
  }

 private:
  using Status = std::set<const Edge*, Below>;

  void found(RingsMeet::How how, const RingsMeet::Side& a, const RingsMeet::Side& b) {
    nested_.meet = RingsMeet{how, a, b};
  }

  std::uint32_t point_at(const RingsMeet::Side& v) const { return rings_[v.ring].points[v.edge]; }

  /// Returns whether a ring contains a point twice, or two indices have equal coordinates, and reports the first such
  /// point. Lists in shared_ the points before, in lexicographic order, that several rings share.
  bool find_repeated() {
    std::vector<RingsMeet::Side> vertices;
    for (const Edge& edge : edges_) vertices.push_back(edge.side);
    const auto at = [&](const RingsMeet::Side& v) { return points_[point_at(v)]; };
    sort(vertices, step_, [&](const RingsMeet::Side& a, const RingsMeet::Side& b) {
      return std::tuple(at(a), a.ring, a.edge) < std::tuple(at(b), b.ring, b.edge);
    });
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
      const RingsMeet::Side &a = vertices[i], &b = vertices[i + 1];
      if (at(a) != at(b)) continue;
      if (a.ring == b.ring || point_at(a) != point_at(b)) {
        found(RingsMeet::How::one_place, a, b);
        return true;
      }
      if (shared_.empty() || at(shared_.back()) != at(a)) shared_.push_back(a);
      shared_.push_back(b);
    }
    return false;
  }

  /// An edge at a point that several rings share.
  struct Spoke {
    Point to;
    RingsMeet::Side vertex;
  };

  /// Finds rings that cross at a shared point. Rings do not cross at a point if and only if their pairs of edges, in
  /// the order around the point, are nested or disjoint.
  void find_crossing_at_a_point() {
    for (auto first = shared_.begin(); first != shared_.end();) {
      step_();
      const std::uint32_t point = point_at(*first);
      std::vector<Spoke> spokes;
      for (; first != shared_.end() && point_at(*first) == point; ++first) {
        const std::vector<std::uint32_t>& ring = rings_[first->ring].points;
        const std::size_t n = ring.size();
        spokes.push_back({points_[ring[(first->edge + 1) % n]], *first});
        spokes.push_back({points_[ring[(first->edge + n - 1) % n]], *first});
      }
      const Point& at = points_[point];
      sort(spokes, step_, [&](const Spoke& a, const Spoke& b) {
        const bool a_right = at < a.to, b_right = at < b.to;
        return a_right != b_right ? a_right : plane_orientation(at, a.to, b.to) > 0;
      });
      std::vector<RingsMeet::Side> open;
      for (const Spoke& spoke : spokes) {
        if (!open.empty() && open.back().ring == spoke.vertex.ring) {
          open.pop_back();
          continue;
        }
        const auto begun = std::find_if(open.begin(), open.end(),
                                        [&](const RingsMeet::Side& v) { return v.ring == spoke.vertex.ring; });
        if (begun != open.end()) return found(RingsMeet::How::cross_at_a_point, *begun, open.back());
        open.push_back(spoke.vertex);
      }
    }
  }

  bool test(const Edge& a, const Edge& b) {
    if (!meet(a, b)) return false;
    const bool crosses = plane_orientation(a.low, a.high, b.low) * plane_orientation(a.low, a.high, b.high) < 0 &&
                         plane_orientation(b.low, b.high, a.low) * plane_orientation(b.low, b.high, a.high) < 0;
    const bool in_order = std::pair(a.side.ring, a.side.edge) < std::pair(b.side.ring, b.side.edge);
    const Edge &first = in_order ? a : b, &second = in_order ? b : a;
    const auto ends_on = [](const Edge& edge, const Edge& other) {
      return plane_orientation(other.low, other.high, edge.low) == 0 ||
             plane_orientation(other.low, other.high, edge.high) == 0;
    };
    using How = RingsMeet::How;
    if (crosses || (ends_on(a, b) && ends_on(b, a))) {
      found(crosses ? How::edges_cross : How::edges_overlap, first.side, second.side);
    } else {
      const Edge &on = ends_on(a, b) ? a : b, &whole = ends_on(a, b) ? b : a;
      const bool low = plane_orientation(whole.low, whole.high, on.low) == 0;
      found(How::vertex_on_edge, low ? low_end(on) : high_end(on), whole.side);
    }
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
      if (above != crossed_.end() && plane_orientation((*above)->low, (*above)->high, at) == 0) {
        found(RingsMeet::How::vertex_on_edge, low_end(**start), (*above)->side);
        return;
      }
      const auto first = start;
      for (; start != starts.end() && (*start)->low == at; ++start)
        if (insert(*start)) return;
      // The edges are sorted from below: if several rings begin at this point, the lowest is nested first.
      std::sort(first, start, Below());
      for (auto edge = first; edge != start; ++edge)
        if (const std::size_t ring = (*edge)->side.ring; !seen[ring]) {
          seen[ring] = true;
          nest(ring, *edge);
        }
    }
    for (; end != ends.end(); ++end)
      if (remove(*end)) return;
  }

  /// Returns the vertex at the lower or higher end of an edge.
  RingsMeet::Side low_end(const Edge& edge) const { return end_of(edge, !edge.runs_up); }
  RingsMeet::Side high_end(const Edge& edge) const { return end_of(edge, edge.runs_up); }
  RingsMeet::Side end_of(const Edge& edge, bool last) const {
    return {edge.side.ring, last ? (edge.side.edge + 1) % rings_[edge.side.ring].points.size() : edge.side.edge};
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

  /// Computes the position of a ring at its lexicographically least point, where `lower` is the lower of its two edges.
  void nest(std::size_t ring, const Edge* lower) {
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
  Steps step_;
  std::vector<Edge> edges_;
  Status crossed_;
  std::vector<Status::const_iterator> place_;
  std::vector<RingsMeet::Side> shared_;  // vertices at points that several rings share, sorted by point
  NestedRings nested_;
};

}  // namespace

void check_points(std::span<const Point> points, std::span<const Ring> rings, const RingName& name, const GoOn& go_on) {
  Steps step(go_on);
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const std::vector<std::uint32_t>& ring = rings[r].points;
    if (ring.size() < 3)
      throw InvalidInput(name(r) + ": found " + std::to_string(ring.size()) + " points, expected 3 or more");
    for (std::size_t i = 0; i < ring.size(); ++i) {
      step(4);
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
    if (std::all_of(ring.begin(), ring.end(), [&](std::uint32_t i) {
          step();
          return plane_orientation(a, b, points[i]) == 0;
        }))
      throw InvalidInput(name(r) + " at " + place_of(a) +
                         ": found all points on one line, expected a ring with an area");
  }
}

NestedRings nest_rings(std::span<const Point> points, std::span<const Ring> rings, const GoOn& go_on) {
  return RingSweep(points, rings, go_on).run();
}

}  // namespace rbpa
