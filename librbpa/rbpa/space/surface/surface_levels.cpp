#include "rbpa/space/surface/surface_levels.h"

#include <cstdint>
#include <vector>

#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/surface/levels/add_level.h"

namespace rbpa {

Surface surface(std::span<const Point3> points, std::span<const Point3> normals, std::span<const double> radii,
                const SurfaceOptions& options) {
  space::check_radii(radii);
  Surface result = surface(points, normals, radii.front(), options);
  result.levels.assign(result.triangles.size(), 0);
  for (std::uint32_t i = 1; i < radii.size(); ++i)
    space::add_level(points, normals, i, radii[i], std::vector<std::uint8_t>(points.size(), 1), result, options);
  return result;
}

}  // namespace rbpa
