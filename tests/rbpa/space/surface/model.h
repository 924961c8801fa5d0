// What: computes surfaces of few points directly from their definitions: tests every triple of points against every
//       point, and compares every pair of sides at an edge.
// Law:  calls only the signs of predicate/exact.h and the ball of the library, which have tests of their own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "rbpa/space/surface/surface.h"
#include "support/space_sets.h"
#include "support/triangle.h"

namespace rbpa_test {

/// Returns the lowest index of each set of equal points, ascending.
std::vector<std::uint32_t> distinct_of(const Points3& points);

/// Returns all oriented triples on which an empty ball rests.
std::set<Triangle> exposed_by_definition(const Points3& points, double radius);

/// Returns whether the triangle's normal has no positive product with the normal of some point equal to its corner k.
bool disagrees(const Points3& points, const Points3& normals, const Triangle& triangle, std::size_t k);
bool agrees(const Points3& points, const Points3& normals, const Triangle& triangle);

/// Returns whether the turn about the edge from side (from, to, apex) to side (to, from, other) is less than the turn
/// to the third.
bool is_nearer(const Points3& points, std::uint32_t from, std::uint32_t to, std::uint32_t apex, std::uint32_t other,
               std::uint32_t third);

/// Returns the triangle to which the ball rolls from an exposed triangle over the side across from its corner k: the
/// first exposed triangle around the edge that is turned toward it.
Triangle next_by_definition(const Points3& points, const std::set<Triangle>& exposed, const Triangle& triangle,
                            std::size_t k);

/// The rule of docs/explanation/surfaces.md, section 17, with sets.
class ModelSurface {
 public:
  ModelSurface(const Points3& points, const Points3& normals) : points_(points), normals_(normals) {}

  void add(double radius);

  const std::map<Triangle, std::uint32_t>& levels() const { return levels_; }
  /// Returns the neighbor across from corner k; null where the side is boundary.
  const Triangle* neighbor(const Triangle& triangle, std::size_t k) const;
  bool is_interior_point(std::uint32_t point) const;
  bool is_interior_edge(std::uint32_t a, std::uint32_t b) const;

 private:
  using Side = std::pair<Triangle, std::size_t>;

  Points3 points_, normals_;
  std::uint32_t next_level_ = 0;
  std::map<Triangle, std::uint32_t> levels_;
  std::map<Side, Side> glued_;
};

/// Returns whether triangles, neighbors and levels equal those of the model.
bool is_model(const rbpa::Surface& surface, const ModelSurface& model);

}  // namespace rbpa_test
