// What:   the solid alpha complex of points in the plane, by restricted ball pivoting.
// Law:    the set of triangles is a function of the set of points and alpha alone: of nothing else
//         (order of the input, method of search, compiler). rbpa(S, a) is a subset of rbpa(S, b) for a ≤ b, and
//         rbpa(S, infinity) is the Delaunay triangulation.
// Cost:   about linear in the number of points for samplings of bounded variation, see docs/performance.md.
// Source: Medeiros, Velho, Lopes, Restricted BPA, sections 3 and 4 (Theorem 1).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "rbpa/core/api.h"
#include "rbpa/core/mesh.h"
#include "rbpa/core/point.h"

namespace rbpa {

/// How the points that a ball may touch are searched. The result is the same.
enum class Search {
  near_to_far,  ///< grid whose cells follow the points, searched outward and bounded by the candidate's circle
  paper_grid    ///< the paper's grid: cells of side 2α, nine cells scanned each time; cost grows with α²
};

/// How far a run has come: triangles attached so far, and distinct points.
struct Progress {
  std::size_t triangles;
  std::size_t points;
};

struct Options {
  Search search = Search::near_to_far;
  /// Called every few milliseconds; returning false cancels the run. Empty: never called.
  std::function<bool(const Progress&)> progress = {};
};

/// A point equal to one given before it.
struct Duplicate {
  std::uint32_t index;       ///< the input index of the repetition
  std::uint32_t stands_for;  ///< the lowest input index with the same coordinates
  friend bool operator==(const Duplicate&, const Duplicate&) = default;
};

/// A solid alpha complex as an oriented 2-manifold with boundary.
/// Where the complex touches itself in a point (a pinch), each fan has a vertex of its own on the same input point.
struct SolidAlphaComplex {
  Mesh mesh;                               ///< faces counter-clockwise; no isolated and no deleted elements; z = 0
  std::vector<std::uint32_t> input_index;  ///< of each vertex of the mesh, the input point it stands on
  std::vector<std::uint32_t> isolated;     ///< input indices of distinct points in no triangle, ascending
  std::vector<Duplicate> duplicates;       ///< ascending by index
  std::size_t distinct = 0;                ///< number of distinct points
};

/// The solid alpha complex of `points`: their Delaunay triangles of circumradius ≤ `alpha`.
/// Cocircular points are triangulated by the symbolic perturbation that docs/predicates.md defines.
/// Requires: 0 < alpha ≤ infinity, a radius; finite points, fewer than 2³⁰ of them.
/// Throws:   InvalidInput naming the value or the first bad point, before anything is computed; Cancelled.
RBPA_API SolidAlphaComplex rbpa(std::span<const Point> points, double alpha, const Options& options = {});

/// The triangles of a complex as input indices in canonical order: counter-clockwise, smallest index first, sorted.
RBPA_API std::vector<std::array<std::uint32_t, 3>> triangles(const SolidAlphaComplex& complex);

}  // namespace rbpa
