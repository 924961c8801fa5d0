// What: measures of a mesh: area, volume, bounding box.
// Law:  numbers are rounded, by compensated sums; the topology decides whether there is a volume.
#pragma once

#include <array>
#include <optional>

#include "io/mesh/read_mesh.h"

namespace rbpa::app {

struct Measures {
  double area = 0;  ///< sum over all faces, split as by for_each_fan_triangle()
  /// The sum of the volumes of the closed and oriented components, negative for one that faces inward; absent if there
  /// is no such component.
  std::optional<double> volume = std::nullopt;
  std::optional<std::array<std::array<double, 3>, 2>> box =
      std::nullopt;  ///< least and greatest corner; absent without vertices
};

/// Measures a mesh. Cost: that of meshops::orient(). Throws Cancelled.
Measures measure(const MeshFile& mesh);

}  // namespace rbpa::app
