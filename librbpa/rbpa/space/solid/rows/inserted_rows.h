// What: inserts all points into a triangulation, and selects tetrahedra of the triangulation as rows.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/space/solid/insertion/insertion.h"
#include "rbpa/space/solid/rows/solid_rows.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa::space {

/// Inserts all points. Returns false, and inserts none, if all points are in one plane. Throws Cancelled.
template <bool weighted>
bool insert_all(BasicInsertion<weighted>& triangulation, const OnProgress& progress) {
  if (!triangulation.begin()) return false;
  Vertex v = 4;
  const GoOn go_on = [&] { return !progress || progress({v, triangulation.size()}); };
  Steps step(go_on);
  while (v++ < triangulation.size()) step(1 + triangulation.insert(v));
  return true;
}

/// Returns the tetrahedra t, without ghosts, for which keep(t) is true, and their neighbors if `neighbors` is true.
/// Corners are vertices of the triangulation.
template <bool weighted, typename Keep>
SolidRows rows_of(const BasicInsertion<weighted>& triangulation, bool neighbors, Threads& threads, Keep keep) {
  const auto tetrahedra = triangulation.tetrahedra();
  std::vector<std::uint32_t> kept;
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
    if (!triangulation.is_deleted(t) && !tetrahedra[t].is_ghost() && keep(t)) kept.push_back(t);
  constexpr std::size_t at_a_time = 1u << 14;
  SolidRows rows;
  rows.corners.resize(kept.size());
  for_each_part(threads, kept.size(), at_a_time, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) rows.corners[i] = tetrahedra[kept[i]].corner;
  });
  if (!neighbors) return rows;
  meshops::FreshVector<std::uint32_t> number(tetrahedra.size());
  for_each_part(threads, number.size(), 1u << 16, [&](std::size_t first, std::size_t last) {
    std::fill(&number[first], &number[0] + last, Solid::none);
  });
  for (std::size_t i = 0; i < kept.size(); ++i) number[kept[i]] = static_cast<std::uint32_t>(i);
  rows.neighbors.resize(kept.size());
  for_each_part(threads, kept.size(), at_a_time, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      for (std::size_t k = 0; k < 4; ++k) rows.neighbors[i][k] = number[tetrahedra[kept[i]].neighbor[k] / 4];
  });
  return rows;
}

}  // namespace rbpa::space
