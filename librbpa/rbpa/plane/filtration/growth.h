// What:   the counts of a complex while its triangles are added one by one.
// Law:    triangles may be added in any order; after each, the counts are what count() finds on the complex so far.
//         Vertices on one point, which a mesh has where it is split at pinches, are one point of the space.
// Cost:   linear to begin with, then practically constant per triangle.
// Source: Delfinado, Edelsbrunner, An incremental algorithm for Betti numbers (1995);
//         docs/explanation/filtration_and_persistence.md, section 3.
#pragma once

#include <cstdint>
#include <vector>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/triangle_arrays.h"
#include "rbpa/plane/topology.h"

namespace rbpa {

class Growth {
 public:
  /// Prepares for triangles on `vertices` vertices. Vertex v stands on the point point_of_vertex[v], or on a point of
  /// its own if that is empty. Keeps the spans of the arrays.
  Growth(const TriangleArrays& arrays, std::size_t vertices, const std::vector<std::uint32_t>& point_of_vertex = {});

  /// Adds a triangle. Requires: it was not added before.
  void add(std::uint32_t triangle);

  ComplexCounts counts() const;

 private:
  void cover(std::uint32_t vertex);

  TriangleArrays arrays_;
  std::vector<std::uint32_t> first_on_point_;  // for each vertex, the first vertex on the same point; empty: itself
  std::vector<std::uint32_t> gaps_;  // for each vertex, the number of its missing triangles, plus one for the boundary
  meshops::DisjointSets solids_;     // sets of triangles
  meshops::DisjointSets pieces_;     // sets of vertices
  std::vector<bool> in_, on_, point_on_;  // triangles, vertices, first vertices
  ComplexCounts now_;
  std::size_t fans_ = 0;
};

}  // namespace rbpa
