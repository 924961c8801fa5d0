// What: a surface in space as a mesh file.
// Law:  the bytes depend on what is given alone; but for STL, coordinates read back to the same doubles.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "io/formats.h"
#include "io/output_file.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

/// Normals and colours: none, or one of each vertex.
struct SpaceMesh {
  std::span<const Point3> vertices;
  std::span<const std::array<std::uint32_t, 3>> triangles;
  std::span<const Point3> normals = {};
  std::span<const std::array<std::uint8_t, 3>> colors = {};
};

/// OFF, OBJ; PLY (binary little-endian) with normals as double and colours as uchar; STL (binary, single precision); or
/// the triangles as an .npy array of uint32 with shape (n, 3). Throws BadInput, before anything is written, when a
/// coordinate is too large for STL. Requires: not a picture format.
void write_surface(OutputFile& file, SurfaceFormat format, const SpaceMesh& mesh);

}  // namespace rbpa::app
