// What:   tests whether rings meet in single points at most and do not cross there, and finds which ring lies in which.
// How:    a sweep from left to right, decided exactly (Shamos and Hoey): the first place at which two edges meet is one
//         at which they are neighbors on the sweep line. Where rings share a point, the order of their edges around it
//         decides.
// Cost:   n log n in the edges.
// Source: Shamos, Hoey, Geometric intersection problems (1976).
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/base/progress.h"
#include "rbpa/plane/outline_polygons.h"

namespace rbpa {

/// The position of a ring among others.
struct RingPlace {
  bool is_counter_clockwise = false;
  std::optional<std::size_t> inside = std::nullopt;  ///< number of the smallest other ring around it
  std::size_t depth = 0;                             ///< number of rings around it
  bool is_hole() const { return depth % 2 != 0; }    ///< whether the ring bounds a hole
};

/// Returns the text of a place: "(1.5, 2)".
std::string place_of(const Point& p);

/// The name of a ring in messages: "hole 2 of polygon 0".
using RingName = std::function<std::string(std::size_t)>;

/// Two edges of rings that meet where they must not. A vertex is represented by the edge that begins there.
struct RingsMeet {
  enum class How {
    edges_cross,
    edges_overlap,     ///< the edges have more than one point in common
    vertex_on_edge,    ///< the vertex `first` lies on the edge `second`
    one_place,         ///< a ring passes a place twice, or two points lie at one place
    cross_at_a_point,  ///< the rings cross at a point that is a vertex of both
  };
  struct Side {
    std::size_t ring, edge;  ///< the edge from this vertex of the ring to the next one
  };
  How how;
  Side first, second;
};

/// The result of nest_rings(): the position of each ring; or two edges that meet, and then `place` is unspecified.
struct NestedRings {
  std::vector<RingPlace> place = {};
  std::optional<RingsMeet> meet = std::nullopt;
};
/// Returns the position of each ring among the others, or two edges that meet where they must not. Rings may pass the
/// same point (one index) if they do not cross there; two points at one place count as meeting.
/// Requires: as check_points(); a ring without an area is allowed, as its edges meet.
/// Throws:   Cancelled.
NestedRings nest_rings(std::span<const Point> points, std::span<const Ring> rings, const GoOn& go_on = {});

/// Checks the points of each ring; name(r) is the name of ring r in messages.
/// Throws: InvalidInput when a ring has fewer than three points, names one that does not exist or is not finite, or has
///         no area. Cancelled.
void check_points(std::span<const Point> points, std::span<const Ring> rings, const RingName& name,
                  const GoOn& go_on = {});

}  // namespace rbpa
