#include "rbpa/plane/constrained/insert_segments.h"

#include <algorithm>
#include <map>
#include <random>
#include <utility>

#include "meshops/core/contract.h"
#include "meshops/core/fresh_vector.h"
#include "rbpa/base/exact/magnitude.h"
#include "rbpa/plane/predicate/predicates.h"

namespace rbpa {
namespace {

using Site = std::uint32_t;

constexpr const char* leads_out = "insert_segments: found a segment that leads out of the triangulation";

/// A directed edge.
struct DirectedEdge {
  Site from, to;
  friend auto operator<=>(const DirectedEdge&, const DirectedEdge&) = default;
};

/// A side of a triangle, across from corner k; without a triangle, no side.
struct TriangleSide {
  std::uint32_t triangle = no_index, k = 0;
};

std::uint32_t after(std::uint32_t k) { return k == 2 ? 0 : k + 1; }
std::uint32_t before(std::uint32_t k) { return k == 0 ? 2 : k - 1; }

template <typename Real>
class Inserter {
 public:
  Inserter(std::span<const Point> places, FixedTriangles& of, Steps& step)
      : places_(places), corners_(of.triangles), across_(of.neighbors), fixed_(of.fixed), step_(step) {
    star_.assign(places_.size(), no_index);
    for (std::uint32_t t = 0; t < corners_.size(); ++t)
      for (const Site s : corners_[t]) star_[s] = t;
  }

  std::optional<SegmentCrossing> run(std::span<const Segment> segments) {
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      step_();
      if (const TriangleSide side = edge_between(segments[i][0], segments[i][1]); side.triangle != no_index)
        fix(side);
      else
        missing.push_back(i);
    }
    std::minstd_rand random(1);
    for (std::size_t i = missing.size(); i > 1; --i) std::swap(missing[i - 1], missing[random() % i]);
    for (const std::size_t i : missing)
      if (const auto crossed = insert(segments[i][0], segments[i][1])) return SegmentCrossing{i, *crossed};
    return std::nullopt;
  }

 private:
  int orientation(Site a, Site b, Site c) const {
    return Predicates<Real>::orientation(places_[a], places_[b], places_[c]);
  }
  DirectedEdge ends(const TriangleSide& side) const {
    const Triangle& corner = corners_[side.triangle];
    return {corner[after(side.k)], corner[before(side.k)]};
  }
  /// Returns the side of the neighboring triangle that is the same edge as `side`; no side if there is no neighbor.
  TriangleSide beyond(const TriangleSide& side) const {
    const std::uint32_t other = across_[side.triangle][side.k];
    if (other == no_index) return {};
    // The corner before the apex in the triangle beyond.
    const Site apex_before = corners_[side.triangle][after(side.k)];
    for (std::uint32_t k = 0; k < 3; ++k)
      if (corners_[other][before(k)] == apex_before && across_[other][k] == side.triangle) return {other, k};
    meshops::require(false, "insert_segments: neighbors do not agree");
    return {};
  }

  bool is_fixed(const TriangleSide& side) const { return (fixed_[side.triangle] >> side.k & 1) != 0; }
  /// The number of segments that lie on an edge: none, an even or an odd number.
  enum Fixed : std::uint8_t { free = 0, even = 0x01, odd = 0x11 };
  Fixed fixed(const TriangleSide& side) const { return Fixed(fixed_[side.triangle] >> side.k & 0x11); }
  /// Counts a segment on an edge, on both sides of it.
  void fix(const TriangleSide& side) { join(side, beyond(side), fixed(side) == odd ? even : odd); }
  /// Makes two sides the same edge; either may be no side.
  void join(const TriangleSide& one, const TriangleSide& other, Fixed fixed) {
    for (const auto& [side, opposite] : {std::pair(one, other), std::pair(other, one)}) {
      if (side.triangle == no_index) continue;
      across_[side.triangle][side.k] = opposite.triangle;
      std::uint8_t& bits = fixed_[side.triangle];
      bits = static_cast<std::uint8_t>((bits & ~(0x11 << side.k)) | fixed << side.k);
    }
  }
  void make(std::uint32_t t, const Triangle& corners) {
    corners_[t] = corners;
    across_[t] = {no_index, no_index, no_index};
    fixed_[t] = FixedTriangles::changed;
    for (const Site s : corners) star_[s] = t;
  }

