// What: finds pairs of equal faces, and links the two tetrahedra of each pair.
// How:  sorts the faces into buckets by their first corner.
// Cost: linear in the number of faces and in `bound`, if few faces have the same first corner; quadratic in the number
//       of faces with the same first corner.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/sort/canonical_rows.h"
#include "rbpa/space/predicate/outer_faces.h"

namespace rbpa::space {

struct BorderFace {
  std::array<std::uint32_t, 3> corners;  ///< the three corners, ascending
  std::uint32_t face;                    ///< 4 · (number of the tetrahedron) + (corner across)
};

/// Returns the face across from corner k of the tetrahedron with this number and these corners.
inline BorderFace border_face(const Row& corners, std::uint32_t tetrahedron, std::size_t k) {
  std::array<std::uint32_t, 3> face = {corners[(k + 1) % 4], corners[(k + 2) % 4], corners[(k + 3) % 4]};
  if (face[0] > face[1]) std::swap(face[0], face[1]);
  if (face[1] > face[2]) std::swap(face[1], face[2]);
  if (face[0] > face[1]) std::swap(face[0], face[1]);
  return {face, 4 * tetrahedron + static_cast<std::uint32_t>(k)};
}

/// Returns whether the corners of the face across from corner k, in ascending order, are counter-clockwise seen from
/// outside of the tetrahedron. Requires: `corners` are positively oriented.
inline bool is_ascending_outside(const Row& corners, std::size_t k) {
  const auto& outer = outer_faces[k];
  const std::uint32_t a = corners[outer[0]], b = corners[outer[1]], c = corners[outer[2]];
  return ((a < b) + (b < c) + (c < a)) == 2;
}

/// Links the two tetrahedra of each face that occurs twice in `faces` as neighbors of each other. Other entries of
/// `neighbors` do not change. Requires: all corners of `faces` are below `bound`; no face occurs three times;
/// `neighbors` has a row for each tetrahedron.
void link_border_faces(std::span<const BorderFace> faces, std::size_t bound, meshops::FreshVector<Row>& neighbors);

}  // namespace rbpa::space
