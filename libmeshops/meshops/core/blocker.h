// What: the reasons for which operators refuse, as values: what is wrong, and which element of the mesh it concerns.
// Law:  an operator refuses exactly if its …_blocker() returns a reason for the same arguments; the message of its
//       ContractViolation is "operator: " and describe() of the reason.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/contract.h"

namespace meshops {

/// Kind of a reason; the comment names the element that it concerns, as `element` and `index` of the blocker.
enum class BlockerKind : std::uint8_t {
  no_status,           ///< no element: the mesh needs status to mark what is deleted (request_status())
  none_given,          ///< no element: both halfedges are left out
  missing,             ///< an element that does not exist or is deleted
  on_boundary,         ///< an edge or vertex that must not be on the boundary
  not_on_boundary,     ///< an edge, halfedge or vertex that must be on the boundary
  isolated,            ///< a vertex without edges
  wrong_degree,        ///< a vertex that does not have `count` edges
  not_triangle,        ///< a face
  several_fans,        ///< a vertex (core/fans.h)
  corner_repeated,     ///< a vertex that is a corner of the face twice
  face_on_both_sides,  ///< a face that lies on both sides of an edge
  same_edge,           ///< the edge of both halfedges
  same_curve,          ///< a halfedge on the boundary curve of the other
  curve_length,        ///< a halfedge on a curve of `count` edges; the other curve has another number
  curve_too_short,     ///< a halfedge on a curve of two edges
  other_face,          ///< a halfedge that is not a side of the face of the other
  other_vertex,        ///< a halfedge that leaves another vertex than the other
  corners_adjacent,    ///< a halfedge that starts at a neighbor of the other corner
  named_twice,         ///< an edge that is named twice
  pinch,               ///< an inner edge between boundary vertices, which would become a pinch
  loop_edge,           ///< an edge that would have one vertex at both ends
  double_edge,         ///< a vertex that two edges would join to the same other vertex
  double_triangle,     ///< a triangle that would get the corners of another
  only_edge_left,      ///< an edge without which only an edge would be left of its component
  no_triangulation     ///< a face of which every triangulation has an edge that is not allowed
};

struct Blocker {
  /// Makes a reason that concerns no element.
  explicit Blocker(BlockerKind why) : kind(why) {}
  template <typename Handle>
  Blocker(BlockerKind why, Handle concerned, int number = 0)
      : kind(why), element(kind_of(concerned)), index(concerned.idx()), count(number) {}

  BlockerKind kind;
  ElementKind element = ElementKind::vertex;  ///< kind of the element; meaningless when there is none
  int index = -1;                             ///< index of the element; −1 when there is none
  int count = 0;                              ///< the number of edges that the kind names
  friend bool operator==(const Blocker&, const Blocker&) = default;
};

MESHOPS_API std::string_view name(BlockerKind kind);

/// Returns a text for people: "face 7 is not a triangle".
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