  /// Calls visit(t, k) for the triangles with corner a, where k is the number of that corner, until it returns true.
  template <typename Visit>
  void visit_around(Site a, Visit visit) const {
    for (const bool clockwise : {false, true}) {
      std::uint32_t t = star_[a];
      do {
        step_();
        const Triangle& corner = corners_[t];
        const auto k = static_cast<std::uint32_t>(std::find(corner.begin(), corner.end(), a) - corner.begin());
        if (visit(t, k)) return;
        t = across_[t][clockwise ? before(k) : after(k)];
      } while (t != no_index && t != star_[a]);
      if (t != no_index) return;
    }
  }

  /// Returns a side that is the edge between a and b; no side if no triangle has it.
  TriangleSide edge_between(Site a, Site b) const {
    TriangleSide found;
    visit_around(a, [&](std::uint32_t t, std::uint32_t k) {
      if (corners_[t][after(k)] == b) found = {t, before(k)};
      if (corners_[t][before(k)] == b) found = {t, after(k)};
      return found.triangle != no_index;
    });
    return found;
  }

  /// The begin of a segment: an edge along it and the end of that edge, or the side that it crosses first.
  struct Begin {
    TriangleSide side = {};
    std::optional<Site> end = std::nullopt;
  };

  Begin begin_of(Site a, Site b) const {
    Begin found;
    // On the line through a and b, c is on the side of b, and a triangle with the edge ac has no corner between.
    const auto is_toward = [&](Site c) { return (places_[a] < places_[c]) == (places_[a] < places_[b]); };
    visit_around(a, [&](std::uint32_t t, std::uint32_t k) {
      const Site u = corners_[t][after(k)], w = corners_[t][before(k)];
      const int from_u = u == b ? 0 : orientation(a, u, b), from_w = w == b ? 0 : orientation(a, w, b);
      if (from_u == 0 && is_toward(u))
        found = {{t, before(k)}, u};
      else if (from_w == 0 && is_toward(w))
        found = {{t, after(k)}, w};
      else if (from_u > 0 && from_w < 0)
        found = {{t, k}, std::nullopt};
      return found.side.triangle != no_index;
    });
    meshops::require(found.side.triangle != no_index, leads_out);
    return found;
  }

  /// Inserts the segment from a to b. Returns a fixed edge that it crosses, if any.
  std::optional<Segment> insert(Site a, Site b) {
    while (a != b) {
      const Begin begin = begin_of(a, b);
      if (begin.end) {
        fix(begin.side);
        a = *begin.end;
        continue;
      }
      TriangleSide side = begin.side;
      slots_ = {side.triangle};
      const auto [right, left] = ends(side);
      left_ = {{a, {}}, rim(left, {side.triangle, after(side.k)})};
      right_ = {{a, {}}, rim(right, {side.triangle, before(side.k)})};
      for (;;) {
        step_();
        if (is_fixed(side)) return Segment{ends(side).from, ends(side).to};
        side = beyond(side);
        meshops::require(side.triangle != no_index, leads_out);
        slots_.push_back(side.triangle);
        const Site apex = corners_[side.triangle][side.k];
        // In the triangle beyond, the crossed edge runs from its left end to its right end.
        const TriangleSide of_left{side.triangle, before(side.k)}, of_right{side.triangle, after(side.k)};
        const int turn = apex == b ? 0 : orientation(a, b, apex);
        if (turn >= 0) left_.push_back(rim(apex, of_left));
        if (turn <= 0) right_.push_back(rim(apex, of_right));
        if (turn == 0) break;
        side = turn > 0 ? of_right : of_left;
      }
      const Site end = left_.back().site;
      fill_cavities(a, end);
      a = end;
    }
    return std::nullopt;
  }

