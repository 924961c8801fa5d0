// What:   computes the contribution of a region of the plane to a solid alpha complex: counts, finished polygons, and
//         the rim, which depends on regions not merged yet; and merges the contributions of all regions to the whole.
// Law:    partial() is a function of the points of the region and its halo, and of alpha. merge() is associative and
//         commutative: unless polygons or holes were removed, bytes (partial_bytes.h) depend on which regions were
//         merged, not on the order. When the whole plane is merged, finish() returns the numbers of rbpa() and count()
//         and the polygons of outline_polygons() for all points.
// Cost:   that of alpha_complex(); merging is n log n in the rims. Only the rims and the polygons not yet removed are
//         kept in memory.
// Source: docs/explanation/plane.md, sections 18 to 22.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/progress.h"
#include "rbpa/plane/corner_polygon.h"
#include "rbpa/plane/region.h"

namespace rbpa {

/// Counts over the merged regions. A point, edge or triangle counts in the region that owns it; a component or boundary
/// curve counts when all regions that have a part of it are merged.
struct PartialCounts {
  std::uint64_t points = 0;      ///< input points, duplicates included
  std::uint64_t duplicates = 0;  ///< points equal to one of a lower index
  std::uint64_t isolated = 0;    ///< distinct points in no triangle
  std::uint64_t vertices = 0;    ///< distinct points in triangles
  std::uint64_t edges = 0;       ///< edges of triangles
  std::uint64_t triangles = 0;
  std::uint64_t solid_components = 0;  ///< components connected through edges
  std::uint64_t components = 0;        ///< components connected through points: pinches connect
  std::uint64_t boundary_curves = 0;
  friend bool operator==(const PartialCounts&, const PartialCounts&) = default;

  /// Returns the number of holes. Requires: counts of the whole plane; not checked.
  std::uint64_t holes() const { return components + edges - vertices - triangles; }
};

/// The size of the part of a Partial that depends on regions not merged yet.
struct RimSize {
  std::uint64_t triangles = 0;   ///< triangles with corners both in merged regions and in others
  std::uint64_t components = 0;  ///< solid components that have triangles of this kind
  std::uint64_t chains = 0;      ///< paths of boundary edges that continue in other regions
  std::uint64_t corners = 0;     ///< corners of chains, and of rings whose component is unfinished
  std::uint64_t polygons = 0;    ///< finished polygons that are not removed yet
  friend bool operator==(const RimSize&, const RimSize&) = default;
};

struct PartialState;

/// The contribution of a set of disjoint regions to a solid alpha complex. An object that was moved from may only be
/// assigned to or destroyed.
class RBPA_API Partial {
 public:
  /// Constructs the contribution of no region: the neutral element of merge().
  Partial();
  Partial(const Partial&);
  Partial(Partial&&) noexcept;
  Partial& operator=(const Partial&);
  Partial& operator=(Partial&&) noexcept;
  ~Partial();

  /// Returns alpha; 0 for the contribution of no region.
  double alpha() const;
  PartialCounts counts() const;
  RimSize rim() const;
  /// Returns whether all of the plane is merged.
  bool is_whole() const;

  // For the functions in plane/partial/.
  explicit Partial(PartialState&& state);
  const PartialState& state() const { return *state_; }
  PartialState& state() { return *state_; }

 private:
  std::unique_ptr<PartialState> state_;  // null only after a move
};

struct PartialOptions {
  MaxThreads threads = 0;    ///< maximum number; 0: all processors
  OnProgress progress = {};  ///< callback for progress and cancellation
};

/// Computes the contribution of a region. If the region is empty, all counts are 0.
/// Requires: `points` has every input point in halo(region, alpha); missing points are noticed only by merge() or
///           finish(), and only where they lead to a contradiction.
/// Throws:   InvalidInput when alpha is not a finite radius above 0, when the region's bounds are not in ascending
///           order, when a point is not finite or there are too many (alpha_complex.h), when the number of indices
///           differs from that of points or an index is given twice; Cancelled.
/// Cost:     that of alpha_complex() with neighbors, on all given points.
RBPA_API Partial partial(const Region& region, const RegionPoints& points, double alpha,
                         const PartialOptions& options = {});

/// The items that a region owns.
struct OwnedItems {
  /// Triangles as indices into the whole input: counter-clockwise, the smallest index first, in lexicographic order.
  /// The triangles of all regions together, sorted, are the result of alpha_complex().
  std::vector<std::array<std::uint64_t, 3>> triangles;
  std::vector<std::uint64_t> isolated;  ///< distinct points in no triangle, ascending
};

/// The contribution of a region, and the items that the region owns.
struct PartialAndItems {
  Partial partial;
  OwnedItems owned;
};

/// Computes the contribution of a region and the items that it owns, from one triangulation.
/// Requires: as partial().
/// Throws:   as partial().
/// Cost:     that of partial().
RBPA_API PartialAndItems partial_and_items(const Region& region, const RegionPoints& points, double alpha,
                                           const PartialOptions& options = {});

/// Merges two sets of regions into one.
/// Throws: InvalidInput when both arguments have regions and their alphas differ, when a part of the plane is in both
///         arguments, or when the arguments contradict each other about a common triangle or boundary edge, because a
///         halo was not complete or points differed. After an exception, neither argument may be used.
/// Cost:   n log n in the rims; an amortized constant for polygons.
RBPA_API Partial merge(Partial&& a, Partial&& b);

/// Removes the finished polygons from `partial` and returns them, sorted by comes_before(); counts do not change. A
/// polygon that touches an unfinished component at a point stays until it is certain whether this point counts in the
/// polygon. Cost: a sort of the polygons.
RBPA_API std::vector<CornerPolygon> take_settled(Partial& partial);

/// Holes that were removed from one component.
struct TakenHoles {
  /// The name of the component. take_holes() may return holes of one polygon under several names, and several times
  /// under one name.
  ComponentName component;
  std::vector<CornerRing> holes;  ///< clockwise; sorted by first point, then by second, both lexicographically
};

/// Removes the complete holes of unfinished components from `partial`, and returns them, sorted by component. A
/// component that spans the plane may have more holes than fit into memory. If the complete holes of a component have
/// fewer than `min_corners` corners together, the component keeps them: the record that replaces holes takes the memory
/// of about 100 corners. CornerPolygon::names tells which holes belong to a polygon. Cost: a sort of the
/// holes, and a pass over their corners and the shared triangles.
RBPA_API std::vector<TakenHoles> take_holes(Partial& partial, std::size_t min_corners = 0);

/// The counts and polygons of the complex of the whole plane.
struct WholeComplex {
  PartialCounts counts;
  std::vector<CornerPolygon> polygons;  ///< sorted by comes_before(); without those that take_settled() removed
};

/// Returns the complex of the whole plane.
/// Throws: InvalidInput that names a missing part of the plane, or a triangle that is missing in a region that contains
///         one of its corners.
/// Cost:   a sort of the polygons.
RBPA_API WholeComplex finish(Partial&& partial);

}  // namespace rbpa
