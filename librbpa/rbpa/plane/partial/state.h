// What: the data of a Partial.
// Law:  in canonical form, except for the order of rings and of polygons, which are sorted when bytes are written:
//       components are numbered by their first shared triangle, groups by their first component.
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
  std::uint32_t owned;  // number of its corners in merged regions
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

/// A solid component that is not complete, as regions are missing: it has a shared triangle.
struct OpenComponent {
  /// Number of the group: components that are connected through points have the same one.
  std::uint32_t group = 0;
  std::uint64_t points = 0;  // input points of the component, without those at undecided pinches
  /// The lexicographically least point of its chains and rings; at infinity if there are none.
  Point least = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  std::vector<CornerRing> rings = {};
  std::vector<HoleSums> taken = {};  // none or one: sums are large
};

/// A set of points at which the same components touch: they count in the component whose polygon comes first.
struct Pinch {
  /// Numbers of open components, and after these of held polygons: those that may come first, ascending.
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
  std::vector<Pinch> pinches = {};           // by members
  std::vector<CornerPolygon> held = {};      // finished, but in pinches whose first polygon is not known yet; in order
  std::vector<CornerPolygon> polygons = {};  // finished
};

}  // namespace rbpa
