// What: measures regions of tetrahedra outside of a union of balls, and finds the largest ball that fits in each.
// Law:  sizes are rounded like those of outside_of_balls(). No larger ball fits in a void.
// Cost: of the largest ball: some triangulations of the balls around the region.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/space/balls/ball_voids.h"
#include "rbpa/space/balls/full/faces_within.h"
#include "rbpa/space/balls/full/outside_of_balls.h"
#include "rbpa/space/balls/full/slices.h"
#include "rbpa/space/predicate/spread.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {

class Hollows {
 public:
  /// Finds the dual complex of the balls. Keeps references. Requires: what ball_voids() requires. Throws: Cancelled.
  Hollows(std::span<const Point3> centers, std::span<const double> radii, const RegularTriangulation& regular,
          Threads& threads, const GoOn& go_on);
  Hollows(const Hollows&) = delete;
  Hollows& operator=(const Hollows&) = delete;

  const FacesWithin& faces() const { return faces_; }
  const PointStars& stars() const { return stars_; }
  /// Returns the power cells of the scaled balls.
  const PowerCells& scaled_cells() const { return power_cells_; }
  double scaled_volume(std::uint32_t t) const { return volume<double>(scaled_centers_, cells_.simplices[t]); }
  double unscaled(double value, int degree) const { return std::ldexp(value, -degree * scale_.exponent); }
  Point3 unscaled(const Point3& p) const { return {unscaled(p.x, 1), unscaled(p.y, 1), unscaled(p.z, 1)}; }
  Ball ball(std::uint32_t t, std::size_t k) const { return {cells_.position(t, k), radii_[cells_.simplices[t][k]]}; }
  /// Returns the scaled balls at the corners of a triangle or tetrahedron.
  template <std::size_t corners>
  std::array<Ball, corners> scaled_balls(const std::array<std::uint32_t, corners>& simplex) const {
    std::array<Ball, corners> balls{};
    for (std::size_t k = 0; k < corners; ++k) balls[k] = power_cells_.balls[simplex[k]];
    return balls;
  }

  /// Returns whether the edge between two corners of a tetrahedron is in the dual complex.
  bool has_edge(std::uint32_t a, std::uint32_t b) const;
  /// Measures `count` regions. `region` has for each tetrahedron its region, or BallRegions::none. Throws: Cancelled.
  RegionMeasures measure(std::span<const std::uint32_t> region, std::size_t count, Threads& threads,
                         const GoOn& go_on) const;
  /// Fills in the power, and center and radius of the largest ball with its center in the tetrahedra of `of` that meets
  /// none of the balls `around`, which are the corners of the tetrahedra, or more. Any thread may call.
  void find_largest_ball(BallVoid& of, std::span<const std::uint32_t> around,
                         std::span<const std::uint32_t> region) const;

 private:
  bool has_vertex(std::uint32_t i) const;
  bool is_free(const Point3& x, std::uint32_t near, std::uint32_t is_in, std::span<const std::uint32_t> region) const;

  std::span<const double> radii_;
  Triangulated cells_;
  FacesWithin faces_;
  PointStars stars_;
  Spread scale_;
  std::vector<Point3> copy_of_centers_;
  std::vector<double> copy_of_radii_;
  std::span<const Point3> scaled_centers_;
  std::span<const double> scaled_radii_;
  PowerCells power_cells_;
};

}  // namespace rbpa::space
