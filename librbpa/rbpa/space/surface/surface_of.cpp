#include "rbpa/space/surface/surface_of.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>

#include "rbpa/base/error.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/triangle_arrays.h"
#include "rbpa/space/predicate/orientation.h"

namespace rbpa {
namespace {

/// A side of a triangle between two points, across from a third corner. The side opens if it leads from the lower to
/// the higher point: the triangle's positive side then follows it, counter-clockwise about that direction.
struct SideInSpace {
  std::uint32_t low, high, apex;
  std::uint32_t triangle, across;
  bool opens;
};

void check_triangles(std::span<const Point3> points, std::span<const Triangle> triangles) {
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();
  if (points.size() >= most || triangles.size() > most / 3)
    throw InvalidInput(std::to_string(points.size()) + " points and " + std::to_string(triangles.size()) +
                       " triangles, expected fewer than 2^32 - 1 points and 2^32 corners");
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const Point3& p = points[i]; !is_finite(p))
      throw InvalidInput("point " + std::to_string(i) + " is (" + text(p.x) + ", " + text(p.y) + ", " + text(p.z) +
                         "), expected finite coordinates");
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    const std::string name = "triangle " + std::to_string(t);
    for (const std::uint32_t corner : triangles[t])
      if (corner >= points.size())
        throw InvalidInput(name + ": found corner " + std::to_string(corner) + ", expected one of " +
                           std::to_string(points.size()) + " points");
    if (points[a] == points[b] || points[b] == points[c] || points[c] == points[a])
      throw InvalidInput(name + ": two corners are at one place (meshops::repair() drops such triangles)");
  }
}

/// Sets `distinct` and `duplicates`. Returns, for each point, the lowest index among the points at its place.
std::vector<std::uint32_t> lowest_equal(std::span<const Point3> points, Surface& surface) {
  std::vector<std::uint32_t> order(points.size()), lowest(points.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return points[i] < points[j] || (points[i] == points[j] && i < j);
  });
  for (std::size_t k = 0; k < order.size(); ++k)
    lowest[order[k]] = k > 0 && points[order[k - 1]] == points[order[k]] ? lowest[order[k - 1]] : order[k];
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (lowest[i] != i) surface.duplicates.push_back({i, lowest[i]});
  surface.distinct = points.size() - surface.duplicates.size();
  return lowest;
}

/// Sorts the sides at an edge of more than two triangles by their angle around the edge.
class EdgeTurn {
 public:
  EdgeTurn(std::span<const Point3> points, std::span<SideInSpace> sides)
      : points_(points), a_(points[sides.front().low]), b_(points[sides.front().high]) {
    for (const SideInSpace& side : sides)
      if (!space::are_collinear(a_, b_, at(side))) sides_.push_back(side);
    if (sides_.empty()) return;
    start_ = at(sides_.front());
    while (along(sides_.front()) == 0) ++axis_;
    start_along_ = along(sides_.front());
    std::sort(sides_.begin(), sides_.end(), [this](const SideInSpace& s, const SideInSpace& t) {
      const int direction = compare(s, t);
      return direction != 0 ? direction < 0 : !s.opens && t.opens;
    });
  }

  template <typename Visit>
  void for_each_pair(Visit visit) const {
    const std::size_t count = sides_.size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = (i + 1) % count;
      if (sides_[i].opens && !sides_[next].opens && is_alone(i) && is_alone(next)) visit(sides_[i], sides_[next]);
    }
  }

 private:
  const Point3& at(const SideInSpace& side) const { return points_[side.apex]; }
  int along(const SideInSpace& side) const { return space::orientation_along(a_, b_, at(side), axis_); }
  /// Returns the part of a full turn in which a side is, from the direction of the first side on: 0 in that direction,
  /// 1 in the first half, 2 in the opposite direction, 3 in the second half.
  int part(const SideInSpace& side) const {
    const int turned = space::orientation(a_, b_, start_, at(side));
    if (turned != 0) return turned > 0 ? 1 : 3;
    return along(side) == start_along_ ? 0 : 2;
  }
  int compare(const SideInSpace& s, const SideInSpace& t) const {
    const int first = part(s), second = part(t);
    return first != second ? first - second : -space::orientation(a_, b_, at(s), at(t));
  }
  /// Returns whether no other triangle with the same orientation lies on the triangle of side i.
  bool is_alone(std::size_t i) const {
    const auto lies_on = [&](std::size_t j) {
      return j != i && sides_[j].opens == sides_[i].opens && compare(sides_[i], sides_[j]) == 0;
    };
    return !lies_on((i + 1) % sides_.size()) && !lies_on((i + sides_.size() - 1) % sides_.size());
  }

  std::span<const Point3> points_;
  Point3 a_, b_, start_;
  int axis_ = 0, start_along_ = 0;
  std::vector<SideInSpace> sides_;
};

