// What: checks whether a mesh is an oriented 2-manifold with boundary whose records agree with each other, and lists
//       the defects.
// Law:  a mesh is sound, and the list is empty, exactly if the records agree, every edge has two different ends and a
//       face on at least one side, every face is one loop of three or more sides, and the faces around every vertex
//       form one path or one circle. Every operator of libmeshops keeps a sound mesh sound for all arguments, unless
//       the operator's comment says "not checked". A record is the links of one element, live unless the element is
//       marked deleted.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"

namespace meshops {

/// Kind of a defect. next(h) and prev(h) are the neighbors of a halfedge h in the loop around a face or along a curve.
enum class DefectKind {
  handle_out_of_range,        ///< a record names an element that does not exist or is deleted
  next_and_prev_disagree,     ///< next(h) = g but prev(g) ≠ h, or prev(h) = g but next(g) ≠ h
  halfedges_do_not_meet,      ///< next(h) does not start where h ends
  face_changes_along_loop,    ///< h and next(h) belong to different faces
  face_halfedge_elsewhere,    ///< the halfedge of a face belongs to another face or to no face
  face_too_short,             ///< a face has fewer than three sides
  loop_does_not_close,        ///< the walk along next() from the halfedge of a face never returns to that halfedge
  face_has_several_loops,     ///< a halfedge of a face is not on the loop of the face's own halfedge
  loop_edge,                  ///< an edge has one vertex at both ends
  dangling_edge,              ///< an edge has no face on either side
  vertex_halfedge_elsewhere,  ///< the halfedge of a vertex starts elsewhere, or is missing although halfedges leave it
  vertex_halfedge_inner,      ///< the halfedge of a boundary vertex is inner, contrary to OpenMesh's convention
  /// The faces at a vertex form several fans: the mesh is not a manifold there. The halfedges that leave the vertex
  /// form several rings, or one ring with several gaps, as OpenMesh's add_face() links them (a bowtie).
  vertex_has_several_fans
};

/// Defect of a mesh, at one of its elements.
struct Defect {
  DefectKind kind;
  ElementKind element;  ///< kind of the element: vertex, halfedge or face
  int index;            ///< index of the element; for a defect of an edge, the index of the first halfedge of the edge
  friend bool operator==(const Defect&, const Defect&) = default;
};

/// Returns the name of a kind in words, for example "vertex has several fans".
MESHOPS_API std::string_view name(DefectKind kind);

/// Returns a text for people, for example "vertex 17: vertex has several fans".
MESHOPS_API std::string describe(const Defect& defect);

/// Returns the defects of the mesh: first the defects of vertices, then of halfedges, then of faces, each in ascending
/// order of indices. The list of a sound mesh is empty. Isolated vertices are no defects. Elements marked deleted are
/// skipped. If there is a handle_out_of_range, only defects of that kind are listed, because other checks are unsafe.
/// Cost: linear in the size of the mesh, plus the sorting of the defects.
MESHOPS_API std::vector<Defect> validate(const Connectivity& mesh);

}  // namespace meshops
