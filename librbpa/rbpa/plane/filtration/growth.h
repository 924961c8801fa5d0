// What:   the counts of a complex while its triangles are added one by one.
// Law:    triangles may be added in any order; after each triangle, the counts are those of count() for the complex of
//         the added triangles. Vertices with the same point, as at a split pinch, count as one point.
// Cost:   the constructor is linear, add() practically constant, counts() constant.
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
  /// Begins with the empty complex on `vertices` vertices. Vertex v is on point point_of_vertex[v]; if that list is
  /// empty, each vertex is a point of its own. Triangles and neighbors must outlive the object.
  /// Requires: corners below `vertices`; `point_of_vertex` is empty or has an entry for each vertex.
  Growth(const TriangleArrays& arrays, std::size_t vertices, const std::vector<std::uint32_t>& point_of_vertex = {});

  /// Adds a triangle. Requires: a triangle that was not added before.
  void add(std::uint32_t triangle);

  ComplexCounts counts() const;

 private:
  void cover(std::uint32_t vertex);

  TriangleArrays arrays_;
  std::vector<std::uint32_t> first_on_point_;  // for each vertex, the first vertex on the same point; empty: the vertex
  std::vector<std::uint32_t> gaps_;            // for each vertex, its triangles not added yet, plus one at the boundary
  meshops::DisjointSets solids_;               // solid components, as sets of triangles
  meshops::DisjointSets pieces_;               // components, as sets of vertices
  std::vector<bool> in_, on_, point_on_;       // triangles added; vertices, and first vertices, in these
  ComplexCounts now_;
  std::size_t fans_ = 0;
};

}  // namespace rbpa
