// What: computes the alpha complex of points in the plane as plain arrays of indices, in canonical order.
// Law:  the triangles equal those of rbpa() (rbpa.h), indices included; the result does not depend on threads or
//       compiler.
// Cost: less than that of rbpa(), as no mesh is made: docs/reference/performance.md.
// Note: independent of OpenMesh.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/complex_kind.h"
#include "rbpa/base/duplicate.h"
#include "rbpa/base/point.h"
#include "rbpa/base/progress.h"
#include "rbpa/base/triangle_arrays.h"

namespace rbpa {

struct AlphaComplexOptions {
  ComplexKind complex = ComplexKind::solid;
  bool neighbors = false;    ///< whether AlphaComplex::neighbors is filled in
  bool boundary = false;     ///< whether AlphaComplex::boundary is filled in
  MaxThreads threads = 0;    ///< maximum number; 0: all processors
  OnProgress progress = {};  ///< callback for progress and cancellation
};

/// An alpha complex as arrays. Points are input indices from 0; of equal points only the lowest index occurs, except in
/// `duplicates`.
struct AlphaComplex {
  /// The entry of `neighbors` across from a corner where there is no triangle.
  static constexpr std::uint32_t none = TriangleArrays::none;

  /// The triangles, counter-clockwise, the smallest index first, in lexicographic order.
  std::vector<Triangle> triangles;
  /// Only on request: for each triangle, entry k is the number of the triangle across from its corner k, or none.
  std::vector<Triangle> neighbors;
  /// Only on request: the boundary, that is the sides that only one triangle has, each with the triangle on its left,
  /// in lexicographic order.
  std::vector<std::array<std::uint32_t, 2>> boundary;
  std::vector<std::uint32_t> isolated;  ///< distinct points in no triangle, ascending
  std::vector<Duplicate> duplicates;    ///< ascending by index
  std::size_t distinct = 0;             ///< number of distinct points

  // In a full complex only:
  /// Edges in no triangle, the smaller index first, in lexicographic order: Delaunay edges of length ≤ 2 alpha with no
  /// point inside their diametral circle. If all points are on one line, Delaunay edges join neighbors on the line.
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::uint32_t> points;  ///< distinct points in neither a triangle nor an edge, ascending

  /// Converts to a view, valid as long as this object is unchanged; the view has no neighbors if `neighbors` is empty.
  operator TriangleArrays() const { return {triangles, neighbors}; }
};

/// Computes the alpha complex of `points`, solid or full as in the options. Triangles have a circumradius of at most
/// alpha, which is a radius in the unit of the points, not its square.
/// Requires: 0 < alpha ≤ infinity; finite points, at most 357,913,941 of them.
/// Throws:   InvalidInput that names alpha, the number of points or the first point that is not finite, before anything
///           is computed; Cancelled.
/// Cost:     about linear where the density varies little, n log n at worst. Memory beyond the input, including that of
///           the result: 60 to 80 bytes a point, with neighbors 100 to 115 (docs/reference/performance.md, section 3);
///           the full complex needs as much as the Delaunay triangulation with neighbors.
RBPA_API AlphaComplex alpha_complex(std::span<const Point> points, double alpha,
                                    const AlphaComplexOptions& options = {});

}  // namespace rbpa
