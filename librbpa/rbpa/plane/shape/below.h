// What: the order of the edges that a vertical line crosses as it sweeps over a boundary, decided exactly.
#pragma once

#include "rbpa/base/point.h"
#include "rbpa/plane/predicate/predicates.h"

namespace rbpa {

/// An edge of a boundary, its lexicographically lower end first.
struct SweptEdge {
  Point low, high;
};

/// Orders edges from low to high, among those that cross the sweep line between two events of the sweep. Edges meet
/// only in common ends, so no orientation is zero. A point on no edge has a place in this order.
struct Below {
  using is_transparent = void;
  bool operator()(const SweptEdge* edge, const Point& p) const { return side(*edge, p) > 0; }
  bool operator()(const Point& p, const SweptEdge* edge) const { return side(*edge, p) < 0; }
  bool operator()(const SweptEdge* a, const SweptEdge* b) const {
    if (a == b) return false;
    if (a->low == b->low) return side(*a, b->high) > 0;
    return a->low < b->low ? side(*a, b->low) > 0 : side(*b, a->low) < 0;
  }

 private:
  static int side(const SweptEdge& edge, const Point& p) {
    return Predicates<long double>::orientation(edge.low, edge.high, p);
  }
};

}  // namespace rbpa
