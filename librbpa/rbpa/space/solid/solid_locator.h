// What:   finds the tetrahedron of a Delaunay triangulation that contains a point.
// Law:    the tetrahedron is found exactly, as a function of the point and the triangulation: if the point lies on a
//         face, edge or corner of several tetrahedra, the tetrahedron of lowest index is found.
// How:    a walk from tetrahedron to tetrahedron toward the point. The walk begins at an input point in the same cell
//         of a grid or, if this cell has none, in an earlier cell. Such a walk ends in every Delaunay triangulation.
// Cost:   construction is linear in the tetrahedra; a query takes a few steps of the walk where the points are dense.
// Source: Devillers, Pion, Teillaud, Walking in a triangulation (2002).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/temporary.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa {

struct SolidLocateOptions {
  MaxThreads threads = 0;  ///< maximum number; 0: all processors
  GoOn go_on = {};         ///< callback for cancellation, called after each part of 1,024 queries
};

/// A Delaunay triangulation prepared for queries. Several threads may query one object at the same time.
class RBPA_API SolidLocator {
 public:
  /// Prepares a triangulation for queries. Keeps the spans: the arrays must outlive this object and stay unchanged.
  /// Requires: finite `points`; `simplices` and `neighbors` are arrays of solid(points, infinity).
  /// Throws:   ContractViolation when the numbers of rows differ, or a corner or a neighbor does not exist; no other
  ///           requirement is checked.
  SolidLocator(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 4>> simplices,
               std::span<const std::array<std::uint32_t, 4>> neighbors);
  // A span would outlive its array.
  template <typename Points, typename Simplices, typename Neighbors>
  requires(TemporaryOwner<Points, std::span<const Point3>> ||
           TemporaryOwner<Simplices, std::span<const std::array<std::uint32_t, 4>>> ||
           TemporaryOwner<Neighbors, std::span<const std::array<std::uint32_t, 4>>>)
      SolidLocator(Points&&, Simplices&&, Neighbors&&)
  = delete;

  /// Returns for each query the lowest index of a tetrahedron that contains the query, boundary included; Solid::none
  /// if the query is outside of the triangulation or not finite.
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
  std::vector<std::uint32_t> start_;  // for each cell, the tetrahedron at which a walk begins
};

}  // namespace rbpa
