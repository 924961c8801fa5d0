// What:   the solid alpha complex from the bottom up: restricted ball pivoting with radii α₀, 2α₀, 4α₀ … up to alpha.
// Law:    the same set of triangles as rbpa() gives; after each level the mesh is exactly the complex of its radius.
// Cost:   follows the points that take part on each level; see docs/hrbpa.md.
// Source: Medeiros, Velho, Lopes, Restricted BPA, section 6.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "meshops/front/front.h"
#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/base/progress.h"
#include "rbpa/complex.h"
#include "rbpa/hrbpa_arrays.h"

namespace rbpa {

/// One level of a hierarchy of radii: its size and its work.
struct Level {
  double alpha = 0;             ///< the radius: 2^number α₀, or that of the whole run on the last level
  int number = 0;               ///< levels between the first and the last that have no triangle are left out
  std::size_t transferred = 0;  ///< points carried on from the level before: isolated or on the boundary
  std::size_t taking_part = 0;  ///< of those, how many got a triangle or were examined; the others were skipped
  std::size_t advancing = 0;    ///< halfedges on the front when the level began
  std::size_t triangles = 0;    ///< of the mesh when the level ended; those added are the last
  /// Including the work before it: α₀ or the transfer, and levels left out. Where no function sees the end of each level,
  /// all triangles are laid at once: then the first level has the time of all, and the others 0.
  double seconds = 0;
};

/// A level that has just ended, and what the run has built so far: exactly the complex of `level.alpha`, an oriented
/// 2-manifold whose boundary halfedges are all frozen. Valid during the call only.
struct EndedLevel {
  const Level& level;
  /// The first front.faces() faces of its mesh are those of the complex, with the numbers they will keep; what lies
  /// behind them, and behind the first front.edges() edges, is not in use yet. Its vertices have no coordinates yet.
  const meshops::Front& front;
  std::span<const std::uint32_t> input_index;  ///< of each site of the front, the input point it is
};

struct HierarchyOptions {
  /// The most points in a leaf of the quadtree whose smallest leaf determines α₀. At least 1. Absent: usual_leaf_capacity.
  std::optional<std::size_t> leaf_capacity = std::nullopt;
  /// Threads that work at most, the calling one included. 0 = all processors; larger values are capped. The result is the
  /// same.
  unsigned threads = 0;
  /// Called every few milliseconds, one call at a time but from any thread of the run; returning false cancels it. Less
  /// often while points are sorted before the first triangle, while triangles that tiles leave over are inserted, and while
  /// the mesh is finished: intervals are up to about 0.1 s per million points there, or 0.5 s on sets where tiles find no
  /// triangle. Empty: never called.
  std::function<bool(const Progress&)> progress = {};
  /// Called with each level of Hierarchy::levels when it has ended, before the next one begins; its time is in no level's.
  /// An exception that it throws ends the run. Empty: never called.
  std::function<void(const EndedLevel&)> level_ended = {};
};

struct Hierarchy {
  SolidAlphaComplex complex;       ///< its faces are in the order of the levels
  double least_radius = 0;         ///< α₀; 0 when there is no triangle to look for
  std::vector<Level> levels;       ///< ascending in alpha
  std::size_t looked_in_vain = 0;  ///< points that took part on levels left out
};

/// The solid alpha complex of `points` by hierarchical restricted ball pivoting.
/// Requires: 0 < alpha ≤ infinity, a radius; finite points, at most 357,913,941 of them, as
///           OpenMesh numbers halfedges in int.
/// Throws:   InvalidInput naming the value or the first bad point, before anything is computed; Cancelled;
///           what the functions in `options` throw.
RBPA_API Hierarchy hrbpa(std::span<const Point> points, double alpha, const HierarchyOptions& options = {});

/// The level at which a face came into the complex, as a position in `levels`.
RBPA_API std::size_t level_of(const Hierarchy& hierarchy, std::size_t face);

}  // namespace rbpa
