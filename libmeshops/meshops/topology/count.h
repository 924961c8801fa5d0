// What: the numbers of elements, components and boundary curves of a mesh, and its genus.
// Law:  euler = vertices − edges + faces.
#pragma once

#include <cstddef>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"

namespace meshops {

/// Counts of a mesh. Elements marked deleted are not counted; an isolated vertex counts as a vertex and a component.
struct TopologyCounts {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t components = 0;  ///< number of parts connected through edges; an isolated vertex is one
  std::size_t boundary_curves = 0;

  long euler() const { return static_cast<long>(vertices) - static_cast<long>(edges) + static_cast<long>(faces); }
  /// Returns the sum of the genera g: a component with k boundary curves has χ = 2 − 2g − k, an isolated vertex g = 0.
  long genus() const {
    return (2 * static_cast<long>(components) - euler() - static_cast<long>(boundary_curves) -
            static_cast<long>(isolated)) /
           2;
  }
  std::size_t isolated = 0;  ///< vertices without an edge
  friend bool operator==(const TopologyCounts&, const TopologyCounts&) = default;
};

/// Counts the elements, components and boundary curves of a mesh.
/// Requires: validate(mesh) is empty; not checked. For a mesh with several fans at a vertex, use report() (report.h).
/// Cost:     near-linear.
MESHOPS_API TopologyCounts count_topology(const Connectivity& mesh);

}  // namespace meshops
