// What: extracts the part of a surface near some of its points, and numbers the points of the part anew.
// Law:  the part has all triangles at the wanted points, glued as in the whole.
// Cost: linear in the surface once; then linear in the part, times a logarithm.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/arrays/simplices_at.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa::space {

struct LocalSurface {
  std::vector<std::uint32_t> input;  ///< input index of each point, ascending
  std::vector<Point3> points, normals;
  Surface surface;  ///< the part; corners are positions in `points`; with levels

  /// Returns the number that an input point has in the part. Requires: the point is in the part.
  std::uint32_t number_of(std::uint32_t input_index) const;
};

class LocalSurfaces {
 public:
  /// Keeps the spans, and a reference to `surface`. Requires: a normal for each point; corners are indices of `points`.
  LocalSurfaces(std::span<const Point3> points, std::span<const Point3> normals, const Surface& surface);

  /// Returns the part around `points`: the points, the triangles with a corner among the points, and the other corners
  /// of the triangles. Requires: ascending indices; of equal points, all or none.
  LocalSurface at(std::span<const std::uint32_t> points) const;

  const std::array<std::uint32_t, 3>& corners_of(std::uint32_t triangle) const { return surface_.triangles[triangle]; }

 private:
  std::span<const Point3> points_, normals_;
  const Surface& surface_;
  TrianglesAt triangles_at_;
};

}  // namespace rbpa::space
