#include "rbpa/plane/filtration/ordered_triangles.h"

namespace rbpa {

OwnedTriangles in_order(const TriangleArrays& arrays, std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  OwnedTriangles ordered;
  ordered.triangles.resize(order.size());
  ordered.neighbors.resize(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    ordered.triangles[i] = arrays.triangles[order[i]];
    ordered.neighbors[i] = arrays.neighbors[order[i]];
    for (std::uint32_t& neighbor : ordered.neighbors[i])
      if (neighbor != TriangleArrays::none) neighbor = place[neighbor];
  }
  return ordered;
}

std::vector<std::uint32_t> gaps_of(const TriangleArrays& arrays, std::size_t points) {
  std::vector<std::uint32_t> gaps(points);
  for (std::size_t t = 0; t < arrays.triangles.size(); ++t)
    for (unsigned k = 0; k < 3; ++k)
      gaps[arrays.triangles[t][k]] += arrays.neighbors[t][(k + 1) % 3] == TriangleArrays::none ? 2u : 1u;
  return gaps;
}

}  // namespace rbpa
