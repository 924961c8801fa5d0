// What: the reasons for which operators refuse, as values: what is wrong, and with which element of the mesh.
// Law:  an operator that has a function …_blocker() refuses exactly if that function returns a reason for the same
//       arguments. The message of its ContractViolation begins with the operator's name and ends with describe() of
//       the reason.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/contract.h"

namespace meshops {

/// Kind of a reason. The comment names the element that a blocker of the kind has in `element` and `index`. The first
/// and the second halfedge are those of the operator's arguments.
enum class BlockerKind : std::uint8_t {
  no_status,           ///< no element: the mesh needs status to mark what is deleted (request_status())
  none_given,          ///< no element: neither of two optional halfedges is given
  missing,             ///< an element that does not exist or is deleted
  on_boundary,         ///< an edge or vertex that must not be on the boundary
  not_on_boundary,     ///< an edge, halfedge or vertex that must be on the boundary
  isolated,            ///< a vertex without edges
  wrong_degree,        ///< a vertex that does not have `count` edges
  not_triangle,        ///< a face that is not a triangle
  several_fans,        ///< a vertex with several fans (core/fans.h)
  corner_repeated,     ///< a vertex that is a corner of the face twice
  face_on_both_sides,  ///< a face that lies on both sides of an edge
  same_edge,           ///< the edge to which both halfedges belong
  same_curve,          ///< the second halfedge, which is on the boundary curve of the first
  curve_length,        ///< the second halfedge: its curve has `count` edges, that of the first another number
  curve_too_short,     ///< a halfedge on a curve of two edges
  other_face,          ///< the second halfedge, which is not a side of the face of the first
  other_vertex,        ///< the second halfedge, which leaves another vertex than the first
  corners_adjacent,    ///< the second halfedge, which starts at a neighbor of the corner of the first
  named_twice,         ///< an edge that is named twice
  pinch,               ///< an inner edge between boundary vertices, which would become a pinch
  loop_edge,           ///< an edge that would have one vertex at both ends
  double_edge,         ///< a vertex that two edges would join to one other vertex
  double_triangle,     ///< a triangle whose corners another would get
  equal_halves,        ///< a quadrangle whose halves would be triangles with the same corners
  only_edge_left,      ///< an edge whose removal would leave only one edge of its component
  no_triangulation     ///< a face of which every triangulation has an edge that is not allowed
};

/// A reason for which an operator refuses.
struct Blocker {
  /// Makes a reason that concerns no element.
  explicit Blocker(BlockerKind why) : kind(why) {}
  /// Makes a reason that concerns the element of a handle.
  template <typename Handle>
  Blocker(BlockerKind why, Handle concerned, int number = 0)
      : kind(why), element(kind_of(concerned)), index(concerned.idx()), count(number) {}

  BlockerKind kind;
  ElementKind element = ElementKind::vertex;  ///< kind of the element; meaningless when there is none
  int index = -1;                             ///< index of the element; −1 when there is none
  int count = 0;                              ///< number of edges, for a kind whose comment names `count`; otherwise 0
  friend bool operator==(const Blocker&, const Blocker&) = default;
};

/// Returns the name of a kind in words: "not triangle".
MESHOPS_API std::string_view name(BlockerKind kind);

/// Returns a text for people, without the operator: "face 7 is not a triangle".
MESHOPS_API std::string describe(const Blocker& blocker);

namespace detail {

/// Throws ContractViolation with the message "operation: " and describe(*reason), unless there is no reason.
template <typename Reason>
void enforce(const char* operation, const std::optional<Reason>& reason) {
  if (reason) [[unlikely]]
    violate(operation, describe(*reason));
}

}  // namespace detail
}  // namespace meshops
