// What:   the handle operators that fill a boundary curve with a face, and that remove a face to leave a curve.
// Law:    each undoes the other; the counts change exactly as effect.h specifies.
// Source: Lewiner et al., Topological mesh operators, section on handle operators (attaching a disc).
#pragma once

#include <optional>
#include <string>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/handle/effect.h"

namespace meshops {

struct CloseCurveEffect {
  Face face{};  ///< new, with as many sides as the curve had edges
  Delta delta() const { return delta_of_close_curve(); }
};

struct OpenCurveEffect {
  Halfedge curve{};  ///< on the curve: what was the halfedge of the face
  Delta delta() const { return delta_of_open_curve(); }
};

/// Why the curve through `h` cannot be closed, or nothing when it can: no such halfedge, not on the boundary, a curve of
/// two edges, which glue() closes, or a vertex on it with several fans (core/fans.h).
/// Cost:     the degrees of the vertices on the curve.
MESHOPS_API std::optional<std::string> close_curve_blocker(const Connectivity& mesh, Halfedge h);

/// Fills the boundary curve through `h` with one face, which `h` is the halfedge of.
/// Δ:        F +1, χ +1, curves −1, others 0.
/// Requires: close_curve_blocker() is empty. Throws ContractViolation, mesh untouched.
/// Inverse:  open_curve().
/// Cost:     that of the blocker.
MESHOPS_API CloseCurveEffect close_curve(Connectivity& mesh, Halfedge h);

/// Why the face cannot be removed, or nothing when it can: no such face; a side of it on the boundary, or the face on
/// both sides of an edge, which would have no face left; a corner on the boundary, or a vertex that the face passes
/// twice, at which the rest would have two fans. remove_triangle() removes the triangles among these.
/// Cost:     the number of sides; with more than three also the degrees of the corners.
MESHOPS_API std::optional<std::string> open_curve_blocker(const Connectivity& mesh, Face f);

/// Marks a face as deleted, so that its sides are a boundary curve.
/// Δ:        F −1, χ −1, curves +1, others 0.
/// Requires: open_curve_blocker() is empty; the mesh has face status.
/// Throws:   ContractViolation, mesh untouched.
/// Inverse:  close_curve(), up to the handle of the face.
/// Cost:     that of the blocker.
MESHOPS_API OpenCurveEffect open_curve(Connectivity& mesh, Face f);

}  // namespace meshops
