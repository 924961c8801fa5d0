#include "rbpa/fill/front/constrained_delaunay.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <utility>

#include "meshops/core/contract.h"
#include "rbpa/base/exact/magnitude.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/predicate/predicates.h"

namespace rbpa {
namespace {

using Site = std::uint32_t;
using Triangle = std::array<Site, 3>;

constexpr const char* leads_out =
    "constrained_delaunay: found an edge that leads out of the triangulation, expected rings that do not cross";

/// A directed edge.
struct Directed {
  Site from, to;
  friend auto operator<=>(const Directed&, const Directed&) = default;
};

/// A side of a triangle, across from corner k; without a triangle, no side.
struct Side {
  std::uint32_t triangle = no_index, k = 0;
};

std::uint32_t after(std::uint32_t k) { return k == 2 ? 0 : k + 1; }
std::uint32_t before(std::uint32_t k) { return k == 0 ? 2 : k - 1; }

template <typename Real>
class Constrained {
 public:
  Constrained(const Outline& outline, const GoOn& go_on) : places_(outline.places), step_(go_on) {
    for (const OutlineRing& ring : outline.rings)
      for (std::size_t i = 0; i < ring.sites.size(); ++i)
        edges_.push_back({ring.sites[i], ring.sites[(i + 1) % ring.sites.size()]});
    sort(edges_, step_, std::less<>());
    first_edge_.assign(places_.size() + 1, 0);
    for (const Directed& edge : edges_) ++first_edge_[edge.from + 1];
    std::partial_sum(first_edge_.begin(), first_edge_.end(), first_edge_.begin());
    AlphaComplex whole =
        alpha_complex(places_, std::numeric_limits<double>::infinity(),
                      {.neighbors = true, .threads = 1, .progress = [&](const auto&) { return !go_on || go_on(); }});
    corners_ = std::move(whole.triangles);
    across_ = std::move(whole.neighbors);
    star_.assign(places_.size(), no_index);
    for (std::uint32_t t = 0; t < corners_.size(); ++t)
      for (const Site s : corners_[t]) star_[s] = t;
  }

  std::vector<Triangle> run() {
    for (const Directed& edge : missing()) insert(edge);
    return inside();
  }

 private:
  bool is_edge(Site from, Site to) const {
    const auto begin = edges_.begin();
    return std::binary_search(begin + first_edge_[from], begin + first_edge_[from + 1], Directed{from, to});
  }
  int orientation(Site a, Site b, Site c) const {
    return Predicates<Real>::orientation(places_[a], places_[b], places_[c]);
  }
  Directed ends(const Side& side) const {
    const Triangle& corner = corners_[side.triangle];
    return {corner[after(side.k)], corner[before(side.k)]};
  }
  /// Returns the side of the neighboring triangle that is the same edge as `side`; no side if there is no neighbor.
  Side beyond(const Side& side) const {
    const std::uint32_t other = across_[side.triangle][side.k];
    if (other == no_index) return {};
    // The corner before the apex in the triangle beyond.
    const Site apex_before = corners_[side.triangle][after(side.k)];
    for (std::uint32_t k = 0; k < 3; ++k)
      if (corners_[other][before(k)] == apex_before && across_[other][k] == side.triangle) return {other, k};
    meshops::require(false, "constrained_delaunay: neighbors do not agree");
    return {};
  }

  /// Returns the edges of rings that no triangle has, each once, in a random order that never varies.
  std::vector<Directed> missing() {
    std::vector<Directed> present;
    for (std::uint32_t t = 0; t < corners_.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) {
        step_();
        const auto [from, to] = ends({t, k});
        if (is_edge(from, to) || is_edge(to, from)) present.push_back({std::min(from, to), std::max(from, to)});
      }
    sort(present, step_, std::less<>());
    std::vector<Directed> missing;
    for (const auto& [from, to] : edges_) {
      const Directed edge{std::min(from, to), std::max(from, to)};
      if (from > to && is_edge(to, from)) continue;  // an edge of two rings, listed once
      if (!std::binary_search(present.begin(), present.end(), edge)) missing.push_back(edge);
    }
    std::minstd_rand random(1);
    for (std::size_t i = missing.size(); i > 1; --i) std::swap(missing[i - 1], missing[random() % i]);
    return missing;
  }

  /// Returns the side across from corner a that the segment from a to b crosses first; no side if a triangle has the
  /// edge ab.
  Side first_crossed(Site a, Site b) {
    for (const bool clockwise : {false, true}) {
      std::uint32_t t = star_[a];
      do {
        step_();
        const Triangle& corner = corners_[t];
        const auto k = static_cast<std::uint32_t>(std::find(corner.begin(), corner.end(), a) - corner.begin());
        const Site u = corner[after(k)], w = corner[before(k)];
        if (u == b || w == b) return {};
        if (orientation(a, u, b) > 0 && orientation(a, w, b) < 0) return {t, k};
        t = across_[t][clockwise ? before(k) : after(k)];
      } while (t != no_index && t != star_[a]);
    }
    meshops::require(false, leads_out);
    return {};
  }

