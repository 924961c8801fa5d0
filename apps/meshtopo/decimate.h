// What: decimates a mesh of triangles, for --decimate.
// Law:  that of rbpa::decimate(). The vertices of the result that are left are in the order of the given mesh.
// Cost: that of meshops::build_mesh() and of rbpa::decimate().
#pragma once

#include <cstddef>

#include "io/mesh/read_mesh.h"
#include "triangulation/decimation_choice.h"

namespace rbpa::app {

struct DecimatedMesh {
  MeshFile mesh;  ///< without line numbers; a vertex for each fan of faces
  Decimation report;
};

/// Decimates a copy of `mesh`. Requires: `mesh` is a surface of triangles without defects other than pinches. Throws
/// Cancelled.
DecimatedMesh decimate(const MeshFile& mesh, const DecimationOptions& choice);

/// Returns the number of faces of `mesh` that are not triangles.
std::size_t polygons_in(const MeshFile& mesh);

}  // namespace rbpa::app
