// What: what Python's surfaces are made of, and a surface as the library had it.
#pragma once

#include <optional>
#include <span>

#include "python/arrays.h"
#include "rbpa/surface.h"

namespace rbpa::python {

using MaybeDoubles = std::optional<Doubles>;

/// Without normals a surface is the exposed triangles of one radius; without radii no ball made it.
struct SurfaceInput {
  std::span<const Point3> points, normals;
  std::span<const double> radii;
  bool has_normals;

  SurfaceInput(const Doubles& given_points, const MaybeDoubles& given_normals, const Doubles& given_radii);
};

/// Of what surface_of() gave.
Surface surface_again(const SurfaceInput& input, const Indices& triangles, const Indices& neighbors,
                      const Indices& levels, const Indices& duplicates);

}  // namespace rbpa::python
