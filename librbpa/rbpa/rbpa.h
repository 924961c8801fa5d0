// What:   the solid alpha complex of points in the plane, by restricted ball pivoting.
// Law:    the triangles are a function of the set of points and alpha alone, not of the order of the input, the method
//         of search or the compiler. rbpa(S, a) is a subset of rbpa(S, b) for a ≤ b, and rbpa(S, infinity) is the
//         Delaunay triangulation.
// Cost:   about linear in the number of points where density varies little: docs/reference/performance.md.
// Source: Medeiros, Velho, Lopes, Restricted BPA, sections 3 and 4 (Theorem 1).
#pragma once

#include <cstddef>
#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/base/progress.h"
#include "rbpa/plane/complex.h"

namespace rbpa {

/// Options of a run of rbpa(), which do not change its result.
struct Options {
  MaxThreads threads = 0;  ///< maximum number of threads; 0: one for each processor
  /// Callback for progress and cancellation, called every few milliseconds. Intervals are up to 0.1 s per million
  /// points while points are sorted or the mesh is finished, and on rare sets up to 0.5 s per million points.
  OnProgress progress = {};
};

/// Computes the solid alpha complex of `points`: their Delaunay triangles of circumradius ≤ `alpha`. Cocircular points
/// are triangulated by the symbolic perturbation that docs/explanation/exact_decisions.md defines. The complex of fewer
/// than three points, or of points on one line, has no triangle.
/// Requires: 0 < alpha ≤ infinity; finite points; at most 357,913,941 of them (OpenMesh numbers halfedges in int).
/// Throws:   InvalidInput, before anything is computed, that names a wrong alpha, too many points or the first point
///           that is not finite; Cancelled; any exception of `options.progress`.
RBPA_API SolidAlphaComplex rbpa(std::span<const Point> points, double alpha, const Options& options = {});

/// Returns the number of threads that rbpa() and hrbpa() use for a number of points when the option `threads` is
/// `wanted`: 1 for fewer than 10,000 points; otherwise `wanted`, but at most the number of processors, which is also
/// the result for 0.
RBPA_API unsigned threads_used(std::size_t points, unsigned wanted);

}  // namespace rbpa
