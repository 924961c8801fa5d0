#include "rbpa/fill/voronoi/cut_cells.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "meshops/core/contract.h"
#include "rbpa/plane/predicate/constructions.h"
#include "rbpa/plane/predicate/predicates.h"
#include "rbpa/plane/voronoi/cell_ridges.h"

namespace rbpa {
namespace {

/// A point at which a ring goes from one cell to another.
struct RingCrossing {
  std::uint32_t from, to;  ///< the points of the cells
  Line edge;
  std::uint32_t corner, corners = 0;  ///< the corners of the ring up to its next crossing: the first one, their number
  std::uint32_t next = 0;             ///< the next crossing of the ring
  std::array<std::uint32_t, 2> ridge() const { return {std::min(from, to), std::max(from, to)}; }
};

class CellCutter {
 public:
  CellCutter(const Delaunay& delaunay, std::span<const Point> points, std::span<const Ring> rings, Steps& step)
      : ridges_(delaunay, step), triangles_(delaunay.triangulation()), points_(points), rings_(rings), step_(step) {}

  CutCells cut() {
    is_crossed_.resize(ridges_.delaunay().points().size());
    for (const Ring& ring : rings_) walk(ring);
    sort_along_ridges();
    find_inside();
    for (std::uint32_t p = 0; p < is_crossed_.size(); ++p)
      if (ridges_.has_cell(p)) trace(p);
    add_rings();
    return numbered();
  }

 private:
  /// Returns whether `at`, a corner of a ring, is nearer to q than to p.
  bool is_nearer(const Point& at, std::uint32_t q, std::uint32_t p) const {
    const Point &of_p = ridges_.point(p), &of_q = ridges_.point(q);
    const int farther = Predicates<long double>::compare_distances(at, of_p, of_q);
    return farther != 0 ? farther > 0 : of_q > of_p;  // moved by (ε, ε²), it is nearer to the larger
  }

  /// Returns the cell of a corner of a ring, by a walk to ever nearer points.
  std::uint32_t cell_at(const Point& at) {
    std::uint32_t cell = near_;
    for (bool moves = true; std::exchange(moves, false);)
      ridges_.for_each(cell, [&](const CellRidge& ridge) {
        step_();
        if (is_nearer(at, ridge.other, cell)) {
          cell = ridge.other;
          moves = true;
        }
        return moves;
      });
    return near_ = cell;
  }

  /// Returns on which side of the line the end of a ridge of cell p is, 1 for left.
  int side(const Line& line, std::uint32_t p, const CellRidge& ridge, bool of_end) const {
    const std::uint32_t t = of_end ? ridge.to : ridge.from, other_end = of_end ? ridge.from : ridge.to;
    if (t == no_index) {
      const int side = dot_sign(line, ridges_.point(p), ridges_.point(ridge.other));
      if (side != 0) return of_end ? side : -side;
      return other_end == no_index ? 1 : this->side(line, p, ridge, !of_end);  // the ridge is parallel to the line
    }
    const auto& [a, b, c] = triangles_.triangles[t];
    const int side = side_of_circumcenter(line, ridges_.point(a), ridges_.point(b), ridges_.point(c));
    if (side != 0) return side;
    // The line, moved by (ε, ε²), passes the center.
    if (line.to.y != line.from.y) return line.to.y > line.from.y ? 1 : -1;
    return line.to.x < line.from.x ? 1 : -1;
  }

  /// Returns the cell into which the line leaves cell p; no_index if it does not.
  std::uint32_t beyond(const Line& line, std::uint32_t p) {
    std::uint32_t found = no_index;
    ridges_.for_each(p, [&](const CellRidge& ridge) {
      step_();
      if (side(line, p, ridge, false) < 0 && side(line, p, ridge, true) > 0) found = ridge.other;
      return found != no_index;
    });
    return found;
  }

