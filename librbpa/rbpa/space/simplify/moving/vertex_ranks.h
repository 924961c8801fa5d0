// What: orders the vertices of a mesh by their places, whatever their numbers are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "meshops/core/connectivity.h"
#include "meshops/core/live_range.h"
#include "rbpa/base/point3.h"

namespace rbpa::space {

/// Returns the rank of each vertex in lexicographic order of the places, 0 for a deleted one. Vertices at one place are
/// in the order of their sorted neighbors, and have one rank only if their neighbors are at the same places. After
/// equal ranks there is a gap; all are below the number of vertices. Requires: a place for each vertex. Cost: n log n.
inline std::vector<std::uint32_t> vertex_ranks(const meshops::Connectivity& mesh, const std::vector<Point3>& places) {
  const auto at = [](meshops::Vertex v) { return static_cast<std::size_t>(v.idx()); };
  std::vector<meshops::Vertex> order;
  for (const meshops::Vertex v : meshops::live_vertices(mesh)) order.push_back(v);
  std::stable_sort(order.begin(), order.end(), [&](auto v, auto w) { return places[at(v)] < places[at(w)]; });
  std::vector<std::uint32_t> of_place(places.size());
  for (std::uint32_t i = 0, first = 0; i < order.size(); ++i) {
    if (places[at(order[first])] < places[at(order[i])]) first = i;
    of_place[at(order[i])] = first;
  }
  std::vector<std::uint32_t> rank = of_place;
  std::vector<std::pair<std::vector<std::uint32_t>, meshops::Vertex>> same;  // vertices at one place, by neighbors
  for (std::uint32_t first = 0; first < order.size(); first += static_cast<std::uint32_t>(same.size())) {
    same.clear();
    for (std::size_t i = first; i < order.size() && of_place[at(order[i])] == first; ++i) {
      same.push_back({{}, order[i]});
      if (i == first && (i + 1 == order.size() || of_place[at(order[i + 1])] != first)) continue;  // alone
      for (const meshops::Vertex w : mesh.vv_range(order[i])) same.back().first.push_back(of_place[at(w)]);
      std::sort(same.back().first.begin(), same.back().first.end());
    }
    std::sort(same.begin(), same.end());
    for (std::uint32_t i = 0, least = 0; i < same.size(); ++i) {
      if (same[least].first != same[i].first) least = i;
      rank[at(same[i].second)] = first + least;
    }
  }
  return rank;
}

}  // namespace rbpa::space
