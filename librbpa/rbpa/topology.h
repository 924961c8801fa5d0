// What: the counts of a solid alpha complex as a topological space.
// Law:  components − holes = points − edges + triangles (the Euler characteristic; in the plane b₂ = 0).
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/triangulate.h"

namespace rbpa {

struct SolidAlphaComplex;  // rbpa/complex.h

/// Components are counted in two ways: solid ones are connected through edges, and are the components of the mesh; those of
/// the space are connected through pinches as well.
struct ComplexCounts {
  std::size_t points_covered = 0;  ///< distinct input points in triangles: the vertices of the space
  std::size_t edges = 0;
  std::size_t triangles = 0;
  std::size_t boundary_curves = 0;  ///< of the mesh: a curve does not pass through a pinch
  std::size_t solid_components = 0;
  std::size_t components = 0;
  std::size_t holes = 0;
  friend bool operator==(const ComplexCounts&, const ComplexCounts&) = default;
};

/// Cost: about linear.
RBPA_API ComplexCounts count(const SolidAlphaComplex& complex);

/// The same of arrays: by their boundary where it is there, else by the neighbors. Nothing else is looked at, since in the plane
/// curves around components run left and curves around holes right. So `.boundary` alone costs least.
/// Of a full complex, edges in no triangle are counted as well; the points covered are those in a triangle or an edge, every
/// other distinct point is a component, and components − holes = distinct points − edges + triangles.
/// Requires: triangles that lie side by side, on these points.
/// Throws:   ContractViolation when their sides are visibly the boundary of nothing; Cancelled when `go_on`, which is called every few
///           milliseconds, returns false. Empty: never called.
/// Cost:     that of sorting the boundary; by neighbors, linear in the triangles.
RBPA_API ComplexCounts count(std::span<const Point> points, const Triangulation& complex, Complex kind = Complex::solid,
                             const std::function<bool()>& go_on = {});

}  // namespace rbpa
