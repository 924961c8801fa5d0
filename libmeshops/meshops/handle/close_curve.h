// What:   the handle operators that fill a boundary curve with a face, and that remove a face so that its sides become
//         a curve.
// Law:    open_curve(close_curve(h).face) restores every live record of the mesh; the counts change exactly as effect.h
//         specifies.
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

/// Returns why the curve through `h` cannot be closed, or nothing when it can. The reasons: the halfedge does not
/// exist or is deleted, it is not on the boundary, the curve has two edges (use glue()), or a vertex on the curve has
/// several fans (core/fans.h).
/// Cost:     the degrees of the vertices on the curve.
MESHOPS_API std::optional<Blocker> close_curve_blocker(const Connectivity& mesh, Halfedge h);

/// Fills the boundary curve through `h` with one face, whose halfedge is `h` and whose properties have default values.
/// Δ:        F +1, χ +1, curves −1, others 0.
/// Requires: close_curve_blocker() is empty. Throws ContractViolation; the mesh is then unchanged.
/// Inverse:  open_curve() of the face.
/// Cost:     the degrees of the vertices on the curve.
MESHOPS_API CloseCurveEffect close_curve(Connectivity& mesh, Halfedge h);

/// Returns why the face cannot be removed, or nothing when it can. The reasons: the mesh has no face status; there is
/// no such face; a side of the face is on the boundary, or the face is on both sides of an edge, so that the edge would
/// have no face left; a corner is on the boundary, or the face passes a vertex twice, so that the remaining faces at
/// that vertex would form two fans. For a triangle with a side or a corner on the boundary, use remove_triangle().
/// Cost:     the number of sides; with more than three also the degrees of the corners.
MESHOPS_API std::optional<Blocker> open_curve_blocker(const Connectivity& mesh, Face f);

/// Marks a face as deleted, so that its sides become a boundary curve. Edges and vertices keep their handles.
/// Δ:        F −1, χ −1, curves +1, others 0.
/// Requires: open_curve_blocker() is empty; the mesh has face status.
/// Throws:   ContractViolation; the mesh is then unchanged.
/// Inverse:  close_curve(curve), except that the face is a new one and that a corner may refer to another halfedge.
/// Cost:     the number of sides; with more than three also the degrees of the corners.
MESHOPS_API OpenCurveEffect open_curve(Connectivity& mesh, Face f);

}  // namespace meshops
