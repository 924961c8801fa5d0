// How:  where the rings of a cell meet otherwise than in single points, or turn the wrong way, the vertex nearest to an
//       edge there is put on the edge, or merged with its end. Edges that a cell passes in both directions are removed.
//       This is repeated until all rings are right. docs/explanation/plane.md, section 34.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "rbpa/fill/rings/plane_distance.h"
#include "rbpa/fill/rings/simple_rings.h"
#include "rbpa/fill/voronoi/cut_cells.h"
#include "rbpa/plane/predicate/plane_predicates.h"
#include "rbpa/plane/shape/measure.h"

namespace rbpa {
namespace {

using RingEdge = std::array<std::uint32_t, 2>;

struct RoundedCell {
  std::uint32_t of;
  std::vector<Ring> rings = {};
  std::vector<RingPlace> places = {};
  bool is_right = false;  ///< whether the rings are those of valid polygons, at `places`
};

RingEdge edge_from(const Ring& ring, std::size_t i) {
  return {ring.points[i], ring.points[(i + 1) % ring.points.size()]};
}

class Tidying {
 public:
  Tidying(CutCells&& cut, const GoOn& go_on)
      : is_given_(std::move(cut.is_given)), step_(go_on), on_path_(cut.points.size()), kept_(cut.points.size()) {
    std::iota(kept_.begin(), kept_.end(), 0U);
    double largest = 0;
    for (const Point& p : cut.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    exponent_ = largest > 0 ? -std::ilogb(largest) : 0;
    made_.points = std::move(cut.points);
    for (std::size_t i = 0; i < cut.loops.size(); ++i) {
      if (cells_.empty() || cells_.back().of != cut.of[i]) cells_.push_back({.of = cut.of[i]});
      cells_.back().rings.push_back(std::move(cut.loops[i]));
    }
  }

  VoronoiCells run() {
    for (RoundedCell& cell : cells_) normalize(cell);
    while (!all_are_right()) apply_changes();
    for (RoundedCell& cell : cells_)
      if (cell.of != no_index) add_polygons(cell);
    return std::move(made_);
  }

 private:
  const Point& at(std::uint32_t vertex) const { return made_.points[vertex]; }

  /// Makes rings of the edges of a cell that pass no vertex twice. An edge passed in both directions vanishes.
  void normalize(RoundedCell& cell) {
    std::vector<RingEdge> edges, left;
    for (const Ring& ring : cell.rings)
      for (std::size_t i = 0; i < ring.points.size(); ++i)
        if (const RingEdge edge = edge_from(ring, i); edge[0] != edge[1]) edges.push_back(edge);
    std::sort(edges.begin(), edges.end());
    for (auto begin = edges.begin(); begin != edges.end();) {
      const auto end = std::upper_bound(begin, edges.end(), *begin);
      const auto [back, back_end] = std::equal_range(edges.begin(), edges.end(), RingEdge{(*begin)[1], (*begin)[0]});
      for (auto removed = back_end - back; end - begin > removed; ++removed) left.push_back(*begin);
      begin = end;
    }
    cell.rings.clear();
    cell.is_right = false;
    std::vector<bool> is_used(left.size(), false);
    for (std::size_t first = 0; first < left.size(); ++first) {
      if (is_used[first]) continue;
      std::vector<std::uint32_t> path;
      for (std::size_t e = first;; e = next_edge(left, is_used, left[e])) {
        step_();
        is_used[e] = true;
        const auto [from, to] = left[e];
        path.push_back(from);
        on_path_[from] = true;
        if (!on_path_[to]) continue;
        // The path since `to` is a ring.
        const auto begin = std::find(path.begin(), path.end(), to);
        for (auto v = begin; v != path.end(); ++v) on_path_[*v] = false;
        std::rotate(begin, std::min_element(begin, path.end()), path.end());
        cell.rings.push_back({{begin, path.end()}});
        path.erase(begin, path.end());
        if (path.empty()) break;
      }
    }
    std::sort(cell.rings.begin(), cell.rings.end(), [](const Ring& a, const Ring& b) { return a.points < b.points; });
  }

  /// Returns the edge that follows `edge` around the part of the cell on its left.
  std::size_t next_edge(const std::vector<RingEdge>& edges, const std::vector<bool>& is_used,
                        const RingEdge& edge) const {
    std::size_t next = edges.size();
    for (auto e = static_cast<std::size_t>(std::lower_bound(edges.begin(), edges.end(), RingEdge{edge[1], 0}) -
                                           edges.begin());
         e < edges.size() && edges[e][0] == edge[1]; ++e)
      if (!is_used[e] &&
          (next == edges.size() || is_before(at(edge[1]), at(edge[0]), at(edges[next][1]), at(edges[e][1]))))
        next = e;
    return next;
  }

  /// Returns whether a ray around `center`, turned counter-clockwise from p, passes q before r.
  static bool is_before(const Point& center, const Point& p, const Point& q, const Point& r) {
    const int of_q = quick_orientation(center, p, q), of_r = quick_orientation(center, p, r);
    if (of_q != of_r) return of_q > of_r;
    return quick_orientation(center, q, r) > 0;
  }

  /// Returns whether the ring is convex and counter-clockwise; vertices may lie on its sides.
  bool is_convex(const Ring& ring) const {
    std::size_t turns_back = 0;
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
      const auto [a, b] = edge_from(ring, i);
      const std::uint32_t c = edge_from(ring, (i + 1) % ring.points.size())[1];
      const bool goes_on = (a < b) == (b < c);  // the order of vertices is lexicographic
      const int turn = quick_orientation(at(a), at(b), at(c));
      if (turn < 0 || (turn == 0 && !goes_on)) return false;
      if (!goes_on) ++turns_back;
    }
    return turns_back == 2;
  }

