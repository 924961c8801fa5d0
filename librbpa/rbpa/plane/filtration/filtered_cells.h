// What: the cells of a Delaunay triangulation, each with the least alpha at which the complex contains the cell.
// Law:  a cell is never in the complex before the cells on its boundary: vertices[end] ≤ edge.alpha ≤ faces[side].
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rbpa/base/run/steps.h"
#include "rbpa/plane/delaunay.h"
#include "rbpa/plane/filtration.h"
#include "rbpa/plane/persistence.h"

namespace rbpa {

struct FilteredCells {
  struct Edge {
    double alpha;
    std::array<std::uint32_t, 2> ends;   ///< numbers of the vertices at the ends
    std::array<std::uint32_t, 2> sides;  ///< numbers of the faces on both sides; outside() beyond the hull
  };
  std::vector<double> vertices;  ///< for each distinct point, ascending by input index, its alpha
  std::vector<Edge> edges;
  std::vector<double> faces;  ///< for each triangle, its alpha
  std::uint32_t outside() const { return static_cast<std::uint32_t>(faces.size()); }
};

/// The distinct points, ascending by input index.
struct DistinctPoints {
  std::vector<std::uint32_t> index;  ///< the input index of each distinct point
  /// The number of each input point among the distinct points; undefined for a duplicate.
  std::vector<std::uint32_t> number;
};
DistinctPoints distinct_points(const Delaunay& delaunay);

/// Returns the cells with their alphas; a solid complex without a triangle has no cells. Counts each edge as a step.
/// Requires: `filtration` is filtration(of); `distinct` is distinct_points(of).
FilteredCells filtered_cells(const Delaunay& of, const DistinctPoints& distinct, const Filtration& filtration,
                             ComplexKind kind, Steps& pulse);

}  // namespace rbpa
