#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/plane/arrays/boundary_sides.h"
#include "rbpa/plane/predicate/predicates.h"
#include "rbpa/plane/topology.h"

// A boundary side has the complex on its left. Around a point, counter-clockwise, outgoing and incoming sides
// alternate. From an outgoing side to the next incoming one there is a fan of triangles, or nothing if an edge in no
// triangle leads out and back; from there to the next outgoing side there is a gap:
//
//              gap
//         ↘           ↗
//       in  ↘       ↗  out
//     fan       ( )        fan
//       out ↙       ↖  in
//         ↙           ↖
//              gap
//
// A walk that continues along its fan leads around a solid component, once for its outside and once for each hole. A
// walk that crosses the gap leads around a component of the space, also once for its outside and once for each hole.
//
// At the lexicographically least point of a walk, the whole walk lies right of a vertical line. A fan there is narrower
// than 180° unless it contains the left side of that line, which happens once in a walk around a hole and never in a
// walk around the outside. A gap there is wider than 180° once in a walk around the outside, and never in a walk around
// a hole.

namespace rbpa {
namespace {

using Side = std::array<std::uint32_t, 2>;

std::vector<Side> boundary_of(const AlphaComplex& complex, Steps& step) {
  if (!complex.boundary.empty()) return complex.boundary;
  meshops::require(
      complex.neighbors.size() == complex.triangles.size(),
      "count: the complex has neither a boundary nor neighbors of every triangle (compute one of the two)");
  return boundary_sides(complex, [&] { step(); });
}

/// The number of walks around components, and of walks around holes.
struct Walks {
  std::size_t around_components = 0, around_holes = 0;
};

class BoundarySides {
 public:
  /// Links the sides into walks. Requires: sides in lexicographic order.
  /// Throws: ContractViolation when the sides do not form closed curves; Cancelled.
  BoundarySides(std::span<const Point> points, std::vector<Side> sides, Steps& step)
      : points_(points), sides_(std::move(sides)), along_fan_(sides_.size()), across_gap_(sides_.size()) {
    std::vector<std::uint32_t> into(sides_.size());
    std::iota(into.begin(), into.end(), 0u);
    sort(into, step, [&](std::uint32_t a, std::uint32_t b) { return sides_[a][1] < sides_[b][1]; });
    for (std::size_t first = 0; first < into.size();) {
      const std::uint32_t at = sides_[first][0];
      std::size_t last = first;
      for (; last < into.size() && sides_[last][0] == at; ++last) require_closed(sides_[into[last]][1] == at);
      require_closed(last == into.size() || sides_[into[last]][1] != at);
      link(at, first, std::span(into).subspan(first, last - first));
      step(last - first);
      first = last;
    }
  }

  Walks along_fans(Steps& step) const {
    return count_walks(along_fan_, step,
                       [](std::size_t left_turns, std::size_t visits) { return left_turns == visits; });
  }
  Walks across_gaps(Steps& step) const {
    return count_walks(across_gap_, step, [](std::size_t left_turns, std::size_t) { return left_turns > 0; });
  }

 private:
  static void require_closed(bool is_closed) {
    meshops::require(is_closed,
                     "count: the boundary is not closed: the sides that begin and that end at a point do not alternate "
                     "around that point");
  }

  /// A boundary side at a point: its number, the point at its other end, and whether it leaves the point.
  struct AtPoint {
    std::uint32_t side, other;
    bool goes_out;
  };

