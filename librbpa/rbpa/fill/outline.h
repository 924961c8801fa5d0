// What:   the boundary of the polygons to be filled, in an order that does not depend on how the input is written.
// Law:    a function of the polygons as a set of the plane, but for the numbers of input points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "meshops/patch/site.h"
#include "rbpa/base/point.h"
#include "rbpa/fill/simple_rings.h"
#include "rbpa/fill/size_field.h"

namespace rbpa {

struct OutlineRing {
  std::vector<meshops::Site> sites;  ///< the polygon is on the left; the least of the corners first
  std::size_t input = 0;             ///< the number of the ring among those of the input
  bool is_reversed = false;          ///< against the input
  std::size_t group = 0;             ///< of the polygons that are a valid multipolygon together (fill.h)
};

struct Outline {
  std::vector<Point> places;         ///< for each site: corners in lexicographic order, then what was put on edges
  std::vector<std::uint32_t> input;  ///< for each corner the input point
  std::vector<OutlineRing> rings;    ///< by their first sites
};

/// Requires: noded rings, of which those of one group meet in single points at most; and the result of nest_rings() for the
///           rings of each group.
Outline outline_of(std::span<const Point> points, std::span<const Ring> rings, std::span<const RingPlace> places,
                   std::span<const std::size_t> groups);

/// Puts points on edges, so that none is much longer than the field has it: an edge along which the field counts n of its
/// lengths is cut into n pieces, n rounded. A point is rounded to doubles; an edge whose pieces would meet others of its
/// group by that stays whole. An edge that several rings have, whichever way it runs, is cut once for all.
/// Throws: Cancelled. Cost: n log n in the pieces.
void cut(Outline& outline, const SizeField& field, const std::function<bool()>& go_on);

/// One group of an outline.
struct OutlinePart {
  Outline outline;
  std::vector<meshops::Site> site;  ///< for each of its sites: that of the whole; ascending
  std::size_t group;
};

/// Those of all groups, ascending. Cost: n log n.
std::vector<OutlinePart> parts_of(const Outline& outline);

}  // namespace rbpa
