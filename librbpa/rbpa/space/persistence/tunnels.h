// What: which triangle ends each tunnel.
// How:  columns of the boundary matrix, with coefficients in Z/2, are reduced in any order, here along the curve through space: where the pivot of one is
//       that of a later triangle, they change places, and the later one goes on. Columns with two or more triangles in them are kept; others are their
//       triangle's boundary. Edges that end a component can be no pivot, and are left out of all columns.
// Law:  the pairs do not depend on the order, as the reduced matrix has the same pivots in any.
// Cost: nearly linear in practice: most columns are never added to.
// Source: de Silva, Morozov, Vejdemo-Johansson, Dualities in persistent (co)homology (2011); Bauer, Kerber, Reininghaus, Clear and compress (2014).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/steps.h"
#include "rbpa/solid_filtration.h"

namespace rbpa::space {

/// Of each edge the triangle that ends the tunnel that it makes; Solid::none of edges that make none. `order` has the edges by alpha, of which those in
/// `joins` make none; triangles in `makes_void` end none.
std::vector<std::uint32_t> pair_tunnels(const SolidFiltration& filtration, std::span<const std::uint32_t> order,
                                        const std::vector<bool>& joins, const std::vector<bool>& makes_void,
                                        Steps& step);

}  // namespace rbpa::space