  /// A corner of the rim of a cavity, and the side outside of the cavity, beyond the rim's edge that leads to the
  /// corner. If the triangle of the side outside was removed as well, close() finds the new triangle by the edge.
  struct Rim {
    Site site;
    TriangleSide outside;
    Fixed fixed = free;   // the segments on the rim's edge
    bool is_new = false;  // whether the triangle of `outside` was made for this cavity
  };

  /// Returns the corner at the end of `side`, which is on the rim of the cavity.
  Rim rim(Site site, const TriangleSide& side) const { return {site, beyond(side), fixed(side)}; }

  void fill_cavities(Site a, Site b) {
    std::vector<std::uint32_t> taken = slots_;
    std::sort(taken.begin(), taken.end());
    taken_ = std::move(taken);
    waiting_.clear();
    free_ = 0;
    // Both rims run from a to b. `is_right` makes new triangles counter-clockwise.
    std::vector<Rim> rim = left_;
    const TriangleSide left = fill_cavity(rim, false);
    rim = right_;
    const TriangleSide right = fill_cavity(rim, true);
    join(left, right, odd);
    meshops::require(free_ == slots_.size() && waiting_.empty(), "insert_segments: a cavity was not filled");
    star_[a] = star_[b] = left.triangle;
    flip_all();
  }

  /// A part of a rim, from corner `first` to corner `last`. Its base joins both corners. The triangle that
  /// fill_cavity() makes on the base becomes the neighbor of side `beyond`.
  struct Part {
    std::size_t first, last;
    TriangleSide beyond;
  };

