// What: holds the options and the result of hrbpa(): the levels of a hierarchy of radii.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "meshops/front/front.h"
#include "rbpa/base/progress.h"
#include "rbpa/plane/complex.h"

namespace rbpa {

/// One level of a hierarchy of radii: its size and its work.
struct Level {
  double alpha = 0;  ///< the radius: 2^number α₀, or on the last level the alpha of the whole run
  int number = 0;    ///< exponent of the radius; levels between the first and the last without a triangle are left out
  /// Number of points transferred from the level before: isolated points and points on the boundary of its complex. On
  /// the first level, all points.
  std::size_t transferred = 0;
  /// Number of points with a triangle of this level; in results of rbpa::paper::hrbpa(), all transferred points.
  std::size_t taking_part = 0;
  std::size_t advancing = 0;  ///< number of halfedges on the front when the level began
  /// Number of triangles of the mesh when the level ended; those of this level have the last numbers.
  std::size_t triangles = 0;
  /// Time in seconds, including the work before the level: the computation of α₀ or the transfer, and levels left out.
  /// Without HierarchyOptions::level_ended, all levels are computed together: the first level has the time of all
  /// levels, other levels have 0.
  double seconds = 0;
};

/// A level that has just ended, and the mesh at its end: exactly the complex of `level.alpha`, an oriented 2-manifold.
/// All boundary halfedges are frozen: no further triangle of this level can be attached (meshops/front/front.h). The
/// references are valid during the callback only.
struct EndedLevel {
  const Level& level;
  /// The front with its mesh. Faces 0 … front.faces() − 1 of the mesh are the triangles of the complex, with their
  /// final numbers; faces from front.faces() and edges from front.edges() on are not in use. Vertices have no
  /// coordinates yet.
  const meshops::Front& front;
  std::span<const std::uint32_t> input_index;  ///< for each site of the front, the index of its input point
};

struct HierarchyOptions {
  /// Maximum number of points in a leaf of the quadtree whose smallest leaf determines α₀. At least 1. If absent, the
  /// maximum is usual_leaf_capacity (triangles_by_level.h); for rbpa::paper::hrbpa() it is the default of paper.h.
  std::optional<std::size_t> leaf_capacity = std::nullopt;
  MaxThreads threads = 0;  ///< maximum number; 0: all processors
  /// Callback for progress and cancellation, called at the intervals of Options::progress (rbpa.h).
  OnProgress progress = {};
  /// Callback at the end of each level of Hierarchy::levels, before the next level begins. The time of the callback
  /// counts for no level, and an exception of the callback ends the run. An empty function is not called.
  std::function<void(const EndedLevel&)> level_ended = {};
};

/// A solid alpha complex and the levels on which it grew.
struct Hierarchy {
  SolidAlphaComplex complex;       ///< the complex of the last level; faces are in the order of levels (level_of())
  double least_radius = 0;         ///< α₀; 0 if there can be no triangle
  std::vector<Level> levels;       ///< strictly ascending in alpha; empty if there can be no triangle
  std::size_t looked_in_vain = 0;  ///< number of points that took part in levels left out; 0 except in rbpa::paper
};

}  // namespace rbpa