std::vector<Triangle> glued_by_place(std::span<const Point3> points, std::span<const Triangle> triangles) {
  std::vector<SideInSpace> sides;
  sides.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t from = triangles[t][(k + 1) % 3], to = triangles[t][(k + 2) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), triangles[t][k], t, k, from < to});
    }
  std::sort(sides.begin(), sides.end(), [](const SideInSpace& s, const SideInSpace& t) {
    return std::tie(s.low, s.high, s.apex, s.triangle) < std::tie(t.low, t.high, t.apex, t.triangle);
  });
  std::vector<Triangle> neighbors(triangles.size(), {Surface::none, Surface::none, Surface::none});
  const auto glue = [&](const SideInSpace& s, const SideInSpace& t) {
    neighbors[s.triangle][s.across] = t.triangle;
    neighbors[t.triangle][t.across] = s.triangle;
  };
  for (auto first = sides.begin(); first != sides.end();) {
    const auto last = std::find_if(first, sides.end(),
                                   [&](const SideInSpace& s) { return s.low != first->low || s.high != first->high; });
    if (last - first == 2 && first[0].opens != first[1].opens) glue(first[0], first[1]);
    if (last - first > 2)
      EdgeTurn(points, std::span<SideInSpace>(&*first, static_cast<std::size_t>(last - first))).for_each_pair(glue);
    first = last;
  }
  return neighbors;
}

/// Appends the triangles and their neighbors to `surface`, in canonical order.
void put_in_order(SurfaceOfTriangles& surface, std::span<const Triangle> triangles, std::vector<Triangle>& neighbors) {
  std::vector<Triangle> rotated(triangles.begin(), triangles.end());
  for (std::size_t t = 0; t < rotated.size(); ++t) {
    const auto least = std::min_element(rotated[t].begin(), rotated[t].end()) - rotated[t].begin();
    std::rotate(rotated[t].begin(), rotated[t].begin() + least, rotated[t].end());
    std::rotate(neighbors[t].begin(), neighbors[t].begin() + least, neighbors[t].end());
  }
  surface.given.resize(rotated.size());
  std::iota(surface.given.begin(), surface.given.end(), std::uint32_t{0});
  std::sort(surface.given.begin(), surface.given.end(),
            [&](std::uint32_t t, std::uint32_t u) { return std::tie(rotated[t], t) < std::tie(rotated[u], u); });
  std::vector<std::uint32_t> number(rotated.size());
  for (std::uint32_t place = 0; place < number.size(); ++place) number[surface.given[place]] = place;
  for (const std::uint32_t t : surface.given) {
    for (std::uint32_t& other : neighbors[t])
      if (other != Surface::none) other = number[other];
    surface.triangles.push_back(rotated[t]);
    surface.neighbors.push_back(neighbors[t]);
  }
}

std::vector<Triangle> by_lowest_points(std::span<const Triangle> triangles, std::span<const std::uint32_t> point) {
  std::vector<Triangle> result(triangles.begin(), triangles.end());
  for (Triangle& corners : result)
    for (std::uint32_t& corner : corners) corner = point[corner];
  return result;
}

}  // namespace

SurfaceOfTriangles surface_of(std::span<const Point3> points, std::span<const Triangle> triangles) {
  check_triangles(points, triangles);
  SurfaceOfTriangles surface;
  const std::vector<Triangle> own = by_lowest_points(triangles, lowest_equal(points, surface));
  std::vector<Triangle> neighbors = glued_by_place(points, own);
  put_in_order(surface, own, neighbors);
  return surface;
}

SurfaceOfTriangles surface_of(std::span<const Point3> points, std::span<const Triangle> triangles,
                              std::span<const Triangle> neighbors) {
  check_triangles(points, triangles);
  SurfaceOfTriangles surface;
  const std::vector<Triangle> own = by_lowest_points(triangles, lowest_equal(points, surface));
  require_linked({own, neighbors}, points.size());
  std::vector<Triangle> of_own(neighbors.begin(), neighbors.end());
  put_in_order(surface, own, of_own);
  return surface;
}

}  // namespace rbpa
