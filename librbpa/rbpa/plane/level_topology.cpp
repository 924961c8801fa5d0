#include "rbpa/plane/level_topology.h"

#include <cstdint>

#include "meshops/core/contract.h"
#include "rbpa/plane/filtration/growth.h"
#include "rbpa/plane/levels.h"
#include "rbpa/plane/mesh/linked_faces.h"

namespace rbpa {

std::vector<ComplexCounts> level_topology(const Hierarchy& hierarchy) {
  const std::size_t triangles = hierarchy.levels.empty() ? 0 : hierarchy.levels.back().triangles;
  meshops::require_one_each("level_topology", triangles, "triangles of the levels", hierarchy.complex.mesh.n_faces(),
                            "faces of the complex");
  const OwnedTriangles faces = linked_faces(hierarchy.complex.mesh);
  Growth growth(faces, hierarchy.complex.mesh.n_vertices(), hierarchy.complex.input_index);
  std::vector<ComplexCounts> counts;
  counts.reserve(hierarchy.levels.size());
  std::uint32_t face = 0;
  for (const Level& level : hierarchy.levels) {
    while (face < level.triangles) growth.add(face++);
    counts.push_back(growth.counts());
  }
  return counts;
}

}  // namespace rbpa