  /// Returns whether the rings of all cells are right; otherwise, changes are noted that apply_changes() makes.
  bool all_are_right() {
    bool all = true;
    for (RoundedCell& cell : cells_) {
      if (!cell.is_right) check(cell);
      all = all && cell.is_right;
    }
    return all;
  }

  void check(RoundedCell& cell) {
    step_(cell.rings.size());
    cell.places.assign(cell.rings.size(), {.is_counter_clockwise = true});
    cell.is_right = cell.rings.empty() || (cell.rings.size() == 1 && is_convex(cell.rings[0]));
    if (cell.is_right) return;
    NestedRings nested = nest_rings(made_.points, cell.rings);
    if (nested.meet) {
      const auto edge = [&](const RingsMeet::Side& s) { return edge_from(cell.rings[s.ring], s.edge); };
      return bring_together(cell, {edge(nested.meet->first), edge(nested.meet->second)});
    }
    for (std::size_t r = 0; r < cell.rings.size(); ++r)
      if (nested.place[r].is_counter_clockwise == nested.place[r].is_hole()) {
        std::vector<RingEdge> edges;
        for (std::size_t i = 0; i < cell.rings[r].points.size(); ++i) edges.push_back(edge_from(cell.rings[r], i));
        return bring_together(cell, edges);
      }
    cell.places = std::move(nested.place);
    cell.is_right = true;
  }

  /// Returns a distance, scaled so that no square of a coordinate overflows.
  template <typename... Points>
  double distance_of(const Points&... points) const {
    return distance(Point{std::scalbn(points.x, exponent_), std::scalbn(points.y, exponent_)}...);
  }

