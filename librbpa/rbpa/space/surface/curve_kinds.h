// What: classifies the boundary curves of a surface as holes, outer rims, or boundaries of small islands, and finds the
//       islands.
// Law:  the result depends on the points and the triangles only, not on any order. The areas below are those of flat
//       caps over the curves, given by the vector area of a curve.
// Cost: linear in the curves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/surface/holes.h"
#include "rbpa/space/surface/surface_components.h"

namespace rbpa {

enum class CurveKind : std::uint8_t {
  /// The end of a sheet: seen along the component's mean normal, the curve encloses at least a quarter of the
  /// component's area. A square has one, and so has half a sphere; a cube without its bottom has none.
  rim,
  hole,    ///< any other curve of a component that is not an island
  island,  ///< a curve of an island
};

/// Returns for each component whether it is an island: it is open, and its area is less than a hundredth of the largest
/// component's.
RBPA_API std::vector<bool> islands(const SurfaceComponents& components);

/// A choice of boundary curves; by default all of kind `hole`.
struct HoleChoice {
  std::size_t most_edges = std::numeric_limits<std::size_t>::max();
  double most_length = std::numeric_limits<double>::infinity();
  bool rims = false;  ///< true: curves of every kind

  bool has(const Hole& curve, CurveKind kind) const {
    return (rims || kind == CurveKind::hole) && curve.edges.size() <= most_edges && curve.length <= most_length;
  }
};

/// Returns the chosen curves, in their order.
/// Requires: the kind of each curve.
/// Throws:   ContractViolation when there are fewer or more kinds than curves.
RBPA_API std::vector<Hole> chosen_curves(std::span<const Hole> curves, std::span<const CurveKind> kinds,
                                         const HoleChoice& choice = {});

/// Returns the kind of each curve.
/// Requires: the holes() of a surface of these points, and its components.
/// Throws:   ContractViolation when an edge belongs to none of the points or components.
RBPA_API std::vector<CurveKind> curve_kinds(std::span<const Point3> points, const SurfaceComponents& components,
                                            std::span<const Hole> curves);

}  // namespace rbpa
