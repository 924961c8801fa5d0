// The meshes on which every operator is tried, with the counts of each.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "support/meshes.h"

namespace meshops::test {

using Corners = std::array<int, 3>;

/// Fills an empty mesh. Requires triangles that form an oriented manifold with one fan at each vertex.
void add_triangles(TestMesh& mesh, int vertices, const std::vector<Corners>& triangles);

/// A mesh with a name and its topology. `simplicial`: no two edges join the same vertices.
struct Specimen {
  std::string name;
  void (*build)(TestMesh& mesh);
  int components;
  int boundary_curves;
  int genus;
  bool simplicial;
};

/// One triangle, discs, annulus, spheres, torus, double torus, pinched fans, two components, random surfaces of a
/// thousand triangles, by gluing and by stellar operators.
const std::vector<Specimen>& corpus();

inline TestMesh built(const Specimen& specimen) {
  TestMesh mesh;
  specimen.build(mesh);
  return mesh;
}

/// The isomorphism class of a mesh: equal for meshes that differ in handles only. Cost: quadratic in the worst case;
/// meant for up to some thousand edges.
std::string isomorphism_class(const Connectivity& mesh);

}  // namespace meshops::test
