// What:   the counts of a complex while its triangles are added one by one.
// Law:    in any order; after each triangle the counts are what count() finds on the complex of those so far. Vertices on
//         one point, as a mesh has them where it is split at pinches, are one point of the space.
// Cost:   linear to begin with, then practically constant per triangle.
// Source: Delfinado, Edelsbrunner, An incremental algorithm for Betti numbers (1995); docs/filtration.md.
#pragma once

#include <cstdint>
#include <vector>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/triangle_arrays.h"
#include "rbpa/topology.h"

namespace rbpa {

class Growth {
 public:
  /// Triangles on so many vertices, vertex v on the point point_of_vertex[v], or on a point of its own where that is empty.
  /// Keeps the spans of the arrays.
  Growth(const TriangleArrays& arrays, std::size_t vertices, const std::vector<std::uint32_t>& point_of_vertex = {});

  /// Requires: a triangle that was not added before.
  void add(std::uint32_t triangle);

  ComplexCounts counts() const;

 private:
  void cover(std::uint32_t vertex);

  TriangleArrays arrays_;
  std::vector<std::uint32_t> first_on_point_;  // of a vertex, the first vertex on the same point; empty: itself
  std::vector<std::uint32_t> gaps_;            // of a vertex, its triangles that are missing, and one for the boundary
  meshops::DisjointSets solids_;               // of triangles
  meshops::DisjointSets pieces_;               // of vertices
  std::vector<bool> in_, on_, point_on_;       // triangles, vertices, first vertices
  ComplexCounts now_;
  std::size_t fans_ = 0;
};

}  // namespace rbpa
