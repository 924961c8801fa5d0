// What: the faces of a surface as triangles, glued as the faces are.
// Why:  what the library knows about surfaces of triangles then holds for faces of any number of corners.
// Cost: a sort of the sides.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "meshops/topology/repair.h"
#include "rbpa/base/point3.h"
#include "rbpa/surface.h"

namespace rbpa::app {

struct FaceFans {
  Surface surface = {};                ///< of vertices of the repaired soup; one fan of triangles around each
  std::vector<Point3> points = {};     ///< of each vertex
  std::vector<std::size_t> face = {};  ///< of each triangle, by number in the repaired soup

  /// Requires: the repair of a mesh with these positions. Throws Cancelled.
  FaceFans(const meshops::Repair& repaired, std::span<const std::array<double, 3>> positions);
};

}  // namespace rbpa::app
