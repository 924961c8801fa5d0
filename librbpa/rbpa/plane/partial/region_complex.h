// What: the triangles of a region and its halo, and which of them the region owns.
// Law:  every triangle with a corner that the region owns is in the complex of the whole input, and so are the
//       neighbors across the triangle's sides at that corner. Other triangles need not be (docs/explanation/plane.md,
//       section 20).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/partial.h"
#include "rbpa/plane/region.h"

namespace rbpa {

/// Checks that 0 < alpha < ∞. Throws: InvalidInput, with the reason why infinity is not allowed.
void check_finite(double alpha);

/// Checks that bounds are numbers in ascending order. Throws: InvalidInput.
void check(const Region& region);

std::string text(const Region& region);

class RegionComplex {
 public:
  /// Computes the triangles. Throws: as partial().
  RegionComplex(const Region& region, const RegionPoints& points, double alpha, const PartialOptions& options);
  // Forbid copies, as spans may refer to lists of the same object.
  RegionComplex(const RegionComplex&) = delete;
  RegionComplex& operator=(const RegionComplex&) = delete;

  /// Returns the triangulation, with neighbors. Its indices count the region's points in ascending order of their
  /// indices in the whole input.
  const AlphaComplex& triangulation() const { return triangulation_; }
  std::size_t points() const { return points_.size(); }
  const Point& at(std::uint32_t i) const { return points_[i]; }
  std::uint64_t index(std::uint32_t i) const { return indices_[i]; }
  Corner corner(std::uint32_t i) const { return {indices_[i], points_[i]}; }
  bool owns(std::uint32_t i) const { return owned_[i] != 0; }

  /// Returns a number whose bit k is 1 if the region owns corner k of the triangle.
  unsigned owned_corners(std::uint32_t t) const {
    const auto& [a, b, c] = triangulation_.triangles[t];
    return owned_[a] | static_cast<unsigned>(owned_[b]) << 1U | static_cast<unsigned>(owned_[c]) << 2U;
  }
  /// Returns whether the region owns the lexicographically least corner. Requires: `owned` is owned_corners(t), not 0.
  bool owns_triangle(std::uint32_t t, unsigned owned) const;
  /// Returns whether the region owns the lexicographically lesser one of `a` and `b`.
  bool owns_edge(std::uint32_t a, std::uint32_t b) const { return owns(points_[a] < points_[b] ? a : b); }

 private:
  void sort(const RegionPoints& given);

  std::vector<Point> sorted_points_;  // filled only if the given points were not in order
  std::vector<std::uint64_t> sorted_indices_;
  std::span<const Point> points_;
  std::span<const std::uint64_t> indices_;  // ascending
  std::vector<std::uint8_t> owned_;
  AlphaComplex triangulation_;
};

}  // namespace rbpa
