// What: decimates, remeshes or subdivides a mesh of triangles, for --decimate, --remesh and --subdivide; writes and
//       reads progressive meshes.
// Law:  that of rbpa::decimate(), rbpa::ProgressiveMesh, rbpa::remesh() and rbpa::subdivide(). The vertices left by a
//       decimation keep the order of the given mesh.
// Cost: that of meshops::build_mesh(), and of the function of the library.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "io/mesh/read_mesh.h"
#include "rbpa/space/simplify/remesh.h"
#include "rbpa/space/simplify/subdivide.h"
#include "triangulation/choices.h"

namespace rbpa::app {

struct DecimatedMesh {
  MeshFile mesh;  ///< without line numbers; one vertex for each fan of faces
  Decimation report;
  std::vector<std::byte> progressive;  ///< the bytes of the progressive mesh, if they are wanted
};

/// Decimates a copy of `mesh`, and measures the distance. Requires: `mesh` is a surface of triangles without defects
/// other than pinches. Throws Cancelled.
DecimatedMesh decimate(const MeshFile& mesh, const DecimationOptions& choice, bool progressive);

/// Reads a progressive mesh, and returns it at the greatest possible number of triangles that is at most `faces`, or at
/// its least number, with a warning. Vertices that no triangle has at this number are left out. Throws BadInput that
/// names the file and what is wrong with the bytes; Failure.
MeshFile read_progressive(const std::string& path, std::size_t faces);

struct RemeshedMesh {
  MeshFile mesh;  ///< without line numbers; vertices ascend by their positions
  Remeshing report;
};

/// Remeshes a copy of `mesh` to edges of about `length`, and measures the distance. Requires: `mesh` is a surface of
/// triangles without defects other than pinches. Throws InvalidInput if the length does not suit the mesh; Cancelled.
RemeshedMesh remesh(const MeshFile& mesh, RemeshOptions options);

/// The counts of a subdivision.
struct Subdivided {
  SubdivisionRule rule;
  unsigned times;
  std::size_t given, left;  ///< numbers of triangles before and after
};

/// Returns the name of a rule: "loop" or "sqrt3".
std::string_view name(SubdivisionRule rule);

struct SubdividedMesh {
  MeshFile mesh;  ///< without line numbers; new vertices follow
  Subdivided report;
};

/// Subdivides a copy of `mesh`. Requires: `mesh` is a surface of triangles without defects other than pinches. Throws
/// InvalidInput if there would be too many triangles; Cancelled.
SubdividedMesh subdivide(const MeshFile& mesh, SubdivisionOptions options);

/// Returns the number of faces of `mesh` that are not triangles.
std::size_t polygons_in(const MeshFile& mesh);

}  // namespace rbpa::app
