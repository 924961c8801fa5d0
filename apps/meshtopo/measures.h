// What: computes area, volume and bounding box of a mesh.
// Law:  area and volume are rounded, by compensated sums; the topology decides whether there is a volume.
#pragma once

#include <array>
#include <optional>

#include "io/mesh/read_mesh.h"

namespace rbpa::app {

struct Measures {
  double area = 0;  ///< sum over all faces, of the triangles of for_each_fan_triangle()
  /// The sum of the volumes of the closed and oriented components; that of a component that faces inward is negative.
  /// Absent if there is no such component.
  std::optional<double> volume = std::nullopt;
  std::optional<std::array<std::array<double, 3>, 2>> box =
      std::nullopt;  ///< least and greatest corner; absent if there are no vertices
};

/// Measures a mesh. Cost: that of meshops::orient(). Throws Cancelled.
Measures measure(const MeshFile& mesh);

}  // namespace rbpa::app
