// What: classifies boundary curves of a surface as holes, outer rims, or rims of small islands; finds the islands.
// Law:  the result depends on the points and the triangles only, not on any order. The area that a curve encloses, seen
//       along a direction, is the component of the curve's vector area in that direction. Kinds are right if the areas
//       of components are in the range of double: for sizes from about 1e-150 to 1e150.
// Cost: linear in the edges of the curves and the components, and a sort of the curves.
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

/// The kind of a boundary curve.
enum class CurveKind : std::uint8_t {
  /// The outer end of a sheet. Seen along the mean normal of the component, the curve encloses at least a quarter of
  /// the component's area, and so do all curves of the component together. The boundaries of a square and of half a
  /// sphere are rims; the boundary of a cube without its bottom is a hole, and so are the two ends of a tube.
  rim,
  hole,    ///< any other curve of a component that is not an island
  island,  ///< any boundary curve of an island
};

/// Returns for each component whether it is an island: open, and with less than 1 % of the largest component's area.
/// Requires: `components` are in the order of surface_components(); not checked.
RBPA_API std::vector<bool> islands(const SurfaceComponents& components);

/// A choice of boundary curves; by default all of kind `hole`.
struct HoleChoice {
  std::size_t most_edges = std::numeric_limits<std::size_t>::max();  ///< maximum number of edges of a curve
  double most_length = std::numeric_limits<double>::infinity();      ///< maximum length, in units of the points
  bool rims = false;  ///< whether curves of every kind are chosen, not only holes

  /// Returns whether the choice includes `curve`, whose kind is `kind`.
  bool has(const Hole& curve, CurveKind kind) const {
    return (rims || kind == CurveKind::hole) && curve.edges.size() <= most_edges && curve.length <= most_length;
  }
};

/// Returns the curves that `choice` chooses, in the order of `curves`.
/// Requires: `kinds` are the curve_kinds() of `curves`.
/// Throws:   ContractViolation when there are fewer or more kinds than curves.
RBPA_API std::vector<Hole> chosen_curves(std::span<const Hole> curves, std::span<const CurveKind> kinds,
                                         const HoleChoice& choice = {});

/// Returns the kind of each curve.
/// Requires: `curves` are all holes() or surface_curves() of a surface of `points`, and `components` its components.
/// Throws:   ContractViolation when a curve has no edge, or an edge has a point, triangle or component that does not
///           exist. Missing curves are not noticed; other curves may then get the wrong kind.
RBPA_API std::vector<CurveKind> curve_kinds(std::span<const Point3> points, const SurfaceComponents& components,
                                            std::span<const Hole> curves);

}  // namespace rbpa
