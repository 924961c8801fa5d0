// What: the boundary of the polygons to be filled, in an order that does not depend on the representation of the input.
// Law:  the outline depends on the polygons as point sets alone, except for the numbers of input points and rings.
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
  std::vector<meshops::Site> sites;  ///< corners with the polygon on the left, the least site first
  std::size_t input = 0;             ///< number of the input ring
  bool is_reversed = false;          ///< whether the input ring has the opposite direction
  std::size_t group = 0;             ///< number of the group of polygons (FillOptions::groups)
};

struct Outline {
  /// The place of each site: corners in lexicographic order, then points that cut() added on edges.
  std::vector<Point> places;
  std::vector<std::uint32_t> input;  ///< for each corner, the index of its input point
  std::vector<OutlineRing> rings;    ///< sorted lexicographically by their sites
};

/// Returns the outline of rings. `groups` has the group of each ring.
/// Requires: noded rings; rings of one group meet in single points at most; places[r] is the result of nest_rings() for
///           ring r among the rings of its group.
Outline outline_of(std::span<const Point> points, std::span<const Ring> rings, std::span<const RingPlace> places,
                   std::span<const std::size_t> groups);

/// Cuts edges into pieces at most about 1.5 times as long as the size field allows: the number of pieces of an edge is
/// the integral of 1 / size along the edge, rounded to an integer. Added points are rounded to doubles. An edge stays
/// whole if its pieces would be too short for doubles; so does each of two edges whose pieces would meet within a
/// group, and the edge before a piece that is the first of its edge. All rings that share an edge, in either direction,
/// get its added points.
/// Throws: Cancelled.
/// Cost:   n log n for n pieces, again after each meeting of pieces.
void cut(Outline& outline, const SizeField& field, const GoOn& go_on);

/// The part of an outline that belongs to one group, as an outline of its own.
struct OutlinePart {
  Outline outline;
  std::vector<meshops::Site> site;  ///< for each site of the part, the site in the whole outline; ascending
  std::size_t group;
};

/// Returns one part for each group, ascending by group. Cost: n log n.
std::vector<OutlinePart> parts_of(const Outline& outline);

}  // namespace rbpa
