// What: keeps the triangles of a mesh in space while edges collapse, and tells whether a collapse would make some
//       cross.
// Law:  exact; triangles cross as in crossing_triangles(). If no triangles cross before, and no refused collapse is
//       made, none cross after.
// How:  a tree of the boxes of all triangles, in which boxes are replaced, and which is built anew when half of the
//       triangles are gone. The triangles around the vertex that moves have a corner in common: two of them cross only
//       if, in one of them, the side across from this corner meets the other triangle.
// Cost: a search in the tree for each triangle that moves, and an exact test for each triangle near it; about 90 bytes
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
  /// Takes the triangles. Requires: a mesh of triangles, with a finite place for each vertex of a face. Throws:
  /// ContractViolation that names a vertex whose place is not finite.
  LiveTriangles(const meshops::Connectivity& mesh, std::span<const Point3> places);

  /// Returns whether a triangle that moves when e collapses to `place` would cross another triangle.
  bool would_cross(const meshops::Connectivity& mesh, meshops::Edge e, std::span<const Point3> places,
                   const Point3& place) const;
  /// Updates the boxes after a collapse. Requires: the survivor is at its new place.
  void update(const meshops::Connectivity& mesh, const meshops::WeldEffect& effect, std::span<const Point3> places);

 private:
  void build(const meshops::Connectivity& mesh, std::span<const Point3> places);

  BoxTree tree_;
  std::vector<meshops::Face> face_;  // for each box of the tree, its triangle
  std::vector<std::uint32_t> box_of_face_;
  std::size_t live_ = 0;  // number of triangles that are left
};

}  // namespace rbpa::space
