// What: how large a mesh is: area, volume, box.
// Law:  rounded numbers, of sums with compensation; whether there is a volume is decided by the topology.
#pragma once

#include <array>
#include <optional>

#include "io/mesh/read_mesh.h"

namespace rbpa::app {

struct Measures {
  double area = 0;  ///< of all faces, as for_each_fan_triangle() parts them
  /// What pieces enclose that are closed and oriented: of one whose faces look at what they enclose less than 0. None:
  /// there is no such piece.
  std::optional<double> volume = std::nullopt;
  std::optional<std::array<std::array<double, 3>, 2>> box = std::nullopt;  ///< of all vertices; none: there are none
};

/// Cost: that of meshops::orient(). Throws Cancelled.
Measures measure(const MeshFile& mesh);

}  // namespace rbpa::app
