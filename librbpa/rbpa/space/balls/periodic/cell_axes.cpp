#include "rbpa/space/balls/periodic/cell_axes.h"

#include <limits>
#include <string>

#include "rbpa/base/error.h"

namespace rbpa::space {

CellAxes::CellAxes(const RepeatingCell& cell) {
  const auto& [a, b, c] = cell.edges;
  for (const Point3& edge : cell.edges)
    if (!is_finite(edge)) throw InvalidInput("found edges of a cell that are not finite, expected finite ones");
  const std::array<Vector3<double>, 3> e = {Vector3<double>{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}};
  for (std::size_t k = 0; k < 3; ++k) {
    normals_[k] = cross(e[(k + 1) % 3], e[(k + 2) % 3]);
    const double volume = dot(normals_[k], e[k]);
    const double size = norm(normals_[k]) * norm(e[k]);
    if (!(std::abs(volume) > 0x1p-40 * size && size < std::numeric_limits<double>::infinity()))
      throw InvalidInput(
          "found a cell without a volume, or with one beyond the range of double, expected three edges in different "
          "directions");
    normals_[k] = {normals_[k].x / volume, normals_[k].y / volume, normals_[k].z / volume};
  }
}

std::int32_t CellAxes::whole(double along, std::size_t i) {
  if (!(std::abs(along) < 0x1p30))
    throw InvalidInput("center " + std::to_string(i) + " is too many cells away, expected fewer than 2^30");
  // Balls that are equal modulo the cell come to the same face of it, whatever rounding does.
  constexpr double near_face = 0x1.7p-31;  // distance from a face, in edges, within which a ball belongs to the face
  return static_cast<std::int32_t>(std::floor(along + near_face));
}

}  // namespace rbpa::space
