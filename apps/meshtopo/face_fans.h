// What: splits the faces of a surface into triangles that are glued as the faces are.
// Why:  the library's functions for triangle surfaces then apply to faces of any number of corners.
// Cost: a sort of the sides.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "meshops/topology/repair.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa::app {

struct FaceFans {
  Surface surface = {};                ///< on the vertices of the repaired soup; one fan of triangles around each
  std::vector<Point3> points = {};     ///< position of each vertex
  std::vector<std::size_t> face = {};  ///< face of each triangle, by its number in the repaired soup

  /// Requires: `repaired` is the repair of a mesh with these positions. Throws Cancelled.
  FaceFans(const meshops::Repair& repaired, std::span<const std::array<double, 3>> positions);
};

}  // namespace rbpa::app
