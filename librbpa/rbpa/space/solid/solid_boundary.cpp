#include "rbpa/space/solid/solid_boundary.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <numeric>

#include "meshops/core/contract.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/sort/canonical_rows.h"
#include "rbpa/base/triangle_arrays.h"
#include "rbpa/space/predicate/outer_faces.h"
#include "rbpa/space/solid/boundary/glue_outside.h"
#include "rbpa/space/solid/boundary/measures.h"
#include "rbpa/space/surface/levels/sub_surface.h"

namespace rbpa {
namespace {

using space::place_of;

constexpr Triangle no_neighbors = {Surface::none, Surface::none, Surface::none};

/// The triangles that have a tetrahedron on one side only, glued through the tetrahedra around their sides. The number
/// of a face is 4 t + k for the face across from corner k of tetrahedron t.
class OpenFaces {
 public:
  OpenFaces(const Solid& solid, unsigned threads)
      : solid_(solid), threads_(threads_for(solid.simplices.size(), threads)) {
    meshops::require(solid.neighbors.size() == solid.simplices.size(),
                     "solid_boundary: expected a solid with neighbors");
  }

  /// Step 1: finds the faces without a neighbor, in canonical order.
  void find() {
    const auto& neighbors = solid_.neighbors;
    first_.resize(neighbors.size());
    std::vector<std::uint32_t> begin(neighbors.size() / at_a_time + 2, 0);  // for each part: its first open face
    for_each_part(threads_, neighbors.size(), at_a_time, [&](std::size_t first, std::size_t last) {
      std::uint32_t& count = begin[first / at_a_time + 1];
      for (std::size_t t = first; t < last; ++t)
        count += static_cast<std::uint32_t>(std::count(neighbors[t].begin(), neighbors[t].end(), Solid::none));
    });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    meshops::FreshVector<Row> rows(begin.back());  // three corners, and the number of the face
    for_each_part(threads_, neighbors.size(), at_a_time, [&](std::size_t first, std::size_t last) {
      std::uint32_t next = begin[first / at_a_time];
      for (auto t = static_cast<std::uint32_t>(first); t < last; ++t) {
        first_[t] = next;
        for (std::uint32_t k = 0; k < 4; ++k) {
          if (neighbors[t][k] != Solid::none) continue;
          const Triangle triangle = from_least(space::outer_face(solid_.simplices[t], k));
          rows[next++] = {triangle[0], triangle[1], triangle[2], 4 * t + k};
        }
      }
    });
    std::uint32_t greatest = 0;  // of the least corners: other corners may be any numbers
    for (const Row& row : rows) greatest = std::max(greatest, row[0]);
    std::vector<Row> sorted;
    place_ = sort_rows(rows, std::size_t{greatest} + 1, threads_, sorted);
    for (const Row& row : sorted) {
      triangles_.push_back({row[0], row[1], row[2]});
      faces_.push_back(row[3]);
    }
    neighbors_.assign(triangles_.size(), no_neighbors);
  }

  /// Step 2: glues each side to the side at the other end of its wedge of tetrahedra. Two threads may walk through one
  /// wedge from its two ends; both then glue the same sides.
  void glue() {
    for_each_part(threads_, triangles_.size(), at_a_time, [&](std::size_t first, std::size_t last) {
      for (auto i = static_cast<std::uint32_t>(first); i < last; ++i)
        for (std::uint32_t j = 0; j < 3; ++j)
          if (std::atomic_ref(neighbors_[i][j]).load(std::memory_order_relaxed) == Surface::none) glue(i, j);
    });
  }

  SolidBoundary result() && {
    SolidBoundary result;
    result.surface.triangles = std::move(triangles_);
    result.surface.neighbors = std::move(neighbors_);
    result.surface.duplicates = solid_.duplicates;
    result.surface.distinct = solid_.distinct;
    for (std::uint32_t& face : faces_) face /= 4;
    result.tetrahedra = std::move(faces_);
    return result;
  }

