// What:   the counts of a complex while its triangles are added one by one.
// Law:    in any order; after each triangle the counts are what count() finds on the complex of those so far. Vertices on
//         one point, as a complex has them where it is split at pinches, are one point of the space.
// Cost:   linear to begin with, then practically constant per triangle.
// Source: Delfinado, Edelsbrunner, An incremental algorithm for Betti numbers (1995); docs/filtration.md.
#pragma once

#include <cstdint>
#include <vector>

#include "rbpa/base/disjoint_sets.h"
#include "rbpa/plane/filtration/face_cells.h"
#include "rbpa/rbpa.h"
#include "rbpa/topology.h"

namespace rbpa {

class Growth {
 public:
  explicit Growth(const SolidAlphaComplex& complex);

  /// Requires: a face that was not added before.
  void add(std::uint32_t face);

  ComplexCounts counts() const;

 private:
  void cover(std::uint32_t vertex);

  std::vector<FaceCell> cells_;
  std::vector<std::uint32_t> first_on_point_;  // of a vertex, the first vertex on the same point
  std::vector<std::uint32_t> gaps_;            // of a vertex, its faces that are missing, and one for the boundary
  DisjointSets solids_;                        // of faces
  DisjointSets pieces_;                        // of vertices
  std::vector<bool> in_, on_, point_on_;       // faces, vertices, first vertices
  ComplexCounts now_;
  std::size_t fans_ = 0;
};

}  // namespace rbpa
