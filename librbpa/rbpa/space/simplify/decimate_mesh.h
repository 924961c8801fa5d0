// What:   decimates a halfedge mesh of triangles in place, given the places of its vertices in an array.
// Law:    that of decimate() for surfaces (decimate.h). The cost and the source are stated there, too.
#pragma once

#include <vector>

#include "meshops/core/connectivity.h"
#include "meshops/stellar/count_effects.h"
#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/simplify/decimate.h"
#include "rbpa/space/simplify/quadric_policy.h"

namespace rbpa {

/// A collapse made by decimate(), and the places of the surviving vertex before and after.
struct RecordedCollapse {
  meshops::WeldEffect effect;
  Point3 before, after;
};

/// Decimates a mesh, and moves the places of its vertices. Deleted elements stay in the mesh, marked deleted, until
/// garbage_collection(). Places of deleted vertices have no meaning. Appends the collapses to `record`, unless null.
/// Requires: simplify_blocker(mesh) is empty; a sound mesh, except that vertices may have several fans; `places` has a
///           position for each vertex by index, finite if the vertex is not deleted; `options` as for surfaces;
///           `quadrics` as QuadricPolicy::QuadricPolicy().
/// Throws:   InvalidInput that names a vertex whose place is not finite, and ContractViolation when simplify_blocker()
///           has a reason, an option is out of its range, or there is not one place for each vertex: the mesh is then
///           unchanged. Cancelled: the mesh is then as after some collapse, and `places` is unchanged.
///           ContractViolation as meshops::simplify() throws it. The range of `quadrics` is checked only if there are
///           too many triangles.
RBPA_API Decimation decimate(meshops::Connectivity& mesh, std::vector<Point3>& places, const DecimationOptions& options,
                             QuadricOptions quadrics = {}, std::vector<RecordedCollapse>* record = nullptr);

}  // namespace rbpa
