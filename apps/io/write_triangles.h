// What: triangles as a mesh file.
// Law:  the bytes depend on the mesh alone; coordinates read back to the same doubles.
#pragma once

#include "io/formats.h"
#include "io/output_file.h"
#include "io/triangle_mesh.h"

namespace rbpa::app {

/// OFF, PLY (binary little-endian, coordinates as double) or OBJ with z = 0, or indices alone as an .npy array of uint32:
/// triangles with shape (n, 3), edges with shape (n, 2) or points with shape (n); or VTU (write_vtu.h). PLY has the feature of each triangle, where there are
/// features, as a property of faces. OBJ, as lines f, l
/// and p, and VTU have all three; OFF and PLY leave edges and points out. Requires: not a picture format.
void write_triangles(OutputFile& file, OutputFormat format, const TriangleMesh& mesh);

}  // namespace rbpa::app
