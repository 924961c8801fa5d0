// What: the pivot on a halfedge of the front.
#pragma once

#include <cstdint>
#include <optional>

#include "meshops/front/front.h"

namespace rbpa {

/// The apex that a Pivot finds left of a boundary halfedge.
template <typename AnyPivot>
std::optional<std::uint32_t> pivot_on(const AnyPivot& pivot, const meshops::Front& front, meshops::Halfedge h) {
  const auto& mesh = front.mesh();
  // About half of the triangles fill a corner of the front: the neighbours on it are good guesses.
  const auto before = front.from_site(mesh.prev_halfedge_handle(h));
  const auto after = front.to_site(mesh.next_halfedge_handle(h));
  return pivot(front.from_site(h), front.to_site(h), {before, after});
}

}  // namespace rbpa