  /// Cuts off a triangle wherever the rim turns towards its base, from one end to the other as in a scan for the convex
  /// hull. Every corner of the rim sees the inserted edge, so only this edge is left of the rim. If a longer rim were
  /// left, fill_cavity() would fill the rest.
  void cut_ears(std::vector<Rim>& rim, bool is_right) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      Rim next = rim[i];
      for (; kept >= 2; --kept) {
        step_();
        const Rim &last = rim[kept - 1], &first = rim[kept - 2];
        const Site p = is_right ? next.site : first.site, q = is_right ? first.site : next.site;
        if (p == q || orientation(p, q, last.site) <= 0) break;
        const std::uint32_t t = slots_[free_++];
        make(t, {p, q, last.site});
        close(first.site, last, {t, is_right ? 0U : 1U}, is_right);
        close(last.site, next, {t, is_right ? 1U : 0U}, is_right);
        next = {next.site, {t, 2}, free, true};
      }
      rim[kept++] = next;
    }
    rim.resize(kept);
  }

  /// Flips edges of the new triangles, except fixed edges, until no apex beyond an edge is in the circumcircle of
  /// the triangle before the edge.
  void flip_all() {
    for (const std::uint32_t t : slots_)
      for (std::uint32_t k = 0; k < 3; ++k) queue_.push_back({t, k});
    while (!queue_.empty()) {
      step_();
      const TriangleSide side = queue_.back();
      queue_.pop_back();
      const TriangleSide other = beyond(side);
      if (other.triangle == no_index || is_fixed(side)) continue;
      const auto [a, b] = ends(side);
      const Site p = corners_[side.triangle][side.k], q = corners_[other.triangle][other.k];
      if (Predicates<Real>::in_perturbed_circle(places_[a], places_[b], places_[p], places_[q]) > 0) flip(side, other);
    }
  }

  void flip(const TriangleSide& side, const TriangleSide& other) {
    const auto [a, b] = ends(side);
    const std::uint32_t t = side.triangle, o = other.triangle;
    const Site p = corners_[t][side.k], q = corners_[o][other.k];
    const Rim pa = rim(a, {t, before(side.k)}), bp = rim(p, {t, after(side.k)});
    const Rim aq = rim(q, {o, after(other.k)}), qb = rim(b, {o, before(other.k)});
    make(t, {p, a, q});
    make(o, {q, b, p});
    join({t, 1}, {o, 1}, free);
    join({t, 0}, aq.outside, aq.fixed);
    join({t, 2}, pa.outside, pa.fixed);
    join({o, 0}, bp.outside, bp.fixed);
    join({o, 2}, qb.outside, qb.fixed);
    for (const std::uint32_t k : {0U, 2U}) {
      queue_.push_back({t, k});
      queue_.push_back({o, k});
    }
  }

  /// Fills the cavity between the inserted edge and a rim, which joins the ends of the edge. Returns the side of the
  /// new triangle that lies on the inserted edge.
  TriangleSide fill_cavity(std::vector<Rim>& rim, bool is_right) {
    cut_ears(rim, is_right);
    TriangleSide base = rim.back().outside;
    if (rim.size() == 2) return base;
    std::vector<Part> parts = {{0, rim.size() - 1, {}}};
    while (!parts.empty()) {
      const Part part = parts.back();
      parts.pop_back();
      step_();
      if (part.last - part.first == 1) {
        close(rim[part.first].site, rim[part.last], part.beyond, is_right);
        continue;
      }
      // The base runs from p to q, so that the rim lies on its left.
      const Site p = rim[is_right ? part.last : part.first].site, q = rim[is_right ? part.first : part.last].site;
      std::size_t apex = part.first + 1;
      for (std::size_t i = apex + 1; i < part.last; ++i) {
        step_();
        const Site s = rim[i].site, best = rim[apex].site;
        if (s != best && Predicates<Real>::in_perturbed_circle(places_[p], places_[q], places_[best], places_[s]) > 0)
          apex = i;
      }
      const std::uint32_t t = slots_[free_++];
      make(t, {p, q, rim[apex].site});
      const TriangleSide here{t, 2};
      if (part.first == 0 && part.last + 1 == rim.size())
        base = here;
      else
        join(here, part.beyond, free);
      parts.push_back({part.first, apex, {t, is_right ? 0U : 1U}});
      parts.push_back({apex, part.last, {t, is_right ? 1U : 0U}});
    }
    return base;
  }

  /// Joins side `inner` of a new triangle to the side beyond the edge of the rim from `from` to `to`.
  void close(Site from, const Rim& to, const TriangleSide& inner, bool is_right) {
    if (to.is_new || !std::binary_search(taken_.begin(), taken_.end(), to.outside.triangle)) {
      join(inner, to.outside, to.fixed);
      return;
    }
    // The rim passes this edge twice, in both directions. Both triangles at the edge are new; the first waits.
    DirectedEdge edge = is_right ? DirectedEdge{from, to.site} : DirectedEdge{to.site, from};
    if (const auto other = waiting_.find({edge.to, edge.from}); other != waiting_.end()) {
      join(inner, other->second, to.fixed);
      waiting_.erase(other);
    } else {
      waiting_.emplace(edge, inner);
    }
  }

  std::span<const Point> places_;
  std::vector<Triangle>&corners_, &across_;
  std::vector<std::uint8_t>& fixed_;
  Steps& step_;
  meshops::FreshVector<Site> star_;  // for each place, a triangle with this corner
  // State of the insertion of an edge:
  std::vector<Rim> left_, right_;
  std::vector<std::uint32_t> slots_, taken_;  // removed triangles, in the order of removal; the same, ascending
  std::size_t free_ = 0;                      // the first entry of slots_ that no new triangle uses
  std::map<DirectedEdge, TriangleSide> waiting_;
  std::vector<TriangleSide> queue_;
};

}  // namespace

std::optional<SegmentCrossing> insert_segments(std::span<const Point> points, std::span<const Segment> segments,
                                               FixedTriangles& of, Steps& step) {
  return fits_double(magnitude_bound(points)) ? Inserter<double>(points, of, step).run(segments)
                                              : Inserter<long double>(points, of, step).run(segments);
}

}  // namespace rbpa
