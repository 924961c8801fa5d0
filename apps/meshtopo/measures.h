// What: computes the area, the volume and the bounding box of a mesh.
// Law:  area and volume are rounded, by compensated sums. The topology decides whether a component has a volume.
#pragma once

#include <array>
#include <optional>

#include "io/mesh/read_mesh.h"

namespace rbpa::app {

struct Measures {
  double area = 0;  ///< sum over all faces, of the areas of the triangles of for_each_fan_triangle()
  /// The sum of the volumes of all closed and oriented components; the volume of a component that faces inward is
  /// negative. Nullopt if no component is closed and oriented.
  std::optional<double> volume = std::nullopt;
  std::optional<std::array<std::array<double, 3>, 2>> box =
      std::nullopt;  ///< least and greatest corner; nullopt if there are no vertices
};

/// Returns the measures of a mesh. Cost: that of meshops::orient(). Throws Cancelled.
Measures measure(const MeshFile& mesh);

}  // namespace rbpa::app
