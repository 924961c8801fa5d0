// What:   rolls a ball that rests on three points, one step at a time: ball pivoting for code that traverses exposed
//         triangles, on which an empty ball of the radius rests, in its own order, as an advancing front does.
// Law:    exact, on any finite input. Each result is a function of the points, their normals and the radius, not of
//         earlier queries. Rolling back returns to the same triangle (docs/explanation/surfaces.md,
//         sections 11 and 12).
// Cost:   the constructor sorts the points, with one thread. Each roll reads and sorts the points within about two
//         radii; one call of surface() rolls over all sides faster.
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

/// A ball of fixed radius on fixed points. Points are input indices; of equal points, only the lowest is in triangles.
/// Several threads may call const functions concurrently. A moved-from ball may only be destroyed or assigned to.
class RBPA_API RollingBall {
 public:
  using Triangle = std::array<std::uint32_t, 3>;  ///< counter-clockwise as the ball sees it

  /// Copies points and normals.
  /// Requires: what surface() (surface.h) requires.
  /// Throws:   InvalidInput that names the violated requirement.
  RollingBall(std::span<const Point3> points, std::span<const Point3> normals, double radius);
  /// Takes points without normals, as above. Requires: what exposed_triangles() requires.
  RollingBall(std::span<const Point3> points, double radius);
  RollingBall(RollingBall&&) noexcept;
  RollingBall& operator=(RollingBall&&) noexcept;
  ~RollingBall();

  /// Returns the input points, duplicates included. The span is valid as long as the ball, also after a move.
  std::span<const Point3> points() const;

  /// Rolls the ball that rests on the exposed triangle (a, b, c) over the side from a to b until the ball touches a
  /// point p. Returns p, which may be c again; the ball then rests on (b, a, p), and roll(b, a, p) is c. The result is
  /// empty if the ball does not rest on (a, b, c), for example if an index is that of no point or of a duplicate.
  std::optional<std::uint32_t> roll(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

  /// A roll from the exposed triangle (a, b, from) to (b, a, to).
  struct Roll {
    std::uint32_t from, to;
    friend bool operator==(const Roll&, const Roll&) = default;
  };
  /// Returns all results of roll(a, b, …), by ascending `from`. The triangles (a, b, from) and (b, a, to) of the
  /// results are all exposed triangles with a side between a and b. The list is empty if an index is that of no point
  /// or of a duplicate.
  std::vector<Roll> rolls(std::uint32_t a, std::uint32_t b) const;

  /// Returns the exposed triangles whose corner of lowest index is `first`, in lexicographic order; none for a
  /// duplicate. `first` is the first corner. The results for all points together have each triangle once.
  /// Throws: ContractViolation when `first` is not the index of a point.
  std::vector<Triangle> triangles_from(std::uint32_t first) const;

  /// Returns whether the triangle's own normal has a positive scalar product with the normals of all points at its
  /// corners; true without normals.
  /// Requires: no corner is a duplicate; not checked.
  /// Throws:   ContractViolation when a corner is not the index of a point.
  bool agrees(const Triangle& triangle) const;

 private:
  class Inside;
  std::unique_ptr<const Inside> inside_;
};

}  // namespace rbpa
