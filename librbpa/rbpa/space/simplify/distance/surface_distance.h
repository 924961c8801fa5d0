// What:   computes an upper bound of the distance of a triangle's points from a set of triangles, and finds the nearest
//         point of the set.
// How:    the distance from one convex triangle is a convex function, so on a convex piece it is greatest at a corner.
//         A triangle is cut into convex pieces, each compared with one of the given triangles: a piece is cut along the
//         prism that stands on the given triangle nearest to its middle, or in two halves.
// Law:    conservative: bounds include rounding errors (docs/explanation/surfaces.md, section 25). A function of the
//         set of given triangles, not of any order.
// Cost:   a sort to build; for a triangle, some searches in a tree of boxes for each given triangle near it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "meshops/core/progress.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/cells/box_tree.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {

class SurfaceDistance {
 public:
  using Corners = std::array<Point3, 3>;

  /// Copies the triangles. Requires: finite points; corners are indices of points. Throws: Cancelled.
  SurfaceDistance(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 3>> triangles,
                  const meshops::GoOn& go_on = {});

  /// Returns whether every point of the triangle is certified to be within `limit` of a given triangle. The result may
  /// be false for a triangle that is barely within the limit.
  bool is_within(const Corners& triangle, double limit) const;

  /// Returns the greatest distance of the corners and the middle of the triangle from the given triangles. The greatest
  /// distance of any point of the triangle is at least the result, up to rounding.
  double least(const Corners& triangle) const;
  /// Returns a number that the distance of no point of the triangle exceeds. It is at most 1.05 times the greatest
  /// distance or 1.05 times `least`, whichever is more, unless the work reaches a limit.
  double greatest(const Corners& triangle, double least) const;

  /// A point in a given triangle: the weighted mean of its corners, indices of the given points.
  struct Foot {
    Point3 place;
    std::array<std::uint32_t, 3> corners;
    std::array<double, 3> weights;  // sum: 1
  };
  /// Returns the point of the given triangles that is nearest to p, rounded; absent if it is farther than `limit`. With
  /// `facing`, considers only triangles whose normals make less than a right angle with that vector, rounded.
  std::optional<Foot> nearest_point(const Point3& p, double limit,
                                    const std::optional<Vector3<double>>& facing = {}) const;

 private:
  using Vector = Vector3<double>;
  struct Given {
    Vector a, ab, ac;
  };
  struct Nearest {
    std::uint32_t number;
    double squared;
  };
  /// The vector from the point a + s ab + t ac of a given triangle.
  struct FromNearest {
    Vector away;
    double s, t;
  };
  struct Piece;
  class Bounding;

  Vector local(const Point3& p) const;
  FromNearest from_nearest(const Vector& p, std::uint32_t number) const;
  double squared_distance(const Vector& p, std::uint32_t number) const;
  std::optional<Nearest> nearest(const Vector& p, double most_squared) const;
  std::array<Vector, 3> local(const Corners& triangle) const;

  std::vector<Given> given_;  // in lexicographic order of corners, each from its least corner on
  std::vector<std::array<std::uint32_t, 3>> corners_;  // of each, indices of the given points
  BoxTree tree_;
  Point3 center_ = {};
  double scale_ = 1;  // a power of two; local coordinates of given points are at most 1
};

}  // namespace rbpa::space
