// What: removes triangles from a triangulation in arrays, and lists the points that are then isolated.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rbpa/base/arrays/distinct.h"
#include "rbpa/plane/alpha_complex.h"

namespace rbpa {

/// Removes the triangles t for which is_kept(t) is false, also from the neighbors; the others keep their order. Leaves
/// `isolated` and `boundary` as they are.
/// Requires: neighbors were computed.
template <typename IsKept>
void keep_triangles(AlphaComplex& of, const IsKept& is_kept) {
  std::vector<std::uint32_t> number(of.triangles.size(), AlphaComplex::none);
  std::uint32_t kept = 0;
  for (std::size_t t = 0; t < number.size(); ++t) {
    if (!is_kept(t)) continue;
    number[t] = kept;
    of.triangles[kept] = of.triangles[t];
    of.neighbors[kept++] = of.neighbors[t];
  }
  of.triangles.resize(kept);
  of.neighbors.resize(kept);
  for (Triangle& across : of.neighbors)
    for (std::uint32_t& neighbor : across)
      if (neighbor != AlphaComplex::none) neighbor = number[neighbor];
}

/// Returns the distinct points i for which marked[i] is 0, ascending.
inline std::vector<std::uint32_t> unmarked(const std::vector<std::uint8_t>& marked,
                                           const std::vector<Duplicate>& duplicates) {
  std::vector<std::uint32_t> found;
  for_each_distinct(marked.size(), duplicates, [&](std::uint32_t i) {
    if (marked[i] == 0) found.push_back(i);
  });
  return found;
}

/// Returns the distinct points in no triangle of `of`, ascending; `points` is the number of input points.
inline std::vector<std::uint32_t> isolated_in(const AlphaComplex& of, std::size_t points) {
  std::vector<std::uint8_t> covered(points, 0);
  for (const Triangle& triangle : of.triangles)
    for (const std::uint32_t corner : triangle) covered[corner] = 1;
  return unmarked(covered, of.duplicates);
}

}  // namespace rbpa