  void insert(const Directed& edge) {
    const auto [a, b] = edge;
    Side side = first_crossed(a, b);
    if (side.triangle == no_index) return;
    slots_ = {side.triangle};
    Directed crossed = ends(side);  // from its right end to its left end
    left_ = {{a, {}}, {crossed.to, out_of({side.triangle, after(side.k)})}};
    right_ = {{a, {}}, {crossed.from, out_of({side.triangle, before(side.k)})}};
    for (;;) {
      step_();
      side = beyond(side);
      meshops::require(side.triangle != no_index, leads_out);
      slots_.push_back(side.triangle);
      const Site apex = corners_[side.triangle][side.k];
      // In the triangle beyond, the crossed edge runs from its left end to its right end.
      const Side of_left{side.triangle, before(side.k)}, of_right{side.triangle, after(side.k)};
      const int turn = apex == b ? 0 : orientation(a, b, apex);
      if (apex == b) {
        left_.push_back({b, out_of(of_left)});
        right_.push_back({b, out_of(of_right)});
        break;
      }
      meshops::require(turn != 0, "constrained_delaunay: a place lies on an edge that does not pass it");
      if (turn > 0) {
        left_.push_back({apex, out_of(of_left)});
        side = of_right;
      } else {
        right_.push_back({apex, out_of(of_right)});
        side = of_left;
      }
    }
    fill_cavities(a, b);
  }

  /// A corner of the rim of a cavity, and the side outside of the cavity, beyond the rim's edge that leads to the
  /// corner. If the triangle of the side outside was removed as well, close() finds the new triangle by the edge.
  struct Rim {
    Site site;
    Side outside;
    bool is_new = false;  // whether the triangle of `outside` was made for this cavity
  };

  /// Returns beyond(side), where `side` is on the rim of the cavity: a side outside of the cavity.
  Side out_of(const Side& side) const { return beyond(side); }

  void join(const Side& one, const Side& other) {
    if (one.triangle != no_index) across_[one.triangle][one.k] = other.triangle;
    if (other.triangle != no_index) across_[other.triangle][other.k] = one.triangle;
  }

  void fill_cavities(Site a, Site b) {
    std::vector<std::uint32_t> taken = slots_;
    std::sort(taken.begin(), taken.end());
    taken_ = std::move(taken);
    waiting_.clear();
    free_ = 0;
    // Both rims run from a to b. `is_right` makes new triangles counter-clockwise.
    std::vector<Rim> rim = left_;
    const Side left = fill_cavity(rim, false);
    rim = right_;
    const Side right = fill_cavity(rim, true);
    join(left, right);
    meshops::require(free_ == slots_.size() && waiting_.empty(), "constrained_delaunay: a cavity was not filled");
    star_[a] = star_[b] = left.triangle;
    flip_all();
  }

  /// A part of a rim, from corner `first` to corner `last`. Its base joins both corners. The triangle that
  /// fill_cavity() makes on the base becomes the neighbor of side `beyond`.
  struct Part {
    std::size_t first, last;
    Side beyond;
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
        corners_[t] = {p, q, last.site};
        across_[t] = {no_index, no_index, no_index};
        for (const Site s : corners_[t]) star_[s] = t;
        close(first.site, last, {t, is_right ? 0U : 1U}, is_right);
        close(last.site, next, {t, is_right ? 1U : 0U}, is_right);
        next.outside = {t, 2};
        next.is_new = true;
      }
      rim[kept++] = next;
    }
    rim.resize(kept);
  }

  /// Flips edges of the new triangles, except edges of rings, until no apex beyond an edge is in the circumcircle of
  /// the triangle before the edge.
  void flip_all() {
    for (const std::uint32_t t : slots_)
      for (std::uint32_t k = 0; k < 3; ++k) queue_.push_back({t, k});
    while (!queue_.empty()) {
      step_();
      const Side side = queue_.back();
      queue_.pop_back();
      const Side other = beyond(side);
      if (other.triangle == no_index) continue;
      const auto [a, b] = ends(side);
      const Site p = corners_[side.triangle][side.k], q = corners_[other.triangle][other.k];
      if (Predicates<Real>::in_perturbed_circle(places_[a], places_[b], places_[p], places_[q]) <= 0) continue;
      if (is_edge(a, b) || is_edge(b, a)) continue;
      flip(side, other);
    }
  }