  /// Notes a change: of the vertices and edges of `edges`, the vertex and the edge nearest to each other are brought
  /// together. The vertex becomes one with an end of the edge if that is about as near, and a vertex of the edge
  /// otherwise. If there is no such pair, the ends of the shortest edge of the cell become one.
  void bring_together(const RoundedCell& cell, const std::vector<RingEdge>& edges) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    double least = infinite;
    std::uint32_t vertex = 0;
    RingEdge edge = {};
    for (const RingEdge& e : edges)
      for (const RingEdge& f : edges)
        for (const std::uint32_t v : f) {
          if (v == e[0] || v == e[1]) continue;
          const double away = distance_of(at(v), at(e[0]), at(e[1]));
          if (away < least) std::tie(least, vertex, edge) = std::tie(away, v, e);
        }
    if (least < infinite) {
      const double from = distance_of(at(vertex), at(edge[0])), to = distance_of(at(vertex), at(edge[1]));
      if (std::min(from, to) <= 2 * least) return merge(vertex, edge[from <= to ? 0 : 1]);
      const auto [known, is_new] =
          inserted_.try_emplace({std::min(edge[0], edge[1]), std::max(edge[0], edge[1])}, vertex);
      known->second = std::min(known->second, vertex);
      if (is_new) ++made_.inserted;
      return;
    }
    for (const Ring& ring : cell.rings)
      for (std::size_t i = 0; i < ring.points.size(); ++i)
        if (const RingEdge e = edge_from(ring, i); distance_of(at(e[0]), at(e[1])) < least) {
          least = distance_of(at(e[0]), at(e[1]));
          edge = e;
        }
    merge(edge[0], edge[1]);
  }

  std::uint32_t kept(std::uint32_t vertex) const {
    while (kept_[vertex] != vertex) vertex = kept_[vertex];
    return vertex;
  }
  /// Notes that two vertices become one: a corner of the boundary rather than another, then the lesser.
  void merge(std::uint32_t a, std::uint32_t b) {
    a = kept(a);
    b = kept(b);
    if (a == b) return;
    if (is_given_[a] == is_given_[b] ? b < a : is_given_[b]) std::swap(a, b);
    kept_[b] = a;
    ++made_.merged;
  }

  void apply_changes() {
    for (RoundedCell& cell : cells_) {
      bool changes = false;
      for (Ring& ring : cell.rings) {
        std::vector<std::uint32_t> points;
        for (std::size_t i = 0; i < ring.points.size(); ++i) {
          step_();
          const auto [from, to] = edge_from(ring, i);
          points.push_back(kept(from));
          const auto found = inserted_.find({std::min(from, to), std::max(from, to)});
          if (found != inserted_.end()) points.push_back(kept(found->second));
        }
        changes = changes || points != ring.points;
        ring.points = std::move(points);
      }
      if (changes) normalize(cell);
    }
    inserted_.clear();
  }

  void add_polygons(RoundedCell& cell) {
    const std::size_t first = made_.polygons.size();
    std::vector<std::size_t> polygon_of(cell.rings.size());
    for (std::size_t r = 0; r < cell.rings.size(); ++r) {
      if (cell.places[r].is_hole()) continue;
      polygon_of[r] = made_.polygons.size();
      made_.polygons.push_back({.shell = std::move(cell.rings[r])});
      made_.of.push_back(cell.of);
    }
    for (std::size_t r = 0; r < cell.rings.size(); ++r)
      if (cell.places[r].is_hole())
        made_.polygons[polygon_of[*cell.places[r].inside]].holes.push_back(std::move(cell.rings[r]));
    for (std::size_t i = first; i < made_.polygons.size(); ++i) measure(made_.polygons[i], made_.points);
  }

  std::vector<bool> is_given_;
  Steps step_;
  std::vector<bool> on_path_;
  std::vector<std::uint32_t> kept_;             // for each vertex the one with which it was merged, or itself
  std::map<RingEdge, std::uint32_t> inserted_;  // for each edge that changes the vertex on it
  int exponent_ = 0;
  std::vector<RoundedCell> cells_;
  VoronoiCells made_;
};

}  // namespace

VoronoiCells tidy(CutCells cells, const GoOn& go_on) { return Tidying(std::move(cells), go_on).run(); }

}  // namespace rbpa
