// What: the cells of a Delaunay triangulation, each with the least alpha at which it is in a complex.
// Law:  a cell is never in the complex before its faces: vertices[end] ≤ edge.alpha ≤ faces[side].
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/base/steps.h"
#include "rbpa/filtration.h"
#include "rbpa/persistence.h"
#include "rbpa/triangulate.h"

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

/// The input indices of the distinct points, ascending.
std::vector<std::uint32_t> distinct_points(const Triangulation& delaunay);

/// Requires and throws: as persistence(), but that the triangulation is of the points. The step beats with every edge.
FilteredCells filtered_cells(const Triangulation& delaunay, std::span<const Point> points, const Filtration& filtration,
                             ComplexKind kind, Steps& pulse);

}  // namespace rbpa
