// What: holes of a halfedge mesh in space filled in place, so that nothing crosses.
// Law:  the triangles that fill_holes() of the same triangles finds (fill_holes.h). Old elements keep their handles and
//       properties; vertices at one place that a filling makes one are marked deleted but for one.
// Cost: that of fill_holes(), and linear.
#pragma once

#include <span>
#include <vector>

#include "meshops/core/connectivity.h"
#include "meshops/front/boundary_curve.h"
#include "meshops/stellar/split_hooks.h"
#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/fill_holes.h"
#include "rbpa/surface_mesh.h"

namespace rbpa {

struct FilledMesh {
  std::vector<HoleFill> holes;       ///< of each curve
  std::vector<meshops::Face> faces;  ///< that are new
};

/// Fills some of the boundary curves of a mesh; boundary_curves(mesh) has all, the outer rim of a sheet among them.
/// Requires: the mesh is sound, has status of every kind, triangles only, and a finite place of each vertex, by index;
///           no two edges join the same vertices; curves of it, none twice.
/// Throws:   as fill_holes(), mesh untouched.
RBPA_API FilledMesh fill_holes(meshops::Connectivity& mesh, std::span<const Point3> places,
                               std::span<const meshops::BoundaryCurve> curves, const SurfaceOptions& options = {});
template <meshops::HasPoints AnyMesh>
FilledMesh fill_holes(AnyMesh& mesh, std::span<const meshops::BoundaryCurve> curves,
                      const SurfaceOptions& options = {}) {
  return fill_holes(mesh, places_of(mesh), curves, options);
}

}  // namespace rbpa
