// What:   the solid components of a complex while its triangles are added one after the other, each with its number of
//         vertices.
// Law:    the vertices of a component are those that it has in rbpa()'s mesh: its points, one where it touches itself once
//         for every fan.
// Cost:   linear to begin with, then practically constant per triangle.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rbpa/base/disjoint_sets.h"
#include "rbpa/plane/filtration/face_cells.h"

namespace rbpa {

class SolidParts {
 public:
  /// Faces in the order in which they are to come, of a mesh with so many vertices. Keeps a reference.
  /// Requires: a vertex for every point, as in a Delaunay triangulation.
  SolidParts(const std::vector<FaceCell>& cells, std::size_t vertices);

  /// `left(size)` is told of every component that is no longer, and `come(size)` of the one that is in its place.
  /// Requires: there is a next one.
  template <typename Left, typename Come>
  void add_next(const Left& left, const Come& come);

  std::size_t covered() const { return covered_; }  ///< points in triangles

 private:
  const std::vector<FaceCell>& cells_;
  std::vector<std::uint32_t> gaps_;      // of a vertex, its faces that are missing, and one for the boundary
  DisjointSets parts_;                   // of faces
  std::vector<std::uint32_t> vertices_;  // of a component, at the face that stands for it
  std::vector<bool> on_;                 // vertices
  std::uint32_t next_ = 0;
  std::size_t covered_ = 0;
};

template <typename Left, typename Come>
void SolidParts::add_next(const Left& left, const Come& come) {
  const FaceCell& cell = cells_[next_];
  std::uint32_t part = next_, vertices = 0;
  std::array<bool, 3> glued;
  for (unsigned side = 0; side < 3; ++side) {
    const std::uint32_t neighbour = cell.neighbours[side];
    glued[side] = neighbour < next_;  // none is the greatest number
    if (!glued[side]) continue;
    const std::uint32_t other = parts_.find(neighbour);
    if (other == part) continue;
    left(vertices_[other]);
    vertices += vertices_[other];
    part = parts_.link(part, other);
  }
  for (unsigned i = 0; i < 3; ++i) {
    const std::uint32_t corner = cell.corners[i];
    const bool before = glued[i], behind = glued[(i + 1) % 3];
    --gaps_[corner];
    // A fan begins, or two become one; unless they were one that has closed.
    if (!before && !behind) ++vertices;
    if (before && behind && gaps_[corner] > 0) --vertices;
    if (!on_[corner]) ++covered_;
    on_[corner] = true;
  }
  vertices_[part] = vertices;
  ++next_;
  come(vertices);
}

}  // namespace rbpa
