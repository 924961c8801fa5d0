// What:   tests whether rings meet in single points at most and do not cross there, and finds the nesting of the rings.
// How:    a sweep from left to right with exact decisions (Shamos and Hoey) tests edges that become neighbors on the
//         sweep line: of all edges that meet, some meet while they are neighbors. At a point that rings share, the
//         order of their edges around the point decides.
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
  std::optional<std::size_t> inside = std::nullopt;  ///< number of the smallest ring around this ring
  std::size_t depth = 0;                             ///< number of rings around this ring
  bool is_hole() const { return depth % 2 != 0; }    ///< whether the ring bounds a hole
};

/// A function that returns the name of a ring, given by its number, for messages: "hole 2 of polygon 0".
using RingName = std::function<std::string(std::size_t)>;

/// Two edges of rings that meet in a way that is not allowed. The edge that begins at a vertex stands for the vertex.
struct RingsMeet {
  enum class How {
    edges_cross,
    edges_overlap,     ///< the edges have more than one point in common
    vertex_on_edge,    ///< the vertex `first` lies on the edge `second`
    one_place,         ///< a ring contains a point twice, or two points have equal coordinates
    cross_at_a_point,  ///< the rings cross at a point that is a vertex of both
  };
  struct Side {
    std::size_t ring, edge;  ///< number of a ring, and of its edge from vertex `edge` to the next
  };
  How how;
  Side first, second;
};

/// The result of nest_rings(): the position of each ring, or two edges that meet; in this case `place` is unspecified.
struct NestedRings {
  std::vector<RingPlace> place = {};
  std::optional<RingsMeet> meet = std::nullopt;
};
/// Returns the position of each ring among the others, or two edges that meet in a way that is not allowed. Rings may
/// share a point (one index) if they do not cross there; two indices of equal points count as meeting.
/// Requires: check_points() accepts the rings; rings without area, whose edges meet, are allowed as well.
/// Throws:   Cancelled.
NestedRings nest_rings(std::span<const Point> points, std::span<const Ring> rings, const GoOn& go_on = {});

/// Checks the points of each ring; name(r) is the name of ring r in messages.
/// Throws: InvalidInput when a ring has fewer than three points, an index that does not exist, a coordinate that is not
///         finite, or all points on one line. Cancelled.
void check_points(std::span<const Point> points, std::span<const Ring> rings, const RingName& name,
                  const GoOn& go_on = {});

}  // namespace rbpa
