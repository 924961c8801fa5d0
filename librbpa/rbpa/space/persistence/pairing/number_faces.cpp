#include "rbpa/space/persistence/pairing/number_faces.h"

#include <algorithm>
#include <bit>

#include "meshops/core/contract.h"

namespace rbpa::space {
namespace {

class EdgeTable {
 public:
  /// Makes an empty table for the edges of `triangles`.
  EdgeTable(std::size_t points, std::span<const Triangle> triangles) : begin_(points + 1, 0) {
    for (const Triangle& triangle : triangles) {
      begin_[triangle[0]] += 2;
      ++begin_[triangle[1]];
    }
    // begin_[p] is now the number of sides up from p. An edge is a side of at least two triangles, so that half of this
    // number bounds the number of edges.
    std::size_t sum = 0;
    for (std::size_t& begin : begin_) {
      const std::size_t slots = begin == 0 ? 0 : std::bit_ceil(begin / 2 + 1);
      begin = sum;
      sum += slots;
    }
    slots_.assign(sum, Solid::none);
  }

  /// Returns the number of the edge from a to b. Appends a new edge to `edges`. Requires: a < b.
  std::uint32_t number(std::uint32_t a, std::uint32_t b, std::vector<std::array<std::uint32_t, 2>>& edges) {
    std::uint32_t* const slots = &slots_[begin_[a]];
    const std::size_t mask = begin_[a + std::size_t{1}] - begin_[a] - 1;
    for (std::size_t at = b * 0x9e3779b1U >> 7U;; ++at) {
      std::uint32_t& slot = slots[at & mask];
      if (slot == Solid::none) {
        slot = static_cast<std::uint32_t>(edges.size());
        edges.push_back({a, b});
      } else if (edges[slot][1] != b) {
        continue;
      }
      return slot;
    }
  }

 private:
  std::vector<std::size_t> begin_;  // for each point: the beginning of the slots of edges up from it
  std::vector<std::uint32_t> slots_;
};

}  // namespace

NumberedTriangles number_triangles(const Solid& delaunay, Steps& step) {
  constexpr const char* not_shared =
      "the triangulation: found a tetrahedron whose neighbor k does not share the face opposite corner k with it, "
      "expected neighbors as solid() returns them";
  const auto& [simplices, neighbors, duplicates, isolated, distinct] = delaunay;
  NumberedTriangles triangles;
  triangles.of.resize(simplices.size());
  triangles.corners.reserve(2 * simplices.size() + simplices.size() / 16);
  std::size_t half_shared = 0;  // number of triangles whose second tetrahedron is not visited yet
  for (std::uint32_t t = 0; t < simplices.size(); ++t) {
    step();
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t beyond = neighbors[t][k];
      const std::uint32_t a = simplices[t][(k + 1) % 4], b = simplices[t][(k + 2) % 4], c = simplices[t][(k + 3) % 4];
      if (beyond < t) {
        const auto& others = neighbors[beyond];
        const auto back = static_cast<std::size_t>(std::find(others.begin(), others.end(), t) - others.begin());
        meshops::require(back < 4, not_shared);
        triangles.of[t][k] = triangles.of[beyond][back];
        for (const std::uint32_t corner : triangles.corners[triangles.of[t][k]])
          meshops::require((corner == a) | (corner == b) | (corner == c), not_shared);
        --half_shared;
        continue;
      }
      half_shared += beyond != Solid::none;
      meshops::require(beyond == Solid::none || beyond < simplices.size(), not_shared);
      triangles.of[t][k] = static_cast<std::uint32_t>(triangles.corners.size());
      Triangle corners = {a, b, c};
      std::sort(corners.begin(), corners.end());
      triangles.corners.push_back(corners);
    }
  }
  meshops::require(half_shared == 0, not_shared);
  return triangles;
}

NumberedEdges number_edges(std::size_t points, std::span<const Triangle> triangles, Steps& step) {
  EdgeTable table(points, triangles);
  NumberedEdges edges;
  edges.ends.reserve(triangles.size() * 5 / 8);
  edges.of.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    step();
    edges.of.push_back(
        {table.number(b, c, edges.ends), table.number(a, c, edges.ends), table.number(a, b, edges.ends)});
  }
  return edges;
}

}  // namespace rbpa::space
