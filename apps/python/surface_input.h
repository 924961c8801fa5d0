// What: the input of Python's surfaces, and the library's surface from Python's arrays.
#pragma once

#include <optional>
#include <span>

#include "python/arrays.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa::python {

using MaybeDoubles = std::optional<Doubles>;

/// The input of a surface. Without normals the surface is the exposed triangles of one radius; without radii it was not
/// made by a ball.
struct SurfaceInput {
  std::span<const Point3> points, normals;
  std::span<const double> radii;
  bool has_normals;

  SurfaceInput(const Doubles& given_points, const MaybeDoubles& given_normals, const Doubles& given_radii);
};

/// Rebuilds a surface from the arrays that surface_of() returned.
Surface surface_again(const SurfaceInput& input, const Indices& triangles, const Indices& neighbors,
                      const Indices& levels, const Indices& duplicates);

}  // namespace rbpa::python
