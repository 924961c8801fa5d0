// What: lists the corners of the faces of a tetrahedron, as seen from outside.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rbpa/base/triangle.h"

namespace rbpa::space {

/// The numbers of the corners of the face across from corner k of a positively oriented tetrahedron. The corners are
/// counter-clockwise seen from outside, and positively oriented with a point outside.
inline constexpr std::array<std::array<std::uint8_t, 3>, 4> outer_faces = {
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// Returns the corners of the face across from corner k of a tetrahedron, in the order of outer_faces.
inline Triangle outer_face(const std::array<std::uint32_t, 4>& corners, std::size_t k) {
  return {corners[outer_faces[k][0]], corners[outer_faces[k][1]], corners[outer_faces[k][2]]};
}

}  // namespace rbpa::space
