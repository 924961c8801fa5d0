// What: the cells of a Delaunay triangulation, each with the least alpha at which it is in a complex.
// Law:  a cell is never in the complex before its faces: vertices[end] ≤ edge.alpha ≤ faces[side].
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rbpa/base/steps.h"
#include "rbpa/delaunay.h"
#include "rbpa/filtration.h"
#include "rbpa/persistence.h"

namespace rbpa {

struct FilteredCells {
  struct Edge {
    double alpha;
    std::array<std::uint32_t, 2> ends;   ///< vertices
    std::array<std::uint32_t, 2> sides;  ///< faces; outside() beyond the hull
  };
  std::vector<double> vertices;  ///< of each distinct point, by input index
  std::vector<Edge> edges;
  std::vector<double> faces;  ///< of each triangle
  std::uint32_t outside() const { return static_cast<std::uint32_t>(faces.size()); }
};

/// The distinct points, ascending by input index.
struct DistinctPoints {
  std::vector<std::uint32_t> index;   ///< in the input, of each
  std::vector<std::uint32_t> number;  ///< of each input point among them; that of a duplicate has no meaning
};
DistinctPoints distinct_points(const Delaunay& delaunay);

/// Requires: the filtration and the distinct points of `of`. Counts each edge as a step.
FilteredCells filtered_cells(const Delaunay& of, const DistinctPoints& distinct, const Filtration& filtration,
                             ComplexKind kind, Steps& pulse);

}  // namespace rbpa
