// What:   finds the edges of the Delaunay triangulation: divides the points into halves, and merges the triangulations
//         of the halves.
// Law:    cocircular points are decided by the symbolic perturbation (docs/explanation/exact_decisions.md): the edges
//         are a function of the set of points alone.
// How:    1. divide the points into halves, across the longer side of their box, until few are left: triangulate();
//         2. sort these few and triangulate them from left to right: triangulate_sorted();
//         3. merge halves, from the edge below both hulls up to the one above: merge().
//         Two threads work on two halves that have many points.
// Cost:   as divide_and_conquer.h; 76 bytes a point.
// Source: Guibas, Stolfi (1985), figure 23; Dwyer (1987), for halves that are not long and narrow.
//         docs/explanation/plane.md, section 14.
#pragma once

#include <cstddef>
#include <exception>
#include <mutex>
#include <span>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/progress.h"
#include "rbpa/plane/divide/halve.h"
#include "rbpa/plane/divide/quad_edges.h"
#include "rbpa/plane/predicate/chord.h"

namespace rbpa {

/// A counter of steps that calls working() once in many steps, in one thread at a time. After working() has thrown,
/// step() throws the same exception in every thread and does not call working() again.
class DivisionSteps {
 public:
  explicit DivisionSteps(const Checkpoint& working) : working_(working) {}

  void step(std::size_t& taken) {
    if (++taken < at_once) return;
    taken -= at_once;
    if (!working_) return;
    const std::lock_guard lock(mutex_);
    if (failure_) std::rethrow_exception(failure_);
    try {
      working_();
    } catch (...) {
      failure_ = std::current_exception();
      throw;
    }
  }

 private:
  static constexpr std::size_t at_once = 4096;
  const Checkpoint& working_;
  std::exception_ptr failure_;
  std::mutex mutex_;
};

template <typename Real>
class DelaunayEdges {
  using P = Predicates<Real>;
  using Edge = QuadEdges::Edge;
  using Corner = QuadEdges::Corner;

 public:
  /// Triangulates the points, and reorders `places`: corners of edges are positions in the new order. If `threads` is
  /// null, the calling thread does all the work. Calls working(), if any, repeatedly, in any thread and one call at a
  /// time; working() may throw.
  /// Requires: at least two distinct points, as divide_and_conquer() does.
  DelaunayEdges(std::span<SitePoint> places, Threads* threads, const Checkpoint& working)
      : places_(places), edges_(places.size()), hull_(places.size()), threads_(threads), steps_(working) {
    open_hull(triangulate(0, places_.size()).first_x);
  }

  /// Returns the edges. An edge in use has a triangle on its left, whose next side is lnext(). If there is no triangle,
  /// the number of the edge is `no_triangle`, and lnext() is 0.
  QuadEdges& edges() { return edges_; }
  static constexpr int no_triangle = -2;

 private:
  /// The extreme corners of a hull: the first and the last along x, and along y (halve.h).
  struct Extremes {
    Corner first_x, last_x, first_y, last_y;
  };
  /// The unused edges and the step count of a part of the points, so that several threads can work on different parts.
  struct Own {
    QuadEdges::Unused unused;
    std::size_t steps;  // number of steps since the last call of `working`
  };
  struct Part : Extremes, Own {};

  Part triangulate(std::size_t first, std::size_t last) {
    const std::span<SitePoint> places = places_.subspan(first, last - first);
    if (places.size() <= few) {
      sort_few(places, AlongX());
      Own own = {edges_.unused_for(first, last), 0};
      const Extremes extremes = triangulate_sorted(first, last, own);
      return {extremes, own};
    }
    const Sample sample(places);
    const bool along_x = sample.is_wide();
    const std::size_t middle = first + (along_x ? halve(places, sample, AlongX()) : halve(places, sample, AlongY()));
    Part a, b;
    const auto triangulate_half = [&](std::size_t half) {
      (half == 0 ? a : b) = half == 0 ? triangulate(first, middle) : triangulate(middle, last);
    };
    if (threads_ && places.size() >= min_for_threads) {
      for_each_index(*threads_, 2, triangulate_half);
    } else {
      triangulate_half(0);
      triangulate_half(1);
    }
    Own own = {edges_.joined(a.unused, b.unused), a.steps + b.steps};
    merge(along_x ? a.last_x : a.last_y, along_x ? b.first_x : b.first_y, static_cast<Corner>(middle), own);
    return {{first_of<AlongX>(a.first_x, b.first_x), last_of<AlongX>(a.last_x, b.last_x),
             first_of<AlongY>(a.first_y, b.first_y), last_of<AlongY>(a.last_y, b.last_y)},
            own};
  }

  Extremes triangulate_sorted(std::size_t first, std::size_t last, Own& own) {
    if (last - first <= 3) return triangulate_three(first, last, own.unused);
    const std::size_t middle = (first + last) / 2;
    const Extremes a = triangulate_sorted(first, middle, own), b = triangulate_sorted(middle, last, own);
    merge(a.last_x, b.first_x, static_cast<Corner>(middle), own);
    return {a.first_x, b.last_x, first_of<AlongY>(a.first_y, b.first_y), last_of<AlongY>(a.last_y, b.last_y)};
  }

