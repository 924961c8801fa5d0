// What: the cells of a Delaunay triangulation, each with the least alpha at which it is in a complex.
// Law:  a cell is never there before its faces: vertices[end] ≤ edge.alpha ≤ faces[side].
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/base/pulse.h"
#include "rbpa/filtration.h"
#include "rbpa/persistence.h"
#include "rbpa/rbpa.h"

namespace rbpa {

struct FilteredCells {
  struct Edge {
    double alpha;
    std::array<std::uint32_t, 2> ends;   ///< vertices
    std::array<std::uint32_t, 2> sides;  ///< faces; outside() beyond the hull
  };
  std::vector<double> vertices;
  std::vector<Edge> edges;
  std::vector<double> faces;
  std::uint32_t outside() const { return static_cast<std::uint32_t>(faces.size()); }
};

/// Requires and throws: as persistence(). The pulse beats with every edge.
FilteredCells filtered_cells(const SolidAlphaComplex& delaunay, std::span<const Point> points,
                             const Filtration& filtration, ComplexKind kind, Pulse& pulse);

}  // namespace rbpa
