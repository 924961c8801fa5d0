// What: selects tetrahedra of a triangulation as rows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/sort/canonical_rows.h"
#include "rbpa/space/solid/insertion/insertion.h"
#include "rbpa/space/solid/rows/solid_rows.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa::space {

/// Returns the tetrahedra t, without ghosts, for which keep(t) is true, and their neighbors if `neighbors` is true.
/// Corners are vertices of the triangulation, of which only tetrahedra() and index() can be called later. Several
/// threads may call keep().
template <bool weighted, typename Keep>
SolidRows rows_of(BasicInsertion<weighted>& triangulation, bool neighbors, Threads& threads, Keep keep) {
  const auto tetrahedra = triangulation.tetrahedra();
  constexpr std::size_t at_a_time = 1u << 15;
  meshops::FreshVector<std::uint32_t> number(tetrahedra.size());  // at first within the part, then in all
  std::vector<std::uint32_t> count(tetrahedra.size() / at_a_time + 2);
  for_each_part(threads, number.size(), at_a_time, [&](std::size_t first, std::size_t last) {
    std::uint32_t kept = 0;
    for (std::size_t i = first; i < last; ++i) {
      const auto t = static_cast<std::uint32_t>(i);
      number[i] = !triangulation.is_deleted(t) && !tetrahedra[i].is_ghost() && keep(t) ? kept++ : Solid::none;
    }
    count[first / at_a_time + 1] = kept;
  });
  triangulation.keep_rows();
  std::partial_sum(count.begin(), count.end(), count.begin());
  SolidRows rows;
  resize_rows(rows.corners, count.back(), threads);
  for_each_part(threads, number.size(), at_a_time, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      if (number[i] != Solid::none) rows.corners[number[i] += count[first / at_a_time]] = tetrahedra[i].corner;
  });
  if (!neighbors) return rows;
  rows.neighbors.resize(rows.corners.size());
  for_each_part(threads, number.size(), at_a_time, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      if (number[i] != Solid::none)
        for (std::size_t k = 0; k < 4; ++k) rows.neighbors[number[i]][k] = number[tetrahedra[i].neighbor[k] / 4];
  });
  return rows;
}

}  // namespace rbpa::space
