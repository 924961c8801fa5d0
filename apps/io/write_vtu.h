// What: triangles, edges and points as an unstructured grid of VTK (.vtu), for ParaView and programs of finite elements.
// Law:  coordinates are the same doubles, with z = 0.
// Source: VTK File Formats (XML), as Kitware documents them.
#pragma once

#include "io/output_file.h"
#include "io/triangle_mesh.h"

namespace rbpa::app {

/// Appended raw data, little-endian: cells are the triangles, then the edges, then the points. Of features
/// the number, as cell data `feature`, and what they have of numbers, as cell data under their own names; where a name comes
/// twice, or is `feature`, with _2 and so on behind it.
void write_vtu(OutputFile& file, const TriangleMesh& mesh);

}  // namespace rbpa::app
