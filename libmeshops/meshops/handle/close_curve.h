// What:   the handle operators that fill a boundary curve with a face, and that remove a face so that its sides become
//         a curve.
// Law:    open_curve(close_curve(h).face) restores every live record of the mesh; each operator changes the counts by
//         exactly the delta in effect.h.
// Source: Lewiner et al., Topological mesh operators, section on handle operators (attaching a disc).
#pragma once

#include <optional>

#include "meshops/core/api.h"
#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/handle/effect.h"

namespace meshops {

struct CloseCurveEffect {
  Face face{};  ///< the new face, with as many sides as the curve had edges
  Delta delta() const { return delta_of_close_curve(); }
};

struct OpenCurveEffect {
  Halfedge curve{};  ///< a halfedge on the new curve: the former halfedge of the face
  Delta delta() const { return delta_of_open_curve(); }
};

/// Returns why the curve through `h` cannot be closed, or nothing when it can. The reasons: the halfedge does not exist
/// or is deleted, it is not on the boundary, the curve has only two edges (glue() closes it), or a vertex on the curve
/// has several fans (core/fans.h).
/// Cost:     the sum of the degrees of the vertices on the curve.
MESHOPS_API std::optional<Blocker> close_curve_blocker(const Connectivity& mesh, Halfedge h);

/// Fills the boundary curve through `h` with a new face, whose halfedge is `h` with default properties.
/// Δ:        F +1, χ +1, curves −1, others 0.
/// Requires: close_curve_blocker() is empty. Throws ContractViolation; the mesh is then unchanged.
/// Inverse:  open_curve() of the face.
/// Cost:     the sum of the degrees of the vertices on the curve.
MESHOPS_API CloseCurveEffect close_curve(Connectivity& mesh, Halfedge h);

/// Returns why the face cannot be removed, or nothing when it can. The reasons: the mesh has no face status; the face
/// does not exist or is deleted; a side or a corner of the face is on the boundary (for a triangle, use
/// remove_triangle()); the face is on both sides of an edge, which would then have no face; or the face has a vertex as
/// a corner twice, where the remaining faces would form two fans.
/// Cost:     the number of sides; for more than three sides, also the degrees of the corners.
MESHOPS_API std::optional<Blocker> open_curve_blocker(const Connectivity& mesh, Face f);

/// Marks a face as deleted, so that its sides become a boundary curve. Edges and vertices keep their handles.
/// Δ:        F −1, χ −1, curves +1, others 0.
/// Requires: open_curve_blocker() is empty.
/// Throws:   ContractViolation; the mesh is then unchanged.
/// Inverse:  close_curve(curve), except that the face gets a new handle and that the halfedge of a corner may differ.
/// Cost:     the number of sides; for more than three sides, also the degrees of the corners.
MESHOPS_API OpenCurveEffect open_curve(Connectivity& mesh, Face f);

}  // namespace meshops
