// What:   rings that pass no place twice and do not meet: whether they are so, and which lies in which.
// How:    a sweep from left to right, exactly decided (Shamos and Hoey): the first place at which two edges meet is one at
//         which they are neighbours on the line that sweeps.
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

#include "rbpa/core/point.h"
#include "rbpa/shape/polygons.h"

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

/// Two edges of rings that meet, of which one may be no more than a point: what InvalidInput says, and where.
struct RingsMeet {
  std::string why;
  struct Side {
    std::size_t ring, edge;  ///< from that vertex of the ring to the next
  };
  Side first, second;
};

/// Which ring lies in which; or where two meet: the same whatever the order of rings.
/// Requires: as below, but for edges that meet.
struct NestedRings {
  std::vector<RingPlace> place = {};
  std::optional<RingsMeet> meet = std::nullopt;
};
NestedRings nest_rings(std::span<const Point> points, std::span<const Ring> rings, const RingName& name,
                       const std::function<bool()>& go_on = {});

/// Throws: InvalidInput when a ring has fewer than three points, names one that there is not, or one that is not finite.
void check_points(std::span<const Point> points, std::span<const Ring> rings, const RingName& name);

}  // namespace rbpa
