// What: the triangles of a mesh in space while its edges collapse; tells whether a collapse would make some cross.
// Law:  exact; triangles cross as in crossing_triangles(): if none did before, and no collapse was made that would make
//       some cross, none does.
// How:  a tree of the boxes of all triangles, in which boxes are replaced; it is built anew when half of the triangles
//       are gone. The triangles around the vertex that moves have a corner in common: two of them cross only if the
//       side across from that corner, of one of them, meets the other one.
// Cost: for each triangle that moves a search in the tree, and an exact test for each triangle near it; about 90 bytes
//       for each triangle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/connectivity.h"
#include "meshops/stellar/count_effects.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/cells/box_tree.h"
#include "rbpa/space/predicate/crossing.h"

namespace rbpa::space {

class LiveTriangles {
 public:
  /// Requires: a mesh of triangles, with a finite place for each vertex of a face. Throws: ContractViolation that names
  /// a vertex whose place is not finite.
  LiveTriangles(const meshops::Connectivity& mesh, std::span<const Point3> places);

  /// Returns whether a triangle that moves when e collapses to `place` would cross another triangle.
  bool would_cross(const meshops::Connectivity& mesh, meshops::Edge e, std::span<const Point3> places,
                   const Point3& place) const;
  /// Takes note of a collapse, after which the survivor is at its new place.
  void update(const meshops::Connectivity& mesh, const meshops::WeldEffect& effect, std::span<const Point3> places);

 private:
  void build(const meshops::Connectivity& mesh, std::span<const Point3> places);

  BoxTree tree_;
  std::vector<meshops::Face> face_;  // for each box of the tree, its triangle
  std::vector<std::uint32_t> box_of_face_;
  std::size_t live_ = 0;  // number of triangles that are left
};

}  // namespace rbpa::space
