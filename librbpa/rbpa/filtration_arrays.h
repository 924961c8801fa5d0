// What: a filtration as plain arrays, ordered by the alpha at which each item appears: the complex of any alpha is a prefix.
//       For programs that show the complex at one radius after another, and compute nothing themselves.
// Law:  a function of the set of points alone. The first k triangles, k as a step counts them, are the solid alpha complex
//       at the step's alpha.
// Cost: as persistence(), twice.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/delaunay.h"
#include "rbpa/filtration.h"
#include "rbpa/persistence.h"
#include "rbpa/triangulate.h"

namespace rbpa {

/// An edge that is in the full alpha complex before any triangle at it is.
struct FreeEdge {
  double alpha = 0;            ///< from here on: half its length, rounded up
  std::uint32_t triangle = 0;  ///< the first at it, which comes later
  std::uint32_t side = 0;      ///< of that triangle, from corner `side` to the next
  friend bool operator==(const FreeEdge&, const FreeEdge&) = default;
};

/// A pair of the solid complex, and a triangle that is a part of the component from its birth on, or a part of the hole
/// until its death, which this triangle is.
struct PlacedPair {
  PersistencePair pair = {};
  std::uint32_t triangle = 0;
  friend bool operator==(const PlacedPair&, const PlacedPair&) = default;
};

struct FiltrationArrays {
  std::vector<Point> points;         ///< the distinct ones, in lexicographic order
  std::vector<Triangle> triangles;   ///< of those, counter-clockwise, the smallest first; by alpha,
                                     ///< those of one alpha by corners
  std::vector<double> alpha;         ///< of each triangle
  std::vector<FreeEdge> free_edges;  ///< by alpha, then by triangle and side
  std::vector<PlacedPair> pairs;     ///< as persistence() sorts them, equal ones by triangle
};

/// Requires: `filtration` is filtration(delaunay).
/// Throws:   ContractViolation when it is visibly of another triangulation; Cancelled when `go_on`, which is called every few
///           milliseconds, returns false. Empty: never called.
RBPA_API FiltrationArrays filtration_arrays(const Delaunay& delaunay, const Filtration& filtration,
                                            const std::function<bool()>& go_on = {});
/// The same of triangulate(points, infinity, {.neighbors = true}), which is checked first, as by Delaunay.
inline FiltrationArrays filtration_arrays(const Triangulation& delaunay, std::span<const Point> points,
                                          const Filtration& filtration, const std::function<bool()>& go_on = {}) {
  return filtration_arrays(Delaunay(delaunay, points, go_on, "filtration_arrays"), filtration, go_on);
}

}  // namespace rbpa
