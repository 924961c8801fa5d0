// What: triangles as a mesh file.
// Law:  the bytes depend on the mesh alone; coordinates read back to the same doubles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "io/formats.h"
#include "io/output_file.h"
#include "rbpa/core/point.h"

namespace rbpa::app {

using Triangle = std::array<std::uint32_t, 3>;

/// Triangles as indices into vertices.
struct TriangleMesh {
  std::span<const Point> vertices;
  std::span<const Triangle> triangles;
};

/// OFF, PLY (binary little-endian, coordinates as double) or OBJ with z = 0, or the indices alone as an .npy array of
/// uint32 with shape (n, 3). Requires: not a picture format.
void write_triangles(OutputFile& file, OutputFormat format, const TriangleMesh& mesh);

/// The mesh without the vertices that no triangle uses; the others keep their order, and so do the triangles.
struct CompactMesh {
  CompactMesh(std::span<const Point> points, std::span<const Triangle> of_points);

  std::vector<Point> vertices;
  std::vector<Triangle> triangles;
};

}  // namespace rbpa::app
