// What: the components of a mesh that are kept: --keep-largest and --drop-small.
// Law:  a component is a piece of surface connected through edges, as the report has it, and its size that of `rbpa surface`: a
//       face of n corners counts as the n − 2 triangles of a fan. None of it depends on the order of vertices and faces.
// Cost: that of a repair, and n log n.
#pragma once

#include <vector>

#include "io/mesh/read_mesh.h"
#include "triangulation/component_choice.h"

namespace rbpa::app {

struct KeptComponents {
  std::vector<bool> faces;  ///< of each, whether it is kept; what is degenerate or repeats another is not
  std::size_t dropped = 0;  ///< components
};

/// Requires: the choice is of all shells. Throws Cancelled.
KeptComponents kept_components(const MeshFile& mesh, const ComponentChoice& choice);

}  // namespace rbpa::app
