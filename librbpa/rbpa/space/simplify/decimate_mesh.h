// What:   decimates a halfedge mesh of triangles in place, with the places of its vertices in an array.
// Law:    that of decimate() for surfaces (decimate.h), whose cost and source apply too.
#pragma once

#include <vector>

#include "meshops/core/connectivity.h"
#include "meshops/stellar/count_effects.h"
#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/simplify/decimate.h"
#include "rbpa/space/simplify/quadric_policy.h"

namespace rbpa {

/// A collapse of decimate(), and the places of its surviving vertex.
struct RecordedCollapse {
  meshops::WeldEffect effect;
  Point3 before, after;
};

/// Decimates a mesh, and moves the places of its vertices. Deleted elements stay in the mesh, marked deleted, until
/// garbage_collection(); places of deleted vertices have no meaning. Appends the collapses to `record`, if it is given.
/// Requires: simplify_blocker(mesh) is empty; a sound mesh, except that vertices may have several fans; `places` has a
///           position for each vertex by index, finite if the vertex is not deleted.
/// Throws:   InvalidInput that names a vertex whose place is not finite, and ContractViolation unless there is one
///           place for each vertex, with the mesh untouched; Cancelled, with the mesh as after the last collapse and
///           `places` untouched; ContractViolation as meshops::simplify().
RBPA_API Decimation decimate(meshops::Connectivity& mesh, std::vector<Point3>& places, const DecimationOptions& options,
                             QuadricOptions quadrics = {}, std::vector<RecordedCollapse>* record = nullptr);

}  // namespace rbpa
