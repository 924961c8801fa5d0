// What: splits the faces of a surface into triangles. Triangles are neighbors within a face, and where their faces are
//       neighbors.
// Why:  the functions of the library for triangle surfaces then apply to faces of any number of corners.
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
  Surface surface = {};                ///< triangles between vertices of the repaired soup, one fan around each vertex
  std::vector<Point3> points = {};     ///< position of each vertex
  std::vector<std::size_t> face = {};  ///< number of the face of each triangle, in the repaired soup

  /// Splits the faces of `repaired`. Requires: `repaired` is the repair of a mesh whose points have the positions
  /// `positions`. Throws Cancelled.
  FaceFans(const meshops::Repair& repaired, std::span<const std::array<double, 3>> positions);
};

}  // namespace rbpa::app
