// What: computes a filtration as plain arrays, ordered by alpha: the complex of any alpha is a prefix. Made for
//       programs that show the complex at one radius after another and compute nothing themselves.
// Law:  the arrays are a function of the set of points alone. The first step.triangles triangles are the solid alpha
//       complex at step.alpha, for every step of the filtration.
// Cost: about twice that of persistence().
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/delaunay.h"
#include "rbpa/plane/filtration.h"
#include "rbpa/plane/persistence.h"

namespace rbpa {

/// An edge that enters the full alpha complex at a smaller alpha than every triangle that contains it.
struct FreeEdge {
  double alpha = 0;            ///< radius at which the edge appears: half its length, rounded up
  std::uint32_t triangle = 0;  ///< number of the first triangle at the edge, which appears later than the edge
  std::uint32_t side = 0;      ///< 0 to 2: the edge is the side of that triangle from corner `side` to the next corner
  friend bool operator==(const FreeEdge&, const FreeEdge&) = default;
};

/// A persistence pair of the solid complex, located by a triangle. A component contains the triangle from the birth of
/// the component on. A hole contains the triangle until the death of the hole, which the triangle causes.
struct PlacedPair {
  PersistencePair pair = {};
  std::uint32_t triangle = 0;  ///< number in FiltrationArrays::triangles
  friend bool operator==(const PlacedPair&, const PlacedPair&) = default;
};

/// The arrays of a filtration. If there is no triangle, all but `points` are empty.
struct FiltrationArrays {
  std::vector<Point> points;  ///< the distinct points, in lexicographic order
  /// The triangles as indices into `points`, counter-clockwise, the smallest first; sorted by alpha, then by corners.
  std::vector<Triangle> triangles;
  std::vector<double> alpha;         ///< for each triangle, the alpha at which it appears
  std::vector<FreeEdge> free_edges;  ///< sorted by alpha, then by triangle and side
  std::vector<PlacedPair> pairs;     ///< sorted as by persistence(), equal pairs by triangle
};

/// Computes the arrays from a triangulation and its filtration.
/// Requires: `filtration` is filtration(delaunay), of which only the numbers of triangles and points are checked.
/// Throws:   ContractViolation when one of these numbers differs; Cancelled.
RBPA_API FiltrationArrays filtration_arrays(const Delaunay& delaunay, const Filtration& filtration,
                                            const GoOn& go_on = {});
/// Computes the arrays of a triangulation that alpha_complex(points, infinity, {.neighbors = true}) returned.
/// Throws: as the first overload; ContractViolation as the constructor of Delaunay, which checks the triangulation.
inline FiltrationArrays filtration_arrays(const AlphaComplex& delaunay, std::span<const Point> points,
                                          const Filtration& filtration, const GoOn& go_on = {}) {
  return filtration_arrays(Delaunay(delaunay, points, go_on, "filtration_arrays"), filtration, go_on);
}

}  // namespace rbpa
