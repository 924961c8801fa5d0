// What: checks whether a mesh is an oriented 2-manifold with boundary whose records agree with each other, and lists
//       the defects.
// Law:  a mesh is sound, and the list empty, exactly if the records agree, every edge has two different ends and a face
//       on one or both of its sides, every face is one loop of three sides or more, and the faces around every vertex
//       form one path or one circle. Every operator of libmeshops keeps a sound mesh sound, whatever the arguments are,
//       unless the operator's comment says "not checked".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"

namespace meshops {

/// Kind of a defect. Of a halfedge h, next(h) and prev(h) are its neighbors in the loop around a face or along a curve.
enum class DefectKind {
  handle_out_of_range,        ///< a record names an element that does not exist or is deleted
  next_and_prev_disagree,     ///< next(h) = g but prev(g) ≠ h, or the reverse
  halfedges_do_not_meet,      ///< next(h) does not start where h ends
  face_changes_along_loop,    ///< h and next(h) belong to different faces
  face_halfedge_elsewhere,    ///< the halfedge of a face belongs to another face, or to none
  face_too_short,             ///< a face has fewer than three sides
  loop_does_not_close,        ///< following next from the halfedge of a face never returns to that halfedge
  face_has_several_loops,     ///< a halfedge belongs to a face but is not on the loop of the face's halfedge
  loop_edge,                  ///< an edge has one vertex at both ends
  dangling_edge,              ///< an edge has no face on either side
  vertex_halfedge_elsewhere,  ///< the halfedge of a vertex starts elsewhere, or is missing although some start there
  vertex_halfedge_inner,      ///< the halfedge of a boundary vertex is inner; OpenMesh wants a boundary halfedge
  /// The faces at a vertex do not form one fan, so that the mesh is not a manifold there. They are in several rings, or
  /// in one ring that passes several gaps, as OpenMesh's add_face() links them (a bowtie).
  vertex_has_several_fans
};

/// One defect of a mesh, at one of its elements.
struct Defect {
  DefectKind kind;
  ElementKind element;  ///< vertex, halfedge or face
  int index;            ///< index of that element; for an edge with a defect, of the first halfedge of the edge
  friend bool operator==(const Defect&, const Defect&) = default;
};

/// Returns the name of a kind in words: "vertex has several fans".
MESHOPS_API std::string_view name(DefectKind kind);

/// Returns a text for people: "vertex 17: vertex has several fans".
MESHOPS_API std::string describe(const Defect& defect);

/// Returns the defects of the mesh: those of vertices first, then of halfedges, then of faces, each in ascending order
/// of indices; an empty list when the mesh is sound. Isolated vertices are no defects. Elements marked deleted are
/// skipped. If there is a handle_out_of_range, only such defects are listed: the rest cannot be checked safely.
/// Cost: linear in the size of the mesh, plus the sorting of the defects.
MESHOPS_API std::vector<Defect> validate(const Connectivity& mesh);

}  // namespace meshops
