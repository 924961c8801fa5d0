// What: the solid components of a complex, each with its number of vertices, while triangles are added one after the
//       other.
// Law:  the vertices of a component are its vertices in rbpa()'s mesh: one for each point, or one for each fan where
//       the component touches itself at a point.
// Cost: the constructor is linear, add_next() practically constant.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/plane/filtration/ordered_triangles.h"

namespace rbpa {

class SolidParts {
 public:
  /// Prepares for the triangles of a Delaunay triangulation of `points` points, in the order in which add_next() will
  /// add them. Keeps the spans.
  SolidParts(const TriangleArrays& arrays, std::size_t points)
      : arrays_(arrays),
        gaps_(gaps_of(arrays, points)),
        parts_(arrays.triangles.size()),
        vertices_(arrays.triangles.size()),
        on_(points) {}

  /// Adds the next triangle. Calls left(size) for every component that the triangle joins, then come(size) for the new
  /// component; `size` is a number of vertices.
  /// Requires: not all triangles were added.
  template <typename Left, typename Come>
  void add_next(const Left& left, const Come& come);

  std::size_t covered() const { return covered_; }  ///< points in triangles

 private:
  TriangleArrays arrays_;
  std::vector<std::uint32_t> gaps_;  // for each point, the number of its missing triangles, plus one for the boundary
  meshops::DisjointSets parts_;      // the components, as sets of triangles
  std::vector<std::uint32_t> vertices_;  // number of vertices of a component, at the triangle that represents it
  std::vector<bool> on_;                 // whether each point is in a triangle
  std::uint32_t next_ = 0;
  std::size_t covered_ = 0;
};

template <typename Left, typename Come>
void SolidParts::add_next(const Left& left, const Come& come) {
  std::uint32_t part = next_, vertices = 0;
  std::array<bool, 3> glued;  // for each corner, whether the side across from it is glued
  for (unsigned k = 0; k < 3; ++k) {
    const std::uint32_t neighbor = arrays_.neighbors[next_][k];
    glued[k] = neighbor < next_;  // `none` is the greatest number
    if (!glued[k]) continue;
    const std::uint32_t other = parts_.find(neighbor);
    if (other == part) continue;
    left(vertices_[other]);
    vertices += vertices_[other];
    part = parts_.link(part, other);
  }
  for (unsigned k = 0; k < 3; ++k) {
    const std::uint32_t corner = arrays_.triangles[next_][k];
    const bool before = glued[(k + 1) % 3], behind = glued[(k + 2) % 3];
    --gaps_[corner];
    // The triangle begins a fan at this corner, or joins two fans, or closes a single fan.
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
