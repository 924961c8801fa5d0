// What: chooses the components of a mesh to keep: --keep-largest and --drop-small.
// Law:  components are connected through edges, as in the report. Their size is that of `rbpa surface`: a face of n
//       corners counts as the n − 2 triangles of a fan. The choice does not depend on the order of vertices and faces.
// Cost: that of a repair, plus n log n.
#pragma once

#include <vector>

#include "io/mesh/read_mesh.h"
#include "triangulation/component_choice.h"

namespace rbpa::app {

struct KeptComponents {
  std::vector<bool> faces;  ///< whether each face is kept; degenerate and repeated faces are not
  std::size_t dropped = 0;  ///< number of dropped components
};

/// Returns the faces of the chosen components. Requires: `choice` is not restricted to outer shells. Throws Cancelled.
KeptComponents kept_components(const MeshFile& mesh, const ComponentChoice& choice);

}  // namespace rbpa::app