  void flip(const Side& side, const Side& other) {
    const auto [a, b] = ends(side);
    const std::uint32_t t = side.triangle, o = other.triangle;
    const Site p = corners_[t][side.k], q = corners_[o][other.k];
    const Side beyond_pa = beyond({t, before(side.k)}), beyond_bp = beyond({t, after(side.k)});
    const Side beyond_aq = beyond({o, after(other.k)}), beyond_qb = beyond({o, before(other.k)});
    corners_[t] = {p, a, q};
    corners_[o] = {q, b, p};
    across_[t] = {no_index, o, no_index};
    across_[o] = {no_index, t, no_index};
    join({t, 0}, beyond_aq);
    join({t, 2}, beyond_pa);
    join({o, 0}, beyond_bp);
    join({o, 2}, beyond_qb);
    star_[a] = star_[p] = star_[q] = t;
    star_[b] = o;
    for (const std::uint32_t k : {0U, 2U}) {
      queue_.push_back({t, k});
      queue_.push_back({o, k});
    }
  }

  /// Fills the cavity between the inserted edge and a rim, which joins the ends of the edge. Returns the side of the
  /// new triangle that lies on the inserted edge.
  Side fill_cavity(std::vector<Rim>& rim, bool is_right) {
    cut_ears(rim, is_right);
    Side base = rim.back().outside;
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
      corners_[t] = {p, q, rim[apex].site};
      across_[t] = {no_index, no_index, no_index};
      for (const Site s : corners_[t]) star_[s] = t;
      const Side here{t, 2};
      if (part.first == 0 && part.last + 1 == rim.size())
        base = here;
      else
        join(here, part.beyond);
      parts.push_back({part.first, apex, {t, is_right ? 0U : 1U}});
      parts.push_back({apex, part.last, {t, is_right ? 1U : 0U}});
    }
    return base;
  }

  /// Joins side `inner` of a new triangle to the side beyond the edge of the rim from `from` to `to`.
  void close(Site from, const Rim& to, const Side& inner, bool is_right) {
    if (to.is_new || !std::binary_search(taken_.begin(), taken_.end(), to.outside.triangle)) {
      join(inner, to.outside);
      return;
    }
    // The rim passes this edge twice, in both directions. Both triangles at the edge are new; the first waits.
    Directed edge = is_right ? Directed{from, to.site} : Directed{to.site, from};
    if (const auto other = waiting_.find({edge.to, edge.from}); other != waiting_.end()) {
      join(inner, other->second);
      waiting_.erase(other);
    } else {
      waiting_.emplace(edge, inner);
    }
  }

  /// Returns the triangles on the left of edges of rings, and all triangles that a walk from these reaches without
  /// crossing a ring.
  std::vector<Triangle> inside() {
    std::vector<bool> seen(corners_.size(), false);
    std::vector<std::uint32_t> found;
    const auto visit = [&](std::uint32_t t) {
      if (seen[t]) return;
      seen[t] = true;
      found.push_back(t);
    };
    for (std::uint32_t t = 0; t < corners_.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) {
        step_();
        const auto [from, to] = ends({t, k});
        if (is_edge(from, to)) visit(t);
      }
    std::vector<Triangle> result;
    for (std::size_t i = 0; i < found.size(); ++i) {
      step_();
      result.push_back(corners_[found[i]]);
      for (std::uint32_t k = 0; k < 3; ++k) {
        const auto [from, to] = ends({found[i], k});
        if (!is_edge(from, to) && !is_edge(to, from) && across_[found[i]][k] != no_index) visit(across_[found[i]][k]);
      }
    }
    return result;
  }

  std::span<const Point> places_;
  Steps step_;
  std::vector<Directed> edges_;             // edges of rings, ascending
  std::vector<std::ptrdiff_t> first_edge_;  // for each place, the position of its first edge in edges_; and the end
  std::vector<Triangle> corners_, across_;
  std::vector<std::uint32_t> star_;  // for each place, a triangle with this corner
  // State of the insertion of an edge:
  std::vector<Rim> left_, right_;
  std::vector<std::uint32_t> slots_, taken_;  // removed triangles, in the order of removal; the same, ascending
  std::size_t free_ = 0;                      // the first entry of slots_ that no new triangle uses
  std::map<Directed, Side> waiting_;
  std::vector<Side> queue_;
};

}  // namespace

std::vector<Triangle> constrained_delaunay(const Outline& outline, const GoOn& go_on) {
  if (outline.rings.empty()) return {};
  return fits_double(magnitude_bound(outline.places)) ? Constrained<double>(outline, go_on).run()
                                                      : Constrained<long double>(outline, go_on).run();
}

}  // namespace rbpa
