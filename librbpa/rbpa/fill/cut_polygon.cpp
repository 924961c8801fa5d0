#include "rbpa/fill/cut_polygon.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "rbpa/base/error.h"
#include "rbpa/fill/polygons_of_rings.h"
#include "rbpa/plane/predicate/plane_predicates.h"

namespace rbpa {
namespace {

using Corners = std::vector<std::uint32_t>;

int side_of(const Point& p, double x) { return p.x < x ? -1 : p.x > x ? 1 : 0; }

/// A set of directed edges with the inside on their left. Joins the edges into rings.
class Boundary {
 public:
  explicit Boundary(std::span<const Point> points) : points_(points) {}

  /// Adds a closed curve; keeps one of consecutive corners with equal coordinates.
  void add(const Corners& closed) {
    Corners corners;
    for (const std::uint32_t i : closed) {
      const std::uint32_t corner = first_at_.emplace(points_[i], i).first->second;
      if (corners.empty() || corners.back() != corner) corners.push_back(corner);
    }
    if (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
    for (std::size_t k = 0; corners.size() > 1 && k < corners.size(); ++k) {
      const auto edge = static_cast<std::uint32_t>(edges_.size());
      edges_.push_back({corners[k], corners[(k + 1) % corners.size()]});
      at_[edges_.back().from].push_back({edges_.back().to, edge, true});
      at_[edges_.back().to].push_back({edges_.back().from, edge, false});
    }
  }

  /// Returns the rings. Each walk along edges leads around one piece of the inside. If a walk returns to a corner, the
  /// part since the first visit becomes a separate ring.
  std::vector<Ring> rings() {
    Corners next(edges_.size());
    for (auto& [corner, ends] : at_) pair(corner, ends, next);
    std::vector<bool> done(edges_.size(), false);
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      Corners walk;
      for (std::uint32_t at = e; !done[at]; at = next[at]) {
        done[at] = true;
        walk.push_back(edges_[at].from);
      }
      split(walk);
    }
    return std::move(rings_);
  }

 private:
  struct DirectedEdge {
    std::uint32_t from, to;
  };
  /// An edge at a corner: the other end of the edge, its number, and whether the edge leaves the corner.
  struct End {
    std::uint32_t other, edge;
    bool leaves;
  };

  /// Stores in `next`, for each edge that arrives at `corner`, the leaving edge that follows on the ring. The inside
  /// lies counter-clockwise from the leaving edge to the arriving edge.
  void pair(std::uint32_t corner, std::vector<End>& ends, Corners& next) const {
    const Point& p = points_[corner];
    const auto is_below = [&](const End& end) {
      const Point& q = points_[end.other];
      return q.y < p.y || (q.y == p.y && q.x < p.x);
    };
    std::sort(ends.begin(), ends.end(), [&](const End& a, const End& b) {
      if (is_below(a) != is_below(b)) return is_below(b);
      return plane_orientation(p, points_[a.other], points_[b.other]) > 0;
    });
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const End &leaving = ends[k], &coming = ends[(k + 1) % ends.size()];
      if (leaving.leaves == coming.leaves)
        throw InvalidInput("a polygon at (" + std::to_string(p.x) + ", " + std::to_string(p.y) +
                           "): found rings that cross or have the wrong orientation, expected a valid polygon with a "
                           "counter-clockwise shell");
      if (leaving.leaves) next[coming.edge] = leaving.edge;
    }
  }

  void split(const Corners& walk) {
    Corners open;
    std::map<std::uint32_t, std::size_t> place;
    const auto end_ring = [&](std::size_t first) {
      const auto begin = open.begin() + static_cast<std::ptrdiff_t>(first);
      for (auto i = begin; i != open.end(); ++i) place.erase(*i);
      if (open.end() - begin >= 3) rings_.push_back({{begin, open.end()}});
      open.erase(begin, open.end());
    };
    for (const std::uint32_t corner : walk) {
      if (const auto before = place.find(corner); before != place.end()) end_ring(before->second);
      place.emplace(corner, open.size());
      open.push_back(corner);
    }
    end_ring(0);
  }

  std::span<const Point> points_;
  std::map<Point, std::uint32_t> first_at_ = {};
  std::vector<DirectedEdge> edges_ = {};
  std::map<std::uint32_t, std::vector<End>> at_ = {};
  std::vector<Ring> rings_ = {};
};

/// A builder of the rings around the part of a polygon left of a vertical line.
class LeftRings {
 public:
  /// Takes the points of PolygonCut. Point `first_crossing` + i is on an edge whose end right of the line is
  /// right_end[i].
  LeftRings(std::span<const Point> points, double x, std::uint32_t first_crossing, const Corners& right_end)
      : points_(points), x_(x), first_crossing_(first_crossing), right_end_(right_end), boundary_(points) {}

  /// Returns the rings left of the line. `rings` have the interior on their left and a corner at each crossing.
  /// Messages call the line x = `line`.
  std::vector<Ring> find(const std::vector<Corners>& rings, double line) {
    for (const Corners& ring : rings) take(ring);
    // Upward along the line, each stretch in the polygon begins at the last end of a chain and ends at the first end of
    // a chain.
    std::sort(ends_.begin(), ends_.end(), [this](const End& a, const End& b) { return is_below(a, b); });
    Corners next(chains_.size());
    for (std::size_t i = 0; i < ends_.size(); i += 2) {
      if (!ends_[i].is_last || ends_[i + 1].is_last)
        throw InvalidInput("a polygon at x = " + std::to_string(line) +
                           ": found rings that cross or have the wrong orientation, expected a valid polygon with a "
                           "counter-clockwise shell");
      next[ends_[i].chain] = ends_[i + 1].chain;
    }
    std::vector<bool> done(chains_.size(), false);
    for (std::uint32_t c = 0; c < chains_.size(); ++c) {
      Corners joined;
      for (std::uint32_t at = c; !done[at]; at = next[at]) {
        done[at] = true;
        joined.insert(joined.end(), chains_[at].begin(), chains_[at].end());
      }
      boundary_.add(joined);
    }
    return boundary_.rings();
  }

