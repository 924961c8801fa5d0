// What: the faces of a mesh without the detour over halfedges. Faces come in any order, so that each is a cache miss.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rbpa/rbpa.h"

namespace rbpa {

struct FaceCell {
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  std::array<std::uint32_t, 3> corners;     ///< vertices
  std::array<std::uint32_t, 3> neighbours;  ///< faces, or none; beyond the side that ends at the corner
};

std::vector<FaceCell> face_cells(const Mesh& mesh);

/// The same, the i-th of face `order[i]`, with neighbours numbered so as well: who goes through them in this order reads
/// memory from end to end, and which of two neighbours comes first is seen from their numbers.
std::vector<FaceCell> face_cells(const Mesh& mesh, const std::vector<std::uint32_t>& order);

/// Of each vertex, how many faces are missing around it while there is none, with one for the boundary.
std::vector<std::uint32_t> gaps_of(const std::vector<FaceCell>& cells, std::size_t vertices);

}  // namespace rbpa
