// What: bounds the distance of a mesh from given triangles, and connects its elements with arrays.
// Law:  conservative: no point of the mesh is farther than the bound.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshops/core/connectivity.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"
#include "rbpa/space/simplify/distance/surface_distance.h"

namespace rbpa::space {

/// Returns the index of an element as an index into arrays.
template <typename Handle>
std::size_t index_of(Handle h) {
  return static_cast<std::size_t>(h.idx());
}

/// Throws ContractViolation unless there is one place for each vertex. Throws InvalidInput that names a vertex if the
/// vertex is not marked deleted and its place is not finite. Messages begin with `operation`.
void require_places(const char* operation, const meshops::Connectivity& mesh, const std::vector<Point3>& places);

/// Returns the vertices of each triangle of a mesh. Requires: a mesh of triangles.
std::vector<std::array<std::uint32_t, 3>> corners_of(const meshops::Connectivity& mesh);

/// Returns a distance from the given triangles that no point of the mesh exceeds. Throws: Cancelled.
double distance_of(const meshops::Connectivity& mesh, const std::vector<Point3>& places, const SurfaceDistance& given,
                   const GoOn& go_on);
/// Returns such a distance for triangles whose corners are numbers of places.
double distance_of(const std::vector<std::array<std::uint32_t, 3>>& triangles, const std::vector<Point3>& places,
                   const SurfaceDistance& given, const GoOn& go_on);

}  // namespace rbpa::space
