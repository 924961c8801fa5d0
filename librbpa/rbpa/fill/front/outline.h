// What: the boundary of the polygons to be filled, in an order that does not depend on how the input is written.
// Law:  a function of the polygons as a set of the plane, except for the numbers of input points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/patch/site.h"
#include "rbpa/base/point.h"
#include "rbpa/fill/front/size_field.h"
#include "rbpa/fill/rings/simple_rings.h"

namespace rbpa {

struct OutlineRing {
  std::vector<meshops::Site> sites;  ///< the polygon is on the left; the least of the corners first
  std::size_t input = 0;             ///< number of the input ring
  bool is_reversed = false;          ///< whether the direction is opposite to the input's
  std::size_t group = 0;             ///< group of polygons that form a valid multipolygon (fill.h)
};

struct Outline {
  /// The place of each site: corners in lexicographic order, then points that were added on edges.
  std::vector<Point> places;
  std::vector<std::uint32_t> input;  ///< for each corner, the index of its input point
  std::vector<OutlineRing> rings;    ///< sorted by their first sites
};

/// Returns the outline of rings. `places` are the positions of the rings among each other, `groups` their groups.
/// Requires: noded rings; rings of one group meet in single points at most; places[r] is the place of ring r that
///           nest_rings() finds among the rings of its group.
Outline outline_of(std::span<const Point> points, std::span<const Ring> rings, std::span<const RingPlace> places,
                   std::span<const std::size_t> groups);

/// Cuts edges into pieces that are not much longer than the size field allows: an edge is cut into as many pieces as
/// the integral of 1 / size along the edge, rounded to a whole number. Added points are rounded to doubles. An edge
/// stays whole if its pieces would be too short for doubles, or would meet other edges of the same group. An edge that
/// several rings have, in either direction, is cut once for all of them.
/// Throws: Cancelled.
/// Cost:   n log n in the pieces.
void cut(Outline& outline, const SizeField& field, const GoOn& go_on);

/// The part of an outline that belongs to one group, as an outline of its own.
struct OutlinePart {
  Outline outline;
  std::vector<meshops::Site> site;  ///< for each site of the part, its site in the whole outline; ascending
  std::size_t group;
};

/// Returns one part for each group, ascending by group. Cost: n log n.
std::vector<OutlinePart> parts_of(const Outline& outline);

}  // namespace rbpa
