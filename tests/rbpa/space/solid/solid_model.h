// What: solids that are arbitrary subsets of a Delaunay triangulation, and their boundaries, computed by sets and from
//       the tetrahedra that are left out.
// Law:  by the definitions alone, without walks: slow.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "oracle/rational.h"
#include "rbpa/space/solid/solid.h"
#include "support/random.h"
#include "support/space_sets.h"

namespace rbpa_test {

using Tetrahedron = std::array<std::uint32_t, 4>;
using Face = std::array<std::uint32_t, 3>;  ///< ascending

/// Returns the kept tetrahedra, with the neighbors that are kept.
rbpa::Solid part_of(const rbpa::Solid& solid, std::size_t points, const std::vector<bool>& kept);
/// Returns a random part: each tetrahedron is kept with the probability.
rbpa::Solid random_part(const rbpa::Solid& solid, std::size_t points, double probability, Random& random);

Face sorted(Face face);
/// Returns the tetrahedra of each face.
std::map<Face, std::vector<std::uint32_t>> tetrahedra_of_faces(const rbpa::Solid& solid);

struct Betti {
  std::size_t points, edges, triangles;
  std::array<std::size_t, 3> numbers;
};
/// Returns the Betti numbers by ranks of the boundary matrices over Z/2.
Betti betti_by_ranks(const rbpa::Solid& solid);

/// Returns the pieces of the tetrahedra that are connected by sharing `shared` corners: three, or one.
std::vector<std::vector<std::uint32_t>> pieces(const rbpa::Solid& solid, std::size_t shared);

Rational six_volumes(const Points3& points, const Tetrahedron& t);
Rational volume(const Points3& points, const rbpa::Solid& solid);
/// Returns whether the relative error is at most 2^-52.
bool is_near(double computed, const Rational& exact);

/// A bounded component of the outside, as a union of left-out tetrahedra of the triangulation.
struct ModelVoid {
  Rational six_volumes;
  std::vector<Face> faces;  ///< of the solid; ascending
};
/// Returns the voids. Requires: a part of this Delaunay triangulation.
std::vector<ModelVoid> voids_by_triangulation(const Points3& points, const rbpa::Solid& delaunay,
                                              const rbpa::Solid& part);

}  // namespace rbpa_test
