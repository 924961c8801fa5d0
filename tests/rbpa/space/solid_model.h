// What: solids that are any subset of a Delaunay triangulation, and what bounds them, by sets and by the tetrahedra
//       that are left out.
// Law:  by the definitions alone, with no walks: slow.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "oracle/rational.h"
#include "rbpa/solid.h"
#include "support/random.h"
#include "support/space_sets.h"

namespace rbpa_test {

using Tetrahedron = std::array<std::uint32_t, 4>;
using Face = std::array<std::uint32_t, 3>;  ///< ascending

/// Those of the tetrahedra that are kept, with the neighbors that are.
rbpa::Solid part_of(const rbpa::Solid& solid, std::size_t points, const std::vector<bool>& kept);
/// A random part: each tetrahedron with the probability.
rbpa::Solid random_part(const rbpa::Solid& solid, std::size_t points, double probability, Random& random);

Face sorted(Face face);
/// The tetrahedra of each face.
std::map<Face, std::vector<std::uint32_t>> tetrahedra_of_faces(const rbpa::Solid& solid);

struct Betti {
  std::size_t points, edges, triangles;
  std::array<std::size_t, 3> numbers;
};
/// By ranks of the boundary matrices over Z/2.
Betti betti_by_ranks(const rbpa::Solid& solid);

/// Pieces of the tetrahedra connected through what they share: three corners, or one.
std::vector<std::vector<std::uint32_t>> pieces(const rbpa::Solid& solid, std::size_t shared);

Rational six_volumes(const Points3& points, const Tetrahedron& t);

/// A bounded component of what is outside, as a union of tetrahedra of the triangulation that are left out.
struct ModelVoid {
  Rational six_volumes;
  std::vector<Face> faces;  ///< of the solid; ascending
};
/// Requires: a part of this Delaunay triangulation.
std::vector<ModelVoid> voids_by_triangulation(const Points3& points, const rbpa::Solid& delaunay,
                                              const rbpa::Solid& part);

}  // namespace rbpa_test