  /// Links the sides at point `at`. Sides that leave `at` are numbered from `first` on; `into` are the sides that end
  /// there.
  void link(std::uint32_t at, std::size_t first, std::span<const std::uint32_t> into) {
    if (into.size() == 1) {
      along_fan_[into[0]] = across_gap_[into[0]] = static_cast<std::uint32_t>(first);
      return;
    }
    std::vector<AtPoint> around;
    for (std::size_t i = 0; i < into.size(); ++i) {
      around.push_back({static_cast<std::uint32_t>(first + i), sides_[first + i][1], true});
      around.push_back({into[i], sides_[into[i]][0], false});
    }
    std::sort(around.begin(), around.end(), [&](const AtPoint& a, const AtPoint& b) {
      if (a.other == b.other) return a.goes_out && !b.goes_out;
      return comes_before(points_[at], points_[a.other], points_[b.other]);
    });
    for (std::size_t i = 0; i < around.size(); ++i) {
      if (around[i].goes_out) continue;
      const AtPoint &before = around[(i + around.size() - 1) % around.size()],
                    &behind = around[(i + 1) % around.size()];
      require_closed(before.goes_out && behind.goes_out);
      along_fan_[around[i].side] = before.side;
      across_gap_[around[i].side] = behind.side;
    }
  }

  /// Returns whether the direction from v to a comes before the one to b, counter-clockwise from the direction of +x.
  static bool comes_before(const Point& v, const Point& a, const Point& b) {
    const auto is_below = [&](const Point& p) { return p.y < v.y || (p.y == v.y && p.x < v.x); };
    if (is_below(a) != is_below(b)) return is_below(b);
    return Predicates<long double>::orientation(v, a, b) > 0;
  }

  template <typename IsComponent>
  Walks count_walks(const std::vector<std::uint32_t>& next, Steps& step, const IsComponent& is_component) const {
    Walks walks;
    std::vector<bool> seen(next.size());
    for (std::uint32_t first = 0; first < next.size(); ++first) {
      if (seen[first]) continue;
      Point least = points_[sides_[first][1]];
      std::uint32_t side = first;
      do {
        seen[side] = true;
        least = std::min(least, points_[sides_[side][1]]);
        side = next[side];
        step();
      } while (side != first);
      std::size_t left_turns = 0, visits = 0;
      do {
        const auto [from, at] = sides_[side];
        const std::uint32_t to = sides_[next[side]][1];
        if (points_[at] == least) {
          ++visits;
          left_turns += from == to || Predicates<long double>::orientation(points_[from], least, points_[to]) > 0;
        }
        side = next[side];
      } while (side != first);
      ++(is_component(left_turns, visits) ? walks.around_components : walks.around_holes);
    }
    return walks;
  }

  std::span<const Point> points_;
  std::vector<Side> sides_;
  std::vector<std::uint32_t> along_fan_, across_gap_;  // for each side, the next one of its walk
};

/// Returns the boundary sides and the edges in no triangle, these edges in both directions, all in lexicographic order.
std::vector<Side> with_edges(std::vector<Side> boundary, const AlphaComplex& complex, Steps& step) {
  for (const auto& [a, b] : complex.edges) {
    boundary.push_back({a, b});
    boundary.push_back({b, a});
  }
  sort(boundary, step, [](const Side& a, const Side& b) { return a < b; });
  return boundary;
}

}  // namespace

ComplexCounts count(std::span<const Point> points, const AlphaComplex& complex, ComplexKind kind, const GoOn& go_on) {
  Steps step(go_on);
  const bool is_full = kind == ComplexKind::full;
  std::vector<Side> boundary = boundary_of(complex, step);
  ComplexCounts counts{
      .points_covered = complex.distinct - (is_full ? complex.points.size() : complex.isolated.size()),
      .edges = (3 * complex.triangles.size() + boundary.size()) / 2 + (is_full ? complex.edges.size() : 0),
      .triangles = complex.triangles.size()};
  const BoundarySides of_triangles(points, boundary, step);
  const Walks solid = of_triangles.along_fans(step);
  counts.boundary_curves = solid.around_components + solid.around_holes;
  counts.solid_components = solid.around_components;
  const bool has_edges = is_full && !complex.edges.empty();
  const Walks all = has_edges
                        ? BoundarySides(points, with_edges(std::move(boundary), complex, step), step).across_gaps(step)
                        : of_triangles.across_gaps(step);
  counts.components = all.around_components + (is_full ? complex.points.size() : 0);
  counts.holes = all.around_holes;
  return counts;
}

}  // namespace rbpa
