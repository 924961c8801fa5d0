// What: the reasons for which operators refuse, as values: the kind of the reason and the element of the mesh at fault.
// Law:  an operator with a function …_blocker() refuses exactly if that function returns a reason for the operator's
//       arguments. The message of the operator's ContractViolation begins with the operator's name and ends with
//       describe() of the reason.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/contract.h"

namespace meshops {

/// Kind of a reason. The comment of each kind names the element that `element` and `index` of its Blocker give. The
/// *first* and the *second* halfedge are the arguments of the operator, in their order.
enum class BlockerKind : std::uint8_t {
  no_status,           ///< no element: the mesh lacks the status that marks elements as deleted (request_status())
  none_given,          ///< no element: both optional halfedges are left out
  missing,             ///< an element that does not exist or is deleted
  on_boundary,         ///< an edge or vertex that must not be on the boundary
  not_on_boundary,     ///< an edge, halfedge or vertex that must be on the boundary
  isolated,            ///< a vertex without edges
  wrong_degree,        ///< a vertex whose number of edges is not `count`
  not_triangle,        ///< a face that is not a triangle
  several_fans,        ///< a vertex with several fans (core/fans.h)
  corner_repeated,     ///< a vertex that is a corner of the face twice
  face_on_both_sides,  ///< a face that lies on both sides of an edge
  same_edge,           ///< the edge to which both halfedges belong
  same_curve,          ///< the second halfedge, which is on the boundary curve of the first
  curve_length,        ///< the second halfedge, whose curve has `count` edges, unlike the curve of the first
  curve_too_short,     ///< a halfedge on a curve of two edges
  other_face,          ///< the second halfedge, which is not a side of the face of the first
  other_vertex,        ///< the second halfedge, which starts at another vertex than the first
  corners_adjacent,    ///< the second halfedge, whose start is a neighbor of the start of the first along the face
  named_twice,         ///< an edge that is named twice
  pinch,               ///< an inner edge between boundary vertices, which would become a pinch
  loop_edge,           ///< an edge that would have one vertex at both ends
  double_edge,         ///< a vertex that two edges would join to another vertex
  double_triangle,     ///< a triangle whose corners another triangle would get
  equal_halves,        ///< a quadrangle whose halves would be triangles with the same corners
  only_edge_left,      ///< an edge whose removal would leave only one edge of its component
  no_triangulation     ///< a face all of whose triangulations have an edge that is not allowed
};

/// A reason for which an operator refuses.
struct Blocker {
  /// Makes a reason without an element.
  explicit Blocker(BlockerKind why) : kind(why) {}
  /// Makes a reason with the element that the handle `concerned` names.
  template <typename Handle>
  Blocker(BlockerKind why, Handle concerned, int number = 0)
      : kind(why), element(kind_of(concerned)), index(concerned.idx()), count(number) {}

  BlockerKind kind;
  ElementKind element = ElementKind::vertex;  ///< kind of the element; meaningless without an element
  int index = -1;                             ///< index of the element; −1 without an element
  int count = 0;                              ///< number of edges, for kinds whose comment names `count`; otherwise 0
  friend bool operator==(const Blocker&, const Blocker&) = default;
};

/// Returns the name of a kind in words, for example "not triangle".
MESHOPS_API std::string_view name(BlockerKind kind);

/// Returns a text for people, without the operator's name, for example "face 7 is not a triangle".
MESHOPS_API std::string describe(const Blocker& blocker);

namespace detail {

/// Throws ContractViolation with the message "operation: " and describe(*reason) if there is a reason.
template <typename Reason>
void enforce(const char* operation, const std::optional<Reason>& reason) {
  if (reason) [[unlikely]]
    violate(operation, describe(*reason));
}

}  // namespace detail
}  // namespace meshops
