// What: the numbers of elements, components and boundary curves of a mesh, and its genus.
// Law:  euler = vertices − edges + faces.
#pragma once

#include <cstddef>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"

namespace meshops {

/// Counts of a mesh, without elements marked deleted. An isolated vertex counts as a vertex and as a component.
struct TopologyCounts {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t components = 0;  ///< number of parts that are connected through edges; an isolated vertex is one part
  std::size_t boundary_curves = 0;

  long euler() const { return static_cast<long>(vertices) - static_cast<long>(edges) + static_cast<long>(faces); }
  /// Returns the sum of the genera g of all components. With k curves, χ = 2 − 2g − k; an isolated vertex has g = 0.
  long genus() const {
    return (2 * static_cast<long>(components) - euler() - static_cast<long>(boundary_curves) -
            static_cast<long>(isolated)) /
           2;
  }
  std::size_t isolated = 0;  ///< number of vertices without edges
  friend bool operator==(const TopologyCounts&, const TopologyCounts&) = default;
};

/// Counts the elements, components and boundary curves of a mesh.
/// Requires: validate(mesh) is empty; not checked. For a mesh with several fans at a vertex, use report()
///           (topology/report.h).
/// Cost:     near-linear.
MESHOPS_API TopologyCounts count_topology(const Connectivity& mesh);

}  // namespace meshops