 private:
  /// Walks through the tetrahedra around side j of triangle i, and glues the side to the side where the walk ends. The
  /// walk enters a neighbor only if the neighbor shares the face. No two tetrahedra therefore lead to the same next
  /// one, and the walk ends.
  void glue(std::uint32_t i, std::uint32_t j) {
    constexpr const char* not_shared =
        "solid_boundary: expected neighbors[t][k] to be the tetrahedron across the face opposite corner k of t";
    const std::uint32_t p = triangles_[i][(j + 1) % 3], q = triangles_[i][(j + 2) % 3];
    // `in` and `out` are the corners of tetrahedron t across from the faces through which the walk enters and leaves t.
    std::uint32_t t = faces_[i] / 4, in = faces_[i] % 4, out = place_of(triangles_[i][j], solid_.simplices[t]);
    for (std::uint32_t next = solid_.neighbors[t][out]; next != Solid::none; next = solid_.neighbors[t][out]) {
      meshops::require(next < solid_.simplices.size(), not_shared);
      const Row &corners = solid_.simplices[next], &across = solid_.neighbors[next];
      const std::uint32_t passed = solid_.simplices[t][in];
      const std::uint32_t back = place_of(t, across), ahead = place_of(passed, corners);
      const std::uint32_t at_p = place_of(p, corners), at_q = place_of(q, corners);
      const bool all_there = across[back] == t && corners[ahead] == passed && corners[at_p] == p && corners[at_q] == q;
      meshops::require(all_there && (1U << back | 1U << ahead | 1U << at_p | 1U << at_q) == 15, not_shared);
      t = next;
      in = back;
      out = ahead;
    }
    std::uint32_t other = first_[t];
    for (std::uint32_t k = 0; k < out; ++k) other += solid_.neighbors[t][k] == Solid::none;
    other = place_[other];
    const std::uint32_t across = place_of(solid_.simplices[t][in], triangles_[other]);
    meshops::require(triangles_[other][(across + 1) % 3] == q && triangles_[other][(across + 2) % 3] == p,
                     "solid_boundary: expected positively oriented tetrahedra");
    std::atomic_ref(neighbors_[i][j]).store(other, std::memory_order_relaxed);
    std::atomic_ref(neighbors_[other][across]).store(i, std::memory_order_relaxed);
  }

  static constexpr std::size_t at_a_time = 1u << 13;

  const Solid& solid_;
  Threads threads_;
  std::vector<std::uint32_t> first_;           // for each tetrahedron: the number of open faces of earlier ones
  meshops::FreshVector<std::uint32_t> place_;  // for each open face as found: its canonical place
  std::vector<Triangle> triangles_, neighbors_;
  std::vector<std::uint32_t> faces_;
};

}  // namespace

SolidBoundary solid_boundary(const Solid& solid, unsigned threads) {
  OpenFaces faces(solid, threads);
  faces.find();
  faces.glue();
  return std::move(faces).result();
}

Surface glued_outside(std::span<const Point3> points, const Surface& boundary) {
  require_linked(space::arrays_of(boundary), points.size());
  for (const Triangle& neighbors : boundary.neighbors)
    for (const std::uint32_t other : neighbors)
      meshops::require(other != Surface::none, "glued_outside: a side has no neighbor, expected solid_boundary(solid)");
  Surface result = boundary;
  space::glue_outside(points, result);
  return result;
}

BoundaryMeasures measure(std::span<const Point3> points, const Surface& boundary) {
  if (boundary.triangles.empty()) return {};
  for (const Triangle& t : boundary.triangles)
    meshops::require(std::max({t[0], t[1], t[2]}) < points.size(),
                     "measure: a triangle of the boundary has a corner that is not a point");
  std::vector<std::uint32_t> all(boundary.triangles.size());
  std::iota(all.begin(), all.end(), std::uint32_t{0});
  const space::ClosedMeasures of = space::Measures(points).of(boundary.triangles, all);
  return {of.volume, of.area};
}

}  // namespace rbpa
