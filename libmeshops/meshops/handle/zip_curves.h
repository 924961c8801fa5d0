// What:   sews two boundary curves of equal length together, edge by edge.
// Law:    one glue() that joins two components or makes a handle, then one that zips for each further edge but the
//         last, then one that closes: the counts change by the sum.
// Source: Lewiner et al., Topological mesh operators, section on handle operators.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/handle/effect.h"

namespace meshops {

struct ZipCurvesEffect {
  GlueCase begins_with;  ///< join or handle
  std::size_t edges;     ///< of the seam, which runs from `first` along its curve

  Delta delta() const {
    Delta sum = delta_of(begins_with) + delta_of(GlueCase::close);
    const int zips = static_cast<int>(edges) - 2;
    sum.vertices += zips * delta_of(GlueCase::zip).vertices;
    sum.edges += zips * delta_of(GlueCase::zip).edges;
    return sum;
  }
};

/// Why the curves through `first` and `second` cannot be sewn, or nothing when they can: not boundary halfedges, one
/// curve, different lengths, an edge between vertices that would become one, or a vertex with several fans (core/fans.h).
/// Cost:     the degrees of the vertices on both curves.
MESHOPS_API std::optional<std::string> zip_curves_blocker(const Connectivity& mesh, Halfedge first, Halfedge second);

/// Glues `first` to `second`, the edge after `first` to the edge before `second`, and so on all around: two curves
/// become one closed seam of inner edges. For pieces that were built separately.
/// Effect:      the edges of the curve of `first` stay; those of the other are marked deleted, with one vertex of each
///              pair: the lower handle stays.
/// Requires:    zip_curves_blocker() is empty; the mesh has status of every kind.
/// Throws:      ContractViolation, mesh untouched.
/// Invalidates: the curve through `second`.
/// Inverse:     unglue() of the seam, from its last edge to its first.
/// Cost:        that of one glue(), plus the degrees of the vertices on both curves.
MESHOPS_API ZipCurvesEffect zip_curves(Connectivity& mesh, Halfedge first, Halfedge second);

}  // namespace meshops
