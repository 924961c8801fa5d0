// What:   a ball that rests on three points and rolls from there, one step at a time: ball pivoting for who goes his own way
//         over the exposed triangles, as an advancing front does.
// Law:    exact, on any finite input. What it says is a function of the set of points and the radius: where it came from, and
//         what was asked before, does not matter. Rolling back returns. docs/surface_derivation.md.
// Cost:   each question looks at the points within two radii; surface() asks all of them together, which is faster.
// Source: Bernardini et al., The ball-pivoting algorithm for surface reconstruction (1999).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"

namespace rbpa {

/// Points are named by their input indices; of equal points the lowest stands for all, and the others are in no triangle.
/// Questions can be asked from several threads.
class RBPA_API RollingBall {
 public:
  using Triangle = std::array<std::uint32_t, 3>;  ///< counter-clockwise as the ball sees it

  /// Keeps copies. Requires and throws as surface() does; without normals as exposed_triangles().
  RollingBall(std::span<const Point3> points, std::span<const Point3> normals, double radius);
  RollingBall(std::span<const Point3> points, double radius);
  RollingBall(RollingBall&&) noexcept;
  RollingBall& operator=(RollingBall&&) noexcept;
  ~RollingBall();

  /// By their input indices, with all that are equal.
  std::span<const Point3> points() const;

  /// The ball rests on the exposed triangle (a, b, c) and rolls over the side from a to b until it touches a point.
  /// Returns: that point p, which may be c again; the ball rests on (b, a, p) now, and roll(b, a, p) is c. Nothing when it does
  ///          not rest on (a, b, c), or a point is named that stands for none.
  std::optional<std::uint32_t> roll(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

  /// From the exposed triangle (a, b, from) to (b, a, to).
  struct Roll {
    std::uint32_t from, to;
    friend bool operator==(const Roll&, const Roll&) = default;
  };
  /// All that roll(a, b, …) and roll(b, a, …) can tell, in ascending order of `from`: so the exposed triangles that have a side
  /// between these points, (a, b, from) and (b, a, to) of each. Nothing when a point is named that stands for none.
  std::vector<Roll> rolls(std::uint32_t a, std::uint32_t b) const;

  /// The exposed triangles of which `first` is the least corner, in lexicographic order: of all points together, each once.
  /// Throws: ContractViolation when there is no such point.
  std::vector<Triangle> triangles_from(std::uint32_t first) const;

  /// The triangle's normal has a positive product with the normals at its corners, those of all points that are there.
  /// Always so without normals. Throws: ContractViolation when there are no such points.
  bool agrees(const Triangle& triangle) const;

 private:
  class Inside;
  std::unique_ptr<const Inside> inside_;
};

}  // namespace rbpa
