// What: which boundary curves of a surface are holes, which its outer rim, and which bound small islands.
// Law:  a function of the points and the triangles, and of no order. The areas below are those of flat caps over the curves: a
//       curve's vector area.
// Cost: linear in the curves.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/holes.h"
#include "rbpa/surface_components.h"

namespace rbpa {

enum class CurveKind : std::uint8_t {
  /// Where a sheet ends: seen along the component's mean normal the curve goes around at least a quarter of the component's
  /// area. A square has one, half a sphere as well; a cube without its bottom does not.
  rim,
  hole,    ///< any other curve of a component that is no island
  island,  ///< a curve of a component whose area is less than a hundredth of the largest component's
};

/// Of each curve.
/// Requires: the holes() of a surface of these points, and its components.
/// Throws:   ContractViolation when an edge is at none of the points or components.
RBPA_API std::vector<CurveKind> curve_kinds(std::span<const Point3> points, const SurfaceComponents& components,
                                            std::span<const Hole> curves);

}  // namespace rbpa
