// What: the numbers of elements of a mesh, including elements marked deleted.
// Why:  code that keeps handles of a mesh detects with three comparisons that other code added elements or collected
//       garbage; the comparisons do not detect elements that were only marked deleted.
#pragma once

#include <cstddef>
#include <string>

#include "meshops/core/connectivity.h"

namespace meshops {

struct ElementCounts {
  std::size_t vertices = 0, edges = 0, faces = 0;

  /// Returns the counts of the mesh. Cost: constant.
  // The qualified names avoid calls of virtual functions, which no mesh type overrides.
  static ElementCounts of(const Connectivity& mesh) {
    return {mesh.Connectivity::n_vertices(), mesh.Connectivity::n_edges(), mesh.Connectivity::n_faces()};
  }
  friend bool operator==(const ElementCounts&, const ElementCounts&) = default;
};

/// Returns a text for people, for example "3 vertices, 3 edges, 1 faces".
inline std::string describe(const ElementCounts& counts) {
  return std::to_string(counts.vertices) + " vertices, " + std::to_string(counts.edges) + " edges, " +
         std::to_string(counts.faces) + " faces";
}

}  // namespace meshops
