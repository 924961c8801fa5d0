#include "python/surface_input.h"

#include <cstring>

namespace rbpa::python {
namespace {

std::span<const double> numbers_of(const Doubles& array) {
  require_shape(array.ndim() == 1, array, "radii", "(k,)");
  return {array.data(), static_cast<std::size_t>(array.shape(0))};
}

}  // namespace

SurfaceInput::SurfaceInput(const Doubles& given_points, const MaybeDoubles& given_normals, const Doubles& given_radii)
    : points(points3_of(given_points, "points")),
      normals(given_normals ? points3_of(*given_normals, "normals") : std::span<const Point3>()),
      radii(numbers_of(given_radii)),
      has_normals(given_normals.has_value()) {
  if (!has_normals && radii.size() > 1)
    throw py::value_error("radii: found " + std::to_string(radii.size()) + ", expected one for points without normals");
}

Surface surface_again(const SurfaceInput& input, const Indices& triangles, const Indices& neighbors,
                      const Indices& levels, const Indices& duplicates) {
  Surface made;
  const auto corners = triples_of(triangles, "triangles"), others = triples_of(neighbors, "neighbors");
  if (others.size() != corners.size() || levels.ndim() != 1 ||
      static_cast<std::size_t>(levels.shape(0)) != corners.size())
    throw py::value_error("triangles, neighbors, levels: found arrays of lengths " + std::to_string(corners.size()) +
                          ", " + std::to_string(others.size()) + ", " + std::to_string(levels.size()) +
                          ", expected equal ones");
  require_rows(duplicates, "duplicates", 2);
  made.triangles.assign(corners.begin(), corners.end());
  made.neighbors.assign(others.begin(), others.end());
  if (input.radii.size() > 1) {
    made.levels.resize(corners.size());
    if (!made.levels.empty())
      std::memcpy(made.levels.data(), levels.data(), made.levels.size() * sizeof(made.levels[0]));
  }
  made.duplicates.resize(static_cast<std::size_t>(duplicates.shape(0)));
  static_assert(sizeof(Duplicate) == 2 * sizeof(std::int32_t));
  if (!made.duplicates.empty())
    std::memcpy(made.duplicates.data(), duplicates.data(), made.duplicates.size() * sizeof(Duplicate));
  made.distinct = input.points.size() - made.duplicates.size();
  return made;
}

}  // namespace rbpa::python
