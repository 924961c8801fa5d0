// What: holes of a mesh filled: --fill-holes.
// Law:  no face is moved, and no vertex is added but where vertices that become one would get an edge of more than two
//       faces in common: there edges are cut, as a repair does it, and the result is a surface again. The new faces are
//       triangles, as those of `rbpa surface` are: they turn least against the faces around the hole, and cross
//       nothing, which is decided exactly. A face of more than three corners counts there as triangles around the mean
//       of its corners. Which holes are filled, and how, does not depend on the order of vertices and faces.
// Cost: that of a repair and of rbpa::fill_holes().
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "io/mesh/read_mesh.h"
#include "rbpa/curve_kinds.h"
#include "rbpa/holes.h"
#include "triangulation/filling_counts.h"
#include "triangulation/hole_choice.h"

namespace rbpa::app {

struct Filled {
  FillingCounts counts = {};
  std::array<std::size_t, 3> not_chosen = {};  ///< boundary curves, by CurveKind
  std::size_t merged = 0;                      ///< vertices, at equal places along a hole, that became one with another
};

struct FilledMesh {
  MeshFile mesh;                         ///< without lines; the new faces are the last ones
  std::vector<std::uint32_t> point_was;  ///< of each vertex: its number in the mesh that was given
  Filled report;
};

/// Whether to fill a boundary curve: with its kind, and the points of the mesh along it.
using CurveChoice = std::function<bool(const Hole&, CurveKind, std::span<const std::uint32_t>)>;

/// Requires: a surface: no defects but pinches. Throws Cancelled.
FilledMesh fill(const MeshFile& mesh, const CurveChoice& choice);
inline FilledMesh fill(const MeshFile& mesh, const HoleChoice& choice) {
  return fill(mesh, [&](const Hole& curve, CurveKind kind, const auto&) { return choice.has(curve, kind); });
}

}  // namespace rbpa::app
