// What: fills holes of a halfedge mesh in space, in place; no new triangle crosses another.
// Law:  the new triangles are those of fill_holes() of the mesh's triangles (fill_holes.h). Old elements keep their
//       handles and properties, except where a filling merges vertices at one place: all these vertices but the lowest,
//       and one of two edges that become one, are marked deleted. The mesh may have additional vertices afterwards, all
//       marked deleted.
// Cost: that of fill_holes(), and a sort of the boundary edges.
#pragma once

#include <span>
#include <vector>

#include "meshops/core/connectivity.h"
#include "meshops/front/boundary_curve.h"
#include "meshops/stellar/split_hooks.h"
#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/repair/fill_holes.h"
#include "rbpa/space/surface/surface_mesh.h"

namespace rbpa {

struct FilledMesh {
  std::vector<HoleFill> holes;       ///< the outcome for each given curve
  std::vector<meshops::Face> faces;  ///< the new faces, in the order of HoleFilling::triangles
};

/// Fills the given boundary curves of a mesh. boundary_curves(mesh) returns all, with the outer rim of a sheet.
/// Requires: a sound mesh of triangles, with status of every kind (meshops::request_status()), in which no two edges
///           join the same vertices; `places` has a finite position for each vertex, by index, deleted ones included;
///           `curves` are of this mesh, none twice.
/// Throws:   what fill_holes() of loops throws; ContractViolation when a face is not a triangle, places or status are
///           missing, or a curve is not of this mesh or given twice. If it throws, the mesh is unchanged.
RBPA_API FilledMesh fill_holes(meshops::Connectivity& mesh, std::span<const Point3> places,
                               std::span<const meshops::BoundaryCurve> curves, const SurfaceOptions& options = {});
/// Fills the given boundary curves of a mesh whose vertices have positions, as above, with `places` = places_of(mesh).
template <meshops::HasPoints AnyMesh>
FilledMesh fill_holes(AnyMesh& mesh, std::span<const meshops::BoundaryCurve> curves,
                      const SurfaceOptions& options = {}) {
  return fill_holes(mesh, places_of(mesh), curves, options);
}

}  // namespace rbpa
