// What: the data of a Partial.
// Law:  the data have a canonical form: components are numbered by their first shared triangle, groups by their first
//       component. Only rings and polygons are in no particular order; both are sorted when bytes are written.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "rbpa/plane/partial.h"
#include "rbpa/plane/partial/cover.h"
#include "rbpa/plane/shape/measure.h"

namespace rbpa {

/// A triangle with corners both in merged regions and in others.
struct SharedTriangle {
  std::array<std::uint64_t, 3> corners;  // counter-clockwise, the smallest index first
  std::uint32_t component;
  std::uint32_t owned;  // number of the corners in merged regions
};

/// A path of boundary edges, triangles on the left. All its points are in merged regions, except the first and the
/// last. Its first edge is the last edge of another chain, and its last edge the first edge of another.
struct Chain {
  std::uint32_t component;
  std::vector<Corner> path;
};

/// The sums of holes that were removed from a component.
struct HoleSums {
  std::uint64_t holes = 0;
  std::vector<ComponentName> names = {};  // ascending, none twice
  BoundaryMeasure measure = {};
};

/// A solid component that has a shared triangle, and is not complete, as regions are missing.
struct OpenComponent {
  /// Number of the group: components that are connected through points are in one group.
  std::uint32_t group = 0;
  std::uint64_t points = 0;  // input points of the component, without those at undecided pinches
  /// The lexicographically least point of the component's chains and rings; (∞, ∞) if there are none.
  Point least = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  std::vector<CornerRing> rings = {};
  std::vector<HoleSums> taken = {};  // empty, or one element; a vector, as a sum is large
};

/// A set of points at which the same components touch. The points count in the component whose polygon comes first.
struct Pinch {
  /// The components that may come first, ascending: numbers of open components, then, after the last of these numbers,
  /// of held polygons.
  std::vector<std::uint32_t> members;
  std::uint64_t points;
};

struct PartialState {
  double alpha = 0;  // 0: the state of no region
  Cover cover = {};
  PartialCounts counts = {};
  std::vector<SharedTriangle> shared = {};  // by corners
  std::vector<OpenComponent> open = {};
  std::vector<Chain> chains = {};            // by first edge
  std::vector<Pinch> pinches = {};           // sorted by members
  std::vector<CornerPolygon> held = {};      // finished, but at pinches whose first polygon is unknown; in order
  std::vector<CornerPolygon> polygons = {};  // finished, in any order
};

/// The counts of a partial result, in the order of to_bytes().
inline constexpr std::array<std::uint64_t PartialCounts::*, 9> partial_counts = {
    &PartialCounts::points,           &PartialCounts::duplicates, &PartialCounts::isolated,
    &PartialCounts::vertices,         &PartialCounts::edges,      &PartialCounts::triangles,
    &PartialCounts::solid_components, &PartialCounts::components, &PartialCounts::boundary_curves};

/// Brings a state into canonical form: components without an open rim become polygons, the rest is numbered. Calls
/// `checkpoint`, if any, repeatedly; `checkpoint` may throw.
/// Requires: shared triangles sorted by corners, none twice; chains that do not join; components and groups in any
///           numbering; the members of pinches after the components are numbers of held polygons.
/// Throws:   InvalidInput when a component without shared triangles has a chain, or no counter-clockwise ring.
/// Cost:     n log n in the open rims.
void settle(PartialState& state, const Checkpoint& checkpoint = {});

/// Checks whether the values, orders and numbers of a state that was read are as to_bytes() writes them.
/// Throws: InvalidInput that names the broken rule, for example a wrong order or coordinates that are not finite.
/// Cost:   linear, and n log n in the corners of the cover.
void check_state(const PartialState& state);

}  // namespace rbpa
