// What:   in which tetrahedron of a Delaunay triangulation does a point lie?
// Law:    exact, and a function of the point and the triangulation: where the point is on a face, an edge or a corner of several tetrahedra, the
//         first of them.
// How:    a walk from tetrahedron to tetrahedron toward the point, from one at a point in the same cell of a grid. Such a walk ends in every
//         Delaunay triangulation.
// Cost:   of a SolidLocator linear in the tetrahedra; of a query a few steps where the points are dense.
// Source: Devillers, Pion, Teillaud, Walking in a triangulation (2002).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/solid.h"

namespace rbpa {

struct SolidLocateOptions {
  /// Threads that work at most, the calling one included. 0 = all processors; larger values are capped.
  unsigned threads = 0;
  /// Called repeatedly, one call at a time but from any thread; returning false ends the work. Empty: never called.
  std::function<bool()> go_on = {};
};

class RBPA_API SolidLocator {
 public:
  /// Keeps the spans.
  /// Requires: finite points, and all tetrahedra of their Delaunay triangulation with neighbors, as solid() gives them at infinity.
  /// Throws:   ContractViolation where a corner or a neighbor does not exist.
  SolidLocator(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 4>> simplices,
               std::span<const std::array<std::uint32_t, 4>> neighbors);

  /// For each query the first tetrahedron that contains it, faces, edges and corners included, or Solid::none; none for a query that is
  /// not finite.
  /// Throws: Cancelled; ContractViolation when a walk shows that the triangulation is not Delaunay.
  std::vector<std::uint32_t> find(std::span<const Point3> queries, const SolidLocateOptions& options = {}) const;

 private:
  struct Walk;
  std::size_t cell_of(const Point3& p) const;
  std::uint32_t find(const Point3& query, Walk& walk) const;

  std::span<const Point3> points_;
  std::span<const std::array<std::uint32_t, 4>> simplices_, neighbors_;
  Point3 low_, high_;
  std::array<std::size_t, 3> cells_{1, 1, 1};
  std::vector<std::uint32_t> start_;  // of each cell, where a walk begins
};

}  // namespace rbpa