 private:
  /// An end of a chain, at which the chain leaves the line or returns to the line. The end is on the edge from `inner`,
  /// left of the line, to `outer`, on the line or right of it.
  struct End {
    std::uint32_t chain, inner, outer;
    bool is_last;
  };

  int side(std::uint32_t i) const { return side_of(points_[i], x_); }

  /// Adds the parts of a ring left of the line as chains, each from a point on the line to the next point on the line.
  /// Adds the whole ring if it lies left of the line without a point on the line.
  void take(const Corners& ring) {
    const auto is_on = [this](std::uint32_t i) { return side(i) == 0; };
    const auto first = std::find_if(ring.begin(), ring.end(), is_on);
    if (first == ring.end()) {
      if (!ring.empty() && side(ring.front()) < 0) boundary_.add(ring);
      return;
    }
    const auto begin = static_cast<std::size_t>(first - ring.begin());
    const auto corner = [&](std::size_t i) { return ring[(begin + i) % ring.size()]; };
    Corners chain;
    for (std::size_t i = 0; i <= ring.size(); ++i) {
      const std::uint32_t at = corner(i);
      if (!chain.empty()) chain.push_back(at);
      if (!is_on(at)) continue;
      if (!chain.empty()) add(std::exchange(chain, {}));
      if (i < ring.size() && side(corner(i + 1)) < 0) chain = {at};
    }
  }

  void add(Corners chain) {
    const auto number = static_cast<std::uint32_t>(chains_.size());
    const auto outer = [this](std::uint32_t i) { return i < first_crossing_ ? i : right_end_[i - first_crossing_]; };
    ends_.push_back({number, chain[1], outer(chain.front()), false});
    ends_.push_back({number, chain[chain.size() - 2], outer(chain.back()), true});
    chains_.push_back(std::move(chain));
  }

  /// Returns whether `a` is below `b` just left of the line. Requires: the edges of both meet in their ends only.
  bool is_below(const End& a, const End& b) const {
    const Point &p = points_[a.inner], &q = points_[b.inner];
    if (p.x < q.x) {
      const int turn = plane_orientation(p, points_[a.outer], q);
      return (turn != 0 ? turn : plane_orientation(p, points_[a.outer], points_[b.outer])) > 0;
    }
    const int turn = plane_orientation(q, points_[b.outer], p);
    return (turn != 0 ? turn : plane_orientation(q, points_[b.outer], points_[a.outer])) < 0;
  }

  std::span<const Point> points_;
  double x_;
  std::uint32_t first_crossing_;
  const Corners& right_end_;
  std::vector<Corners> chains_ = {};
  std::vector<End> ends_ = {};
  Boundary boundary_;
};

/// Returns the polygons of rings; each ring begins at its lexicographically least point.
std::vector<Polygon> polygons_on(std::span<const Point> points, const std::vector<Ring>& rings) {
  std::vector<Polygon> polygons = polygons_of_rings(points, rings);
  const auto begin_at_least = [&](Ring& ring) {
    const auto is_less = [&](std::uint32_t i, std::uint32_t j) { return points[i] < points[j]; };
    std::rotate(ring.points.begin(), std::min_element(ring.points.begin(), ring.points.end(), is_less),
                ring.points.end());
  };
  for (Polygon& polygon : polygons) {
    begin_at_least(polygon.shell);
    for (Ring& hole : polygon.holes) begin_at_least(hole);
  }
  return polygons;
}

}  // namespace

PolygonCut cut_at(std::span<const Point> points, const Polygon& polygon, double x) {
  PolygonCut cut{.points = {points.begin(), points.end()}, .crossings = {}, .left = {}, .right = {}};
  std::vector<Corners> rings;
  Corners left_end, right_end;
  const auto take = [&](const Ring& ring) {
    Corners& corners = rings.emplace_back();
    for (std::size_t k = 0; k < ring.points.size(); ++k) {
      std::uint32_t a = ring.points[k], b = ring.points[(k + 1) % ring.points.size()];
      corners.push_back(a);
      if (side_of(points[a], x) * side_of(points[b], x) >= 0) continue;
      if (points[a].x > points[b].x) std::swap(a, b);
      const Point &p = points[a], &q = points[b];
      const double share = (x - p.x) / (q.x - p.x);
      corners.push_back(static_cast<std::uint32_t>(cut.points.size()));
      cut.points.push_back({x, p.y + (q.y - p.y) * share});
      cut.crossings.push_back({a, b, share});
      left_end.push_back(a);
      right_end.push_back(b);
    }
  };
  take(polygon.shell);
  for (const Ring& hole : polygon.holes) take(hole);

  const auto given = static_cast<std::uint32_t>(points.size());
  cut.left = polygons_on(cut.points, LeftRings(cut.points, x, given, right_end).find(rings, x));
  // Mirrored points have the right part of the polygon left of the line, and rings of the opposite orientation.
  std::vector<Point> mirrored = cut.points;
  for (Point& p : mirrored) p.x = -p.x;
  for (Corners& ring : rings) std::reverse(ring.begin(), ring.end());
  cut.right = polygons_on(cut.points, LeftRings(mirrored, -x, given, left_end).find(rings, x));
  return cut;
}

}  // namespace rbpa
