// What: writes tetrahedra.
// Law:  the bytes depend on the tetrahedra alone; coordinates read back to the same doubles. The vertices are all
//       points, in input order.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "io/bytes/output_file.h"
#include "io/formats.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

struct SolidMesh {
  std::span<const Point3> vertices;
  std::span<const std::array<std::uint32_t, 4>> tetrahedra;
  std::span<const std::uint32_t> index = {};  ///< input index of each vertex; empty if vertex i has index i
};

/// Writes VTU with appended raw data; Medit's .mesh or Gmsh's .msh, version 2.2, both text with vertices numbered from
/// 1; or the tetrahedra as an .npy array of uint32 with shape (n, 4). Requires: a format of Use::solid, no picture.
void write_solid(OutputFile& file, Format format, const SolidMesh& mesh);

}  // namespace rbpa::app
