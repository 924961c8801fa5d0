// What: a filtration as plain arrays, ordered by alpha: the complex of any alpha is a prefix. Made for programs that
//       show the complex at one radius after another and compute nothing themselves.
// Law:  a function of the set of points alone. The first k triangles, k being the count of a filtration step, are the
//       solid alpha complex at the step's alpha.
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
  std::uint32_t triangle = 0;  ///< the first triangle at the edge, which appears later
  std::uint32_t side = 0;      ///< side of that triangle, from corner `side` to the next
  friend bool operator==(const FreeEdge&, const FreeEdge&) = default;
};

/// A persistence pair of the solid complex, located by a triangle. A component contains the triangle from the
/// component's birth on. A hole contains the triangle until the hole's death, which the triangle causes.
struct PlacedPair {
  PersistencePair pair = {};
  std::uint32_t triangle = 0;
  friend bool operator==(const PlacedPair&, const PlacedPair&) = default;
};

struct FiltrationArrays {
  std::vector<Point> points;  ///< the distinct points, in lexicographic order
  /// The triangles as indices into `points`, counter-clockwise, the smallest first; sorted by alpha, then by corners.
  std::vector<Triangle> triangles;
  std::vector<double> alpha;         ///< for each triangle, the alpha at which it appears
  std::vector<FreeEdge> free_edges;  ///< by alpha, then by triangle and side; empty without triangles
  std::vector<PlacedPair> pairs;     ///< sorted as by persistence(), equal pairs by triangle
};

/// Computes the arrays from a triangulation and its filtration.
/// Requires: `filtration` is filtration(delaunay).
/// Throws:   ContractViolation when `filtration` is visibly of another triangulation; Cancelled.
RBPA_API FiltrationArrays filtration_arrays(const Delaunay& delaunay, const Filtration& filtration,
                                            const GoOn& go_on = {});
/// Computes the same from a triangulation that alpha_complex(points, infinity, {.neighbors = true}) returned.
/// Throws: also ContractViolation as the constructor of Delaunay, which checks the triangulation.
inline FiltrationArrays filtration_arrays(const AlphaComplex& delaunay, std::span<const Point> points,
                                          const Filtration& filtration, const GoOn& go_on = {}) {
  return filtration_arrays(Delaunay(delaunay, points, go_on, "filtration_arrays"), filtration, go_on);
}

}  // namespace rbpa
