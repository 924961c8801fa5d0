// What: cuts handles and closes tunnels around which a short loop leads, for --close-tunnels-below.
// How:  the loops are the shortest generators. Removing the faces at the points of a loop leaves a hole on either side
//       of the loop, and both holes are filled as by --fill-holes. This removes a thin bridge, or closes a small
//       tunnel, without intersections.
// Law:  each closed loop reduces the genus by one and adds no component, boundary curve or pinch. If this is impossible
//       at a loop, the mesh does not change there.
// Cost: one call of shortest_generators() for each round, of which all but the last close loops; one topology report
//       and one rbpa::fill_holes() for each loop.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "io/mesh/read_mesh.h"

namespace rbpa::app {

struct ClosedTunnels {
  std::size_t closed = 0, left = 0;    ///< numbers of loops shorter than `below` that were closed, and not closed
  std::size_t removed = 0, added = 0;  ///< numbers of removed and of added faces
};

struct SimplerMesh {
  MeshFile mesh;                         ///< without line numbers
  std::vector<std::uint32_t> point_was;  ///< number of each vertex in the given mesh
  ClosedTunnels report;
};

/// Cuts handles and closes tunnels of a copy of `mesh` along generators shorter than `below`, in units of the
/// positions. Requires: `mesh` is a surface without defects other than pinches. Throws Cancelled.
SimplerMesh close_tunnels(const MeshFile& mesh, double below);

}  // namespace rbpa::app
