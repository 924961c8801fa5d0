// What: what a region of the plane contributes to a solid alpha complex, so that the whole is the sum of its regions: counts,
//       polygons that are finished, and the rim, which depends on regions that are not merged yet.
// Law:  partial() is a function of the points of the region and its halo, and of alpha. merge() is associative and
//       commutative: bytes (bytes.h) depend on which regions were merged, not on the order. When the whole plane is merged,
//       finish() returns what rbpa(), count() and polygons() compute of all points.
// Cost: that of triangulate(); merging is n log n in the rims. Only the rims, and polygons not yet removed, are kept.
// Source: docs/partial.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/progress.h"
#include "rbpa/corner_polygon.h"
#include "rbpa/region.h"

namespace rbpa {

/// Counts of the merged regions. The items that regions own add up; components and curves count once they are finished.
struct PartialCounts {
  std::uint64_t points = 0;      ///< of the input, duplicates included
  std::uint64_t duplicates = 0;  ///< equal to one of a lower index
  std::uint64_t isolated = 0;    ///< distinct points in no triangle
  std::uint64_t vertices = 0;    ///< distinct points in triangles
  std::uint64_t edges = 0;
  std::uint64_t triangles = 0;
  std::uint64_t solid_components = 0;
  std::uint64_t components = 0;  ///< pinches connect
  std::uint64_t boundary_curves = 0;
  friend bool operator==(const PartialCounts&, const PartialCounts&) = default;

  /// Of the whole plane.
  std::uint64_t holes() const { return components + edges - vertices - triangles; }
};

/// The size of the unfinished part.
struct RimSize {
  std::uint64_t triangles = 0;   ///< with corners in regions that are merged and in others
  std::uint64_t components = 0;  ///< solid components with such triangles
  std::uint64_t chains = 0;      ///< paths of boundary edges that go on in other regions
  std::uint64_t corners = 0;     ///< of chains, and of rings whose component is open
  std::uint64_t polygons = 0;    ///< finished, and not removed
  friend bool operator==(const RimSize&, const RimSize&) = default;
};

struct PartialState;

class RBPA_API Partial {
 public:
  /// Of no region: the neutral element of merge().
  Partial();
  Partial(const Partial&);
  Partial(Partial&&) noexcept;
  Partial& operator=(const Partial&);
  Partial& operator=(Partial&&) noexcept;
  ~Partial();

  /// 0 of no region.
  double alpha() const;
  PartialCounts counts() const;
  RimSize rim() const;
  /// Whether all of the plane is merged.
  bool is_whole() const;

  // For the functions in plane/partial/.
  explicit Partial(PartialState&& state);
  const PartialState& state() const { return *state_; }
  PartialState& state() { return *state_; }

 private:
  std::unique_ptr<PartialState> state_;  // never null but in what was moved from
};

struct PartialOptions {
  /// As TriangulationOptions has them.
  unsigned threads = 0;
  std::function<bool(const Progress&)> progress = {};
};

/// Throws: InvalidInput when alpha is not a finite radius above 0, when the region's bounds are not in ascending order, when
///         a point is not finite or there are too many (triangulate.h), when indices are not as many as points or one is
///         given twice; Cancelled.
/// Cost:   that of triangulate() with neighbors, on all points given.
RBPA_API Partial partial(const Region& region, const RegionPoints& points, double alpha,
                         const PartialOptions& options = {});

/// The items that a region owns.
struct OwnedItems {
  /// By indices into the whole input: counter-clockwise, the smallest index first, in lexicographic order. Those of all
  /// regions together, sorted, are the result of triangulate().
  std::vector<std::array<std::uint64_t, 3>> triangles;
  std::vector<std::uint64_t> isolated;  ///< distinct points in no triangle, ascending
};

struct PartialAndItems {
  Partial partial;
  OwnedItems owned;
};

/// Both at the cost of one.
RBPA_API PartialAndItems partial_and_items(const Region& region, const RegionPoints& points, double alpha,
                                           const PartialOptions& options = {});

/// Two sets of regions as one.
/// Throws: InvalidInput when alphas differ, when a part of the plane is in both, or when they contradict each other about a
///         common triangle: a halo was not complete, or points differed. Then neither can be used any further.
/// Cost:   n log n in the rims; an amortized constant for polygons.
RBPA_API Partial merge(Partial&& a, Partial&& b);

/// Removes the finished polygons from `partial` and returns them in order; counts stay. A polygon that touches an
/// unfinished one is finished once it is certain which of them counts the common points.
RBPA_API std::vector<CornerPolygon> take_settled(Partial& partial);

struct TakenHoles {
  ComponentName component;        ///< holes of one polygon may come under several names, and several times under one
  std::vector<CornerRing> holes;  ///< in order
};

/// Removes the holes of unfinished components from `partial` and returns them by component: a component that spans the
/// plane may have more holes than fit into memory. A component whose holes have fewer than `min_corners` corners together
/// keeps them, because the record that replaces them takes the memory of about 100 corners.
RBPA_API std::vector<TakenHoles> take_holes(Partial& partial, std::size_t min_corners = 0);

struct WholeComplex {
  PartialCounts counts;
  std::vector<CornerPolygon> polygons;  ///< in order, those not removed
};

/// Throws: InvalidInput that names what is missing, unless all of the plane is merged and nothing is open.
RBPA_API WholeComplex finish(Partial&& partial);

}  // namespace rbpa
