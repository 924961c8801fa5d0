// What: fills holes of a mesh, for --fill-holes.
// Law:  no face moves. If the boundary of a hole passes through a position several times, the vertices at this position
//       are merged. An edge with more than two faces after merging is cut as by meshops::repair(), which adds vertices.
//       The new faces are triangles, as in `rbpa surface`: their dihedral angles to the faces around the hole and to
//       each other are the least possible, and they cross no face, which is decided exactly. For both criteria a face
//       of more than three corners counts as triangles around the mean of its corners. The filled holes and their
//       triangles do not depend on the order of vertices and faces.
// Cost: that of meshops::repair() and of rbpa::fill_holes().
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
#include "triangulation/choices.h"
#include "triangulation/filling_counts.h"

namespace rbpa::app {

struct Filled {
  FillingCounts counts = {};
  std::array<std::size_t, 3> not_chosen = {};  ///< numbers of boundary curves that were not chosen, by CurveKind
  std::size_t merged = 0;  ///< number of vertices along holes that were merged into another at an equal position
};

struct FilledMesh {
  MeshFile mesh;                         ///< without line numbers; the new faces are the last faces
  std::vector<std::uint32_t> point_was;  ///< number of each vertex in the given mesh
  Filled report;
};

/// A function that decides whether a boundary curve is filled. Its arguments are the curve, the kind of the curve, and
/// the numbers of the points along the curve in the given mesh. Numbers in Hole refer to a copy of the mesh with one
/// vertex for each fan.
using CurveChoice = std::function<bool(const Hole&, CurveKind, std::span<const std::uint32_t>)>;

/// Fills the chosen holes of a copy of `mesh`. Requires: `mesh` is a surface without defects other than pinches. Throws
/// Cancelled.
FilledMesh fill(const MeshFile& mesh, const CurveChoice& choice);
inline FilledMesh fill(const MeshFile& mesh, const HoleChoice& choice) {
  return fill(mesh, [&](const Hole& curve, CurveKind kind, const auto&) { return choice.has(curve, kind); });
}

}  // namespace rbpa::app
