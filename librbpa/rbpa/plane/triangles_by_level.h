// What:   computes the solid alpha complex as plain arrays, with the level of each triangle: the first of the radii α₀,
//         2α₀, 4α₀ … alpha that admits the triangle.
// Law:    the triangles are those of alpha_complex(), the levels those of hrbpa() (hrbpa.h).
// Cost:   that of alpha_complex(), plus a quadtree and a comparison of the circumradius for each triangle.
// Source: Medeiros, Velho, Lopes, Restricted BPA, section 6; docs/explanation/plane.md, sections 16 and 17.
// Note:   independent of OpenMesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/base/progress.h"
#include "rbpa/plane/alpha_complex.h"

namespace rbpa {

/// The default of HierarchyOptions::leaf_capacity and of TrianglesByLevelOptions::leaf_capacity: points in a leaf.
inline constexpr std::size_t usual_leaf_capacity = 16384;

struct TrianglesByLevelOptions {
  /// Maximum number of points in a leaf of the quadtree whose smallest leaf determines α₀. At least 1.
  std::size_t leaf_capacity = usual_leaf_capacity;
  bool neighbors = false;    ///< whether AlphaComplex::neighbors is filled in
  bool boundary = false;     ///< whether AlphaComplex::boundary is filled in
  MaxThreads threads = 0;    ///< maximum number; 0: all processors
  OnProgress progress = {};  ///< callback for progress and cancellation
};

/// A level: its radius, and the size of the complex of this radius.
struct ArrayLevel {
  double alpha = 0;  ///< 2^number α₀, or on the last level the alpha of the whole run
  int number = 0;    ///< exponent of the radius; levels between the first and the last without a triangle are left out
  std::size_t triangles = 0;  ///< number of triangles of this level and all levels before
  friend bool operator==(const ArrayLevel&, const ArrayLevel&) = default;
};

/// A solid alpha complex with the level of each triangle.
struct TrianglesByLevel {
  AlphaComplex complex;
  std::vector<std::uint16_t> level;  ///< for each triangle, a position in `levels`
  double least_radius = 0;           ///< α₀; 0 if there can be no triangle
  std::vector<ArrayLevel> levels;    ///< strictly ascending in alpha; empty if there can be no triangle
};

/// Computes the solid alpha complex with the level of each triangle.
/// Requires: 0 < alpha ≤ infinity; finite points, at most 357,913,941 of them; a leaf capacity of at least 1.
/// Throws:   InvalidInput that names alpha, the number of points or the first point that is not finite, before anything
///           is computed; ContractViolation when the leaf capacity is 0; Cancelled.
/// Cost:     memory for 15 bytes a point more than alpha_complex().
RBPA_API TrianglesByLevel triangles_by_level(std::span<const Point> points, double alpha,
                                             const TrianglesByLevelOptions& options = {});

}  // namespace rbpa
