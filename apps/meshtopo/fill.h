// What: fills holes of a mesh: --fill-holes.
// Law:  no face moves. Vertices are merged where a hole passes a position several times; an edge that would then have
//       more than two faces is cut as by a repair, which adds vertices. The new faces are triangles, as in
//       `rbpa surface`: they have the least dihedral angles to the faces around the hole and to each other, and cross
//       nothing, which is decided exactly. For both, a face of more than three corners is split into triangles around
//       the mean of its corners. The filled holes and their triangles do not depend on the order of vertices and faces.
// Cost: that of a repair and of rbpa::fill_holes().
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "io/mesh/read_mesh.h"
#include "rbpa/space/surface/curve_kinds.h"
#include "rbpa/space/surface/holes.h"
#include "triangulation/filling_counts.h"
#include "triangulation/hole_choice.h"

namespace rbpa::app {

struct Filled {
  FillingCounts counts = {};
  std::array<std::size_t, 3> not_chosen = {};  ///< number of boundary curves that were not chosen, by CurveKind
  std::size_t merged = 0;                      ///< vertices along a hole merged with one at an equal position
};

struct FilledMesh {
  MeshFile mesh;                         ///< without line numbers; the new faces are the last ones
  std::vector<std::uint32_t> point_was;  ///< number of each vertex in the given mesh
  Filled report;
};

/// Decides whether to fill a boundary curve, from the curve, its kind, and the numbers of the points along it in the
/// given mesh. Numbers within Hole refer to a copy of the mesh with one vertex for each fan.
using CurveChoice = std::function<bool(const Hole&, CurveKind, std::span<const std::uint32_t>)>;

/// Fills the chosen holes. Requires: a surface without defects other than pinches. Throws Cancelled.
FilledMesh fill(const MeshFile& mesh, const CurveChoice& choice);
inline FilledMesh fill(const MeshFile& mesh, const HoleChoice& choice) {
  return fill(mesh, [&](const Hole& curve, CurveKind kind, const auto&) { return choice.has(curve, kind); });
}

}  // namespace rbpa::app
