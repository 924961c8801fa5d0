// What: handles cut and tunnels closed around which a short loop goes: --close-tunnels-below.
// How:  the shortest generators are the loops. Of one the faces at its points are removed, which leaves a hole on either side, and
//       both are filled as --fill-holes fills them: a thin bridge is gone then, or a small tunnel closed, and nothing crosses.
// Law:  each that is closed makes the genus less by one, and no component, boundary curve or pinch more; where that cannot be,
//       the mesh stays there as it is.
// Cost: for each round that closes some, that of shortest_generators(); for each loop, that of a report and of rbpa::fill_holes().
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "io/mesh/read_mesh.h"

namespace rbpa::app {

struct ClosedTunnels {
  std::size_t closed = 0, left = 0;    ///< loops below the length
  std::size_t removed = 0, added = 0;  ///< faces
};

struct SimplerMesh {
  MeshFile mesh;                         ///< without lines
  std::vector<std::uint32_t> point_was;  ///< of each vertex: its number in the mesh that was given
  ClosedTunnels report;
};

/// Those around which a generator goes that is shorter than `below`.
/// Requires: a surface: no defects but pinches. Throws Cancelled.
SimplerMesh close_tunnels(const MeshFile& mesh, double below);

}  // namespace rbpa::app