  void walk(const Ring& ring) {
    const std::size_t first = crossings_.size();
    const auto corner = static_cast<std::uint32_t>(corners_.size());
    const std::uint32_t begin = cell_at(points_[ring.points[0]]);
    std::uint32_t cell = begin;
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
      const Line edge = {points_[ring.points[i]], points_[ring.points[(i + 1) % ring.points.size()]]};
      corners_.push_back(edge.from);
      for (std::uint32_t next = beyond(edge, cell); next != no_index && is_nearer(edge.to, next, cell);
           next = beyond(edge, cell)) {
        crossings_.push_back({cell, next, edge, static_cast<std::uint32_t>(corners_.size())});
        is_crossed_[cell] = is_crossed_[next] = true;
        cell = next;
      }
    }
    meshops::require(cell == begin, "voronoi_cells: found a ring that does not end where it begins");
    const std::size_t size = corners_.size() - corner;
    if (crossings_.size() == first) return whole_.push_back({cell, corner, static_cast<std::uint32_t>(size)});
    // The corners before the first crossing follow the last one: they are repeated there.
    const std::uint32_t before = crossings_[first].corner;
    for (std::uint32_t i = corner; i < before; ++i) corners_.push_back(Point(corners_[i]));
    for (std::size_t j = first; j < crossings_.size(); ++j) {
      const bool is_last = j + 1 == crossings_.size();
      crossings_[j].next = static_cast<std::uint32_t>(is_last ? first : j + 1);
      const std::size_t end = is_last ? corners_.size() : crossings_[j + 1].corner;
      crossings_[j].corners = static_cast<std::uint32_t>(end - crossings_[j].corner);
    }
  }

  /// Sorts the crossings of each ridge in the order in which they are met with the lower point on the left.
  void sort_along_ridges() {
    on_ridges_.resize(crossings_.size());
    std::iota(on_ridges_.begin(), on_ridges_.end(), 0U);
    const auto ridge = [&](std::uint32_t j) { return crossings_[j].ridge(); };
    sort(on_ridges_, step_, [&](std::uint32_t i, std::uint32_t j) { return ridge(i) < ridge(j); });
    for (auto begin = on_ridges_.begin(); begin != on_ridges_.end();) {
      const auto end = std::find_if(begin, on_ridges_.end(), [&](auto j) { return ridge(j) != ridge(*begin); });
      std::vector<Line> lines;
      for (auto at = begin; at != end; ++at) lines.push_back(crossings_[*at].edge);
      const auto [p, q] = ridge(*begin);
      const std::vector<std::uint32_t> unsorted(begin, end);
      for (const std::size_t i : order_along_bisector(ridges_.point(p), ridges_.point(q), lines))
        *begin++ = unsorted[i];
    }
  }

  /// Returns the crossings of the ridge of cells p and q, in the order of sort_along_ridges().
  std::span<const std::uint32_t> crossings_of(std::uint32_t p, std::uint32_t q) const {
    if (!is_crossed_[p] || !is_crossed_[q]) return {};
    const std::array<std::uint32_t, 2> ridge = {std::min(p, q), std::max(p, q)};
    const auto begin = std::lower_bound(on_ridges_.begin(), on_ridges_.end(), ridge,
                                        [&](std::uint32_t j, const auto& r) { return crossings_[j].ridge() < r; });
    const auto end = std::find_if(begin, on_ridges_.end(), [&](auto j) { return crossings_[j].ridge() != ridge; });
    return std::span(on_ridges_)
        .subspan(static_cast<std::size_t>(begin - on_ridges_.begin()), static_cast<std::size_t>(end - begin));
  }

