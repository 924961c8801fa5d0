// What:   the solid alpha complex as plain arrays, with the level of each triangle: the first of the radii α₀, 2α₀, 4α₀ … alpha
//         that admits it.
// Law:    the triangles are those of triangulate(), the levels those of hrbpa() (hrbpa.h).
// Cost:   that of triangulate(), a quadtree's and a comparison of the circumradius for each triangle.
// Source: Medeiros, Velho, Lopes, Restricted BPA, section 6; docs/hrbpa.md.
// Note:   independent of OpenMesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/base/progress.h"
#include "rbpa/triangulate.h"

namespace rbpa {

/// The default of HierarchyOptions::leaf_capacity and of HierarchyArraysOptions::leaf_capacity.
inline constexpr std::size_t usual_leaf_capacity = 16384;

struct HierarchyArraysOptions {
  /// The most points in a leaf of the quadtree whose smallest leaf determines α₀. At least 1.
  std::size_t leaf_capacity = usual_leaf_capacity;
  bool neighbors = false;  ///< fills in Triangulation::neighbors
  bool boundary = false;   ///< fills in Triangulation::boundary
  /// Threads that work at most, the calling one included. 0 = all processors; larger values are capped. The result is the
  /// same.
  unsigned threads = 0;
  /// Called every few milliseconds, one call at a time but from any thread of the run; returning false cancels it. Empty:
  /// never called.
  std::function<bool(const Progress&)> progress = {};
};

/// A level: its radius, and the size of the complex of this radius.
struct ArrayLevel {
  double alpha = 0;           ///< 2^number α₀, or that of the whole run on the last level
  int number = 0;             ///< levels between the first and the last that have no triangle are left out
  std::size_t triangles = 0;  ///< of this level and all before it
  friend bool operator==(const ArrayLevel&, const ArrayLevel&) = default;
};

struct HierarchyArrays {
  Triangulation complex;
  std::vector<std::uint16_t> level;  ///< of each triangle, a position in `levels`
  double least_radius = 0;           ///< α₀; 0 when there is no triangle to look for
  std::vector<ArrayLevel> levels;    ///< ascending in alpha
};

/// Requires and throws: as triangulate(); ContractViolation when the leaf capacity is 0.
/// Cost:     about linear; 15 bytes a point more than triangulate().
RBPA_API HierarchyArrays hrbpa_arrays(std::span<const Point> points, double alpha,
                                      const HierarchyArraysOptions& options = {});

}  // namespace rbpa
