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

/// The triangles of a fan around the lexicographically least corner of a face, in its direction; with a corner twice also
/// triangles that have it twice.
template <typename Use>
void for_each_fan_triangle(std::span<const std::uint32_t> face, std::span<const std::array<double, 3>> positions,
                           Use use) {
  std::size_t least = 0;
  for (std::size_t i = 1; i < face.size(); ++i)
    if (positions[face[i]] < positions[face[least]]) least = i;
  const auto corner = [&](std::size_t i) { return face[(least + i) % face.size()]; };
  for (std::size_t i = 1; i + 1 < face.size(); ++i) use(std::array{corner(0), corner(i), corner(i + 1)});
}

}  // namespace rbpa::app
