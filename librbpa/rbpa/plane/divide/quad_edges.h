// What:   a plane graph as the quad-edge structure without its dual: directed edges, each with its neighbors around its
//         origin (Onext, Oprev), 32 bits a number.
// Law:    e and sym(e) are one edge in both directions; following onext() leads around a point counter-clockwise, back
//         to the first edge.
// Cost:   12 bytes a directed edge; deleted edges are reused, the last deleted first.
// Source: Guibas, Stolfi, Primitives for the manipulation of general subdivisions (1985): Org, Dest, Sym, Onext, …
#pragma once

#include <cstddef>
#include <cstdint>

#include "meshops/core/fresh_vector.h"

namespace rbpa {

class QuadEdges {
 public:
  using Edge = std::uint32_t;
  using Corner = std::uint32_t;

  /// A list of unused edges. No edge is in two lists: threads with a list each may add and remove edges concurrently.
  struct Unused {
    Edge first, last;
  };

  /// Reserves memory for the edges of a triangulation of `points` points.
  explicit QuadEdges(std::size_t points) : edges_(6 * points) {}

  /// Returns the unused edges for a triangulation of the points `first` to `last` − 1; no two calls share a point.
  /// Requires: at least one point.
  Unused unused_for(std::size_t first, std::size_t last) {
    const Unused all = {static_cast<Edge>(6 * first), static_cast<Edge>(6 * last - 2)};
    for (Edge e = all.first; e <= all.last; e += 2) put_away(e, e + 2);
    return all;
  }
  Unused joined(const Unused& a, const Unused& b) {
    edges_[a.last].onext = b.first;
    return {a.first, b.last};
  }

  /// Returns one more than the greatest edge number. Directed edges are numbered from 0; unused edges have the lnext()
  /// 0.
  std::size_t size() const { return edges_.size(); }

  static Edge sym(Edge e) { return e ^ 1; }
  Corner org(Edge e) const { return edges_[e].org; }
  Corner dest(Edge e) const { return edges_[sym(e)].org; }
  /// Returns the next edge with the same origin: onext() counter-clockwise, oprev() clockwise.
  Edge onext(Edge e) const { return edges_[e].onext; }
  Edge oprev(Edge e) const { return edges_[e].oprev; }
  /// Returns the next edge along the left face, or the edge before along the right face; both leave the point dest(e).
  Edge lnext(Edge e) const { return oprev(sym(e)); }
  Edge rprev(Edge e) const { return onext(sym(e)); }

  /// Adds an edge that touches no other.
  Edge make_edge(Corner org, Corner dest, Unused& unused) {
    const Edge e = unused.first;
    unused.first = edges_[e].onext;
    edges_[e] = {org, e, e};
    edges_[sym(e)] = {dest, sym(e), sym(e)};
    return e;
  }

  /// Adds an edge from the origin of `a` to that of `b`. The new edge becomes the next one counter-clockwise after `a`
  /// and after `b`.
  Edge connect(Edge a, Edge b, Unused& unused) {
    const Edge e = unused.first, back = sym(e);
    unused.first = edges_[e].onext;
    const Edge a_next = onext(a), b_next = onext(b);
    edges_[e] = {org(a), a_next, a};
    edges_[back] = {org(b), b_next, b};
    edges_[a].onext = edges_[a_next].oprev = e;
    edges_[b].onext = edges_[b_next].oprev = back;
    return e;
  }

  /// Inserts edge `e`, which is alone at its origin, as the next edge counter-clockwise after the edge `after`.
  void insert(Edge e, Edge after) {
    const Edge before = onext(after);
    edges_[e].oprev = after;
    edges_[e].onext = before;
    edges_[after].onext = e;
    edges_[before].oprev = e;
  }

  /// Removes the left face of `e`: lnext(e) is then 0.
  void open(Edge e) { edges_[sym(e)].oprev = 0; }

  /// Stores a number in the place of onext(e), which is lost.
  void number(Edge e, int n) { edges_[e].onext = static_cast<Edge>(n); }
  int number(Edge e) const { return static_cast<int>(edges_[e].onext); }

  void remove(Edge e, Unused& unused) {
    unlink(e);
    unlink(sym(e));
    e &= ~Edge{1};
    put_away(e, unused.first);
    unused.first = e;
  }

 private:
  struct Links {
    Corner org;
    Edge onext, oprev;
  };
  void unlink(Edge e) {
    edges_[onext(e)].oprev = oprev(e);
    edges_[oprev(e)].onext = onext(e);
  }
  void put_away(Edge e, Edge next) {
    edges_[e].onext = next;
    edges_[e].oprev = edges_[sym(e)].oprev = 0;
  }

  meshops::FreshVector<Links> edges_;
};

}  // namespace rbpa