  template <typename Order>
  Corner first_of(Corner p, Corner q) const {
    return Order()(places_[p], places_[q]) ? p : q;
  }
  template <typename Order>
  Corner last_of(Corner p, Corner q) const {
    return Order()(places_[p], places_[q]) ? q : p;
  }

  /// Triangulates two or three points.
  Extremes triangulate_three(std::size_t first, std::size_t last, QuadEdges::Unused& unused) {
    const auto a = static_cast<Corner>(first), c = static_cast<Corner>(last - 1);
    Extremes extremes = {a, c, first_of<AlongY>(a, c), last_of<AlongY>(a, c)};
    if (last - first == 2) {
      hull_[a] = edges_.make_edge(a, c, unused);
      hull_[c] = sym(hull_[a]);
      return extremes;
    }
    const Corner b = a + 1;
    extremes.first_y = first_of<AlongY>(extremes.first_y, b);
    extremes.last_y = last_of<AlongY>(extremes.last_y, b);
    const Edge ab = edges_.make_edge(a, b, unused), bc = edges_.make_edge(b, c, unused);
    edges_.insert(bc, sym(ab));
    const int turn = P::orientation(at(a), at(b), at(c));
    hull_[a] = ab;
    hull_[b] = bc;
    hull_[c] = sym(bc);
    if (turn == 0) return extremes;
    const Edge ca = edges_.connect(sym(bc), ab, unused);
    if (turn > 0) {
      hull_[c] = ca;
    } else {
      hull_[a] = sym(ca);
      hull_[b] = sym(ab);
    }
    return extremes;
  }

  /// Joins two triangulations that a line separates; `left_corner` and `right_corner` are the corners of the two hulls
  /// next to the line. Adds the edges between the two from the lowest to the highest, as seen with the triangulation of
  /// `left_corner` on the left. Places from `middle` on are on the right.
  void merge(Corner left_corner, Corner right_corner, Corner middle, Own& own) {
    Edge edge = lower_tangent(left_corner, right_corner, own.unused);
    hull_[edges_.dest(edge)] = sym(edge);
    for (;;) {
      steps_.step(own.steps);
      const Chord<Real> base(at(edges_.dest(edge)), at(edges_.org(edge)));
      // At either end of the base, the next edge above it is a candidate; edges that cannot be Delaunay are removed.
      const Edge back = sym(edge);
      Edge left = edges_.onext(back), right = edges_.oprev(edge);
      auto of_left = base.candidate(at(edges_.dest(left))), of_right = base.candidate(at(edges_.dest(right)));
      const bool is_left = base.is_left(of_left), is_right = base.is_left(of_right);
      if (!is_left && !is_right) break;
      const auto cut_off = [&](Edge& side, auto& of_side, auto next_of, bool is_of_left) {
        for (;;) {
          const Edge next = next_of(side);
          const Corner beyond = edges_.dest(next);
          if ((beyond < middle) != is_of_left) return;
          const auto of_next = base.candidate(at(beyond));
          if (!base.is_inside(of_next, of_side)) return;
          edges_.remove(side, own.unused);
          side = next;
          of_side = of_next;
        }
      };
      if (is_left)
        cut_off(
            left, of_left, [&](Edge e) { return edges_.onext(e); }, true);
      if (is_right)
        cut_off(
            right, of_right, [&](Edge e) { return edges_.oprev(e); }, false);
      edge = !is_left || (is_right && base.is_inside(of_right, of_left))
                 ? edges_.connect(edges_.lnext(right), back, own.unused)
                 : edges_.connect(edges_.oprev(edge), sym(left), own.unused);
    }
    hull_[edges_.org(edge)] = edge;
  }

  /// Adds the lower common tangent of both hulls as an edge from right to left, and returns this edge.
  Edge lower_tangent(Corner left_corner, Corner right_corner, QuadEdges::Unused& unused) {
    Edge left = edges_.oprev(hull_[left_corner]), right = hull_[right_corner];
    for (;;) {
      const Point &l = at(edges_.org(left)), &r = at(edges_.org(right));
      if (P::orientation(l, at(edges_.dest(left)), r) > 0)
        left = edges_.lnext(left);
      else if (P::orientation(r, at(edges_.dest(right)), l) < 0)
        right = edges_.rprev(right);
      else
        return edges_.connect(edges_.oprev(right), left, unused);
    }
  }

  /// Marks the outside of the hull: edges with the outside on their left get the number `no_triangle` and the lnext()
  /// 0.
  void open_hull(Corner on_hull) {
    const Edge first = sym(hull_[on_hull]);
    Edge outer = first;
    do {
      const Edge next = edges_.lnext(outer);
      edges_.open(outer);
      edges_.number(outer, no_triangle);
      outer = next;
    } while (outer != first);
  }

  const Point& at(Corner c) const { return places_[c].at; }
  static Edge sym(Edge e) { return QuadEdges::sym(e); }

  static constexpr std::size_t min_for_threads = 10000;  // points: one or two milliseconds of work
  std::span<SitePoint> places_;
  QuadEdges edges_;
  meshops::FreshVector<Edge> hull_;  // for an extreme corner, the edge of the hull that leaves it counter-clockwise
  Threads* threads_;
  DivisionSteps steps_;
};

}  // namespace rbpa
