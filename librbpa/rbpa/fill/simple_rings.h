// What:   rings that meet in single points at most, and do not cross there: whether they are so, and which lies in which.
// How:    a sweep from left to right, exactly decided (Shamos and Hoey): the first place at which two edges meet is one at
//         which they are neighbors on the line that sweeps. Where rings share a point, the order of their edges around it.
// Cost:   n log n in the edges.
// Source: Shamos, Hoey, Geometric intersection problems (1976).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/shape.h"

namespace rbpa {

/// A ring among others.
struct RingPlace {
  bool is_counter_clockwise = false;
  std::optional<std::size_t> inside = std::nullopt;  ///< of the smallest other ring around it
  std::size_t depth = 0;                             ///< how many are around it
  bool is_hole() const { return depth % 2 != 0; }    ///< what is inside is not part of the polygons
};

/// "(1.5, 2)"
std::string place_of(const Point& p);

/// What a ring is called in messages: "hole 2 of polygon 0".
using RingName = std::function<std::string(std::size_t)>;

/// Two edges of rings that meet where they must not. Of a vertex it is the edge that begins there.
struct RingsMeet {
  enum class How {
    edges_cross,
    edges_overlap,     ///< along more than a point
    vertex_on_edge,    ///< the first on the second
    one_place,         ///< a ring passes a place twice, or two points lie at one place
    cross_at_a_point,  ///< that both rings have for a vertex
  };
  struct Side {
    std::size_t ring, edge;  ///< from that vertex of the ring to the next
  };
  How how;
  Side first, second;
};

/// Which ring lies in which; or where two meet.
/// Rings may have a point in common, by its index, if they do not cross there. No two points may lie at one place.
/// Requires: as check_points(), but for edges that meet.
struct NestedRings {
  std::vector<RingPlace> place = {};
  std::optional<RingsMeet> meet = std::nullopt;
};
NestedRings nest_rings(std::span<const Point> points, std::span<const Ring> rings,
                       const std::function<bool()>& go_on = {});

/// Throws: InvalidInput when a ring has fewer than three points, names one that there is not, or one that is not finite, or
///         has no area.
void check_points(std::span<const Point> points, std::span<const Ring> rings, const RingName& name);

}  // namespace rbpa