  /// Finds the triangles whose circumcenter is in the region: infinity is not, and each crossing of a ridge changes it.
  void find_inside() {
    const std::size_t size = triangles_.triangles.size();
    inside_.resize(size);
    std::vector<bool> is_known(size, false);
    std::vector<std::uint32_t> queue;
    const auto reach = [&](std::uint32_t t, std::size_t k, bool from_inside, std::uint32_t to) {
      if (is_known[to]) return;
      is_known[to] = true;
      const Triangle& corners = triangles_.triangles[t];
      inside_[to] = from_inside != (crossings_of(corners[(k + 1) % 3], corners[(k + 2) % 3]).size() % 2 != 0);
      queue.push_back(to);
    };
    for (std::uint32_t t = 0; t < size && queue.empty(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        if (triangles_.neighbors[t][k] == no_index) reach(t, k, false, t);
    while (!queue.empty()) {
      step_();
      const std::uint32_t t = queue.back();
      queue.pop_back();
      for (std::size_t k = 0; k < 3; ++k)
        if (const std::uint32_t other = triangles_.neighbors[t][k]; other != no_index) reach(t, k, inside_[t], other);
    }
  }

  // Vertices are numbered: circumcenters by triangle, crossings, corners.
  std::uint32_t vertex_of_crossing(std::uint32_t j) const {
    return static_cast<std::uint32_t>(triangles_.triangles.size()) + j;
  }
  std::uint32_t vertex_of_corner(std::uint32_t i) const {
    return vertex_of_crossing(static_cast<std::uint32_t>(crossings_.size())) + i;
  }

  /// Traces the loops of cell p: parts of its ridges in the region, joined by parts of rings in the cell.
  void trace(std::uint32_t p) {
    /// Vertices in a row along the ridges, from one crossing to another, or all around.
    struct Chain {
      std::uint32_t begin = no_index, end = no_index;
      std::vector<std::uint32_t> vertices = {};
    };
    std::vector<Chain> chains(1);
    bool is_inside = false, was_inside_first = false, is_first = true;
    ridges_.for_each(p, [&](const CellRidge& ridge) {
      step_();
      if (std::exchange(is_first, false)) is_inside = was_inside_first = ridge.from != no_index && inside_[ridge.from];
      const std::span<const std::uint32_t> along = crossings_of(p, ridge.other);
      for (std::size_t i = 0; i < along.size(); ++i) {
        const std::uint32_t j = along[p < ridge.other ? i : along.size() - 1 - i];
        is_inside = !is_inside;
        if (is_inside)
          chains.push_back({.begin = j});
        else
          chains.back().end = j;
        chains.back().vertices.push_back(vertex_of_crossing(j));
      }
      if (is_inside && ridge.to != no_index) chains.back().vertices.push_back(ridge.to);
      return false;
    });
    if (was_inside_first && chains.size() > 1) {  // the last chain continues with the first
      std::vector<std::uint32_t>& last = chains.back().vertices;
      last.insert(last.end(), chains[0].vertices.begin(), chains[0].vertices.end());
      chains.back().end = chains[0].end;
    }
    if (chains.size() == 1) {
      if (was_inside_first) add_loop(p, std::move(chains[0].vertices));
      return;
    }
    chains.erase(chains.begin());
    std::vector<bool> is_done(chains.size(), false);
    for (std::size_t first = 0; first < chains.size(); ++first) {
      if (is_done[first]) continue;
      std::vector<std::uint32_t> loop;
      for (std::size_t at = first; !is_done[at];) {
        is_done[at] = true;
        loop.insert(loop.end(), chains[at].vertices.begin(), chains[at].vertices.end());
        const RingCrossing& enters = crossings_[chains[at].end];
        for (std::uint32_t i = 0; i < enters.corners; ++i) loop.push_back(vertex_of_corner(enters.corner + i));
        const auto next =
            std::find_if(chains.begin(), chains.end(), [&](const Chain& c) { return c.begin == enters.next; });
        meshops::require(next != chains.end(), "voronoi_cells: found a ring that leaves a cell where no ridge begins");
        at = static_cast<std::size_t>(next - chains.begin());
      }
      add_loop(p, std::move(loop));
    }
  }

  void add_loop(std::uint32_t cell, std::vector<std::uint32_t> vertices) {
    loops_.emplace_back(cell, Ring{std::move(vertices)});
  }

  /// Adds the rings that cross no ridge to the loops of their cells, and all rings as those of no cell.
  void add_rings() {
    for (const auto& [cell, corner, size] : whole_) {
      std::vector<std::uint32_t> vertices(size);
      std::iota(vertices.begin(), vertices.end(), vertex_of_corner(corner));
      add_loop(cell, vertices);
      add_loop(no_index, std::move(vertices));
    }
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t j = 0; j < crossings_.size(); ++j) {
      vertices.push_back(vertex_of_crossing(j));
      for (std::uint32_t i = 0; i < crossings_[j].corners; ++i)
        vertices.push_back(vertex_of_corner(crossings_[j].corner + i));
      if (crossings_[j].next <= j) add_loop(no_index, std::exchange(vertices, {}));
    }
    std::stable_sort(loops_.begin(), loops_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  Point position(std::uint32_t vertex) const {
    if (vertex >= vertex_of_corner(0)) return corners_[vertex - vertex_of_corner(0)];
    if (vertex >= vertex_of_crossing(0)) {
      const RingCrossing& crossing = crossings_[vertex - vertex_of_crossing(0)];
      const auto [p, q] = crossing.ridge();
      return crossing_of_bisector(ridges_.point(p), ridges_.point(q), crossing.edge);
    }
    const auto& [a, b, c] = triangles_.triangles[vertex];
    return circumcenter(ridges_.point(a), ridges_.point(b), ridges_.point(c));
  }

  CutCells numbered() {
    CutCells result;
    std::vector<std::uint32_t> number(vertex_of_corner(static_cast<std::uint32_t>(corners_.size())), no_index);
    std::vector<std::pair<Point, std::uint32_t>> used;
    for (const auto& [cell, loop] : loops_)
      for (const std::uint32_t vertex : loop.points) {
        step_();
        if (std::exchange(number[vertex], 0) == no_index) used.emplace_back(position(vertex), vertex);
      }
    sort(used, step_, [](const auto& a, const auto& b) { return a < b; });
    for (const auto& [at, vertex] : used) {
      if (result.points.empty() || result.points.back() != at) {
        result.points.push_back({at.x + 0.0, at.y + 0.0});  // no −0
        result.is_given.push_back(false);
      }
      number[vertex] = static_cast<std::uint32_t>(result.points.size() - 1);
      if (vertex >= vertex_of_corner(0)) result.is_given.back() = true;
    }
    for (auto& [cell, loop] : loops_) {
      for (std::uint32_t& vertex : loop.points) vertex = number[vertex];
      result.loops.push_back(std::move(loop));
      result.of.push_back(cell);
    }
    return result;
  }

  CellRidges ridges_;
  TriangleArrays triangles_;
  std::span<const Point> points_;
  std::span<const Ring> rings_;
  Steps& step_;
  std::uint32_t near_ = 0;  // the cell in which the last walk ended

  std::vector<RingCrossing> crossings_;  // ring by ring
  std::vector<Point> corners_;           // of rings, in order
  struct Whole {
    std::uint32_t cell, corner, corners;
  };
  std::vector<Whole> whole_;              // the rings within one cell
  std::vector<bool> is_crossed_;          // for each input point whether a ring leaves its cell
  std::vector<std::uint32_t> on_ridges_;  // the crossings, sorted by ridge and along it
  std::vector<bool> inside_;              // for each triangle whether its circumcenter is in the region
  std::vector<std::pair<std::uint32_t, Ring>> loops_;
};

}  // namespace

CutCells cut_cells(const Delaunay& delaunay, std::span<const Point> points, std::span<const Ring> rings, Steps& step) {
  return CellCutter(delaunay, points, rings, step).cut();
}

}  // namespace rbpa
