#include "rbpa/space/rolling_ball.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "meshops/core/contract.h"
#include "rbpa/core/duplicate.h"
#include "rbpa/space/check_input.h"
#include "rbpa/space/pivot/roll_about_edge.h"
#include "rbpa/space/predicate/agreement.h"
#include "rbpa/space/search/cells.h"
#include "rbpa/space/search/scale.h"

namespace rbpa {
namespace {

using space::Cells;

constexpr std::uint32_t none = 0xffffffff;

/// The distinct points in lexicographic order, as numbers that the filters like, and what they are called.
struct Places {
  std::vector<Point3> points;
  std::vector<std::uint32_t> input;  // the lowest index at each
  std::vector<std::uint32_t> place;  // of each input index; none for duplicates
  std::vector<Duplicate> duplicates;
};

Places places_of(std::span<const Point3> points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return points[i] != points[j] ? points[i] < points[j] : i < j; });
  Places places;
  places.place.assign(points.size(), none);
  for (const std::uint32_t i : order) {
    if (!places.points.empty() && points[i] == places.points.back()) {
      places.duplicates.push_back({i, places.input.back()});
      continue;
    }
    places.place[i] = static_cast<std::uint32_t>(places.input.size());
    places.points.push_back(points[i]);
    places.input.push_back(i);
  }
  return places;
}

/// The number of the cell of each point.
std::vector<std::uint32_t> cells_of(const Cells& cells, std::size_t points) {
  std::vector<std::uint32_t> cell(points);
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (const std::uint32_t p : cells.points_in(i)) cell[p] = static_cast<std::uint32_t>(i);
  return cell;
}

}  // namespace

class RollingBall::Inside {
 public:
  Inside(std::span<const Point3> points, std::span<const Point3> normals, double radius)
      : points_(points.begin(), points.end()),
        normals_(normals.begin(), normals.end()),
        radius_(radius),
        places_(places_of(points_)),
        agreement_(points_, normals_, places_.duplicates),
        cells_(places_.points, radius),
        cell_(cells_of(cells_, places_.points.size())) {
    const std::optional<int> exponent = space::scale_to_double(places_.points, radius);
    fits_double_ = exponent.has_value();
    if (!exponent || *exponent == 0) return;
    for (Point3& p : places_.points)
      p = {std::ldexp(p.x, *exponent), std::ldexp(p.y, *exponent), std::ldexp(p.z, *exponent)};
    radius_ = std::ldexp(radius, *exponent);
  }

  std::size_t points() const { return points_.size(); }

  std::optional<std::uint32_t> roll(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    if (place(a) == none || place(b) == none || place(c) == none || a == b) return std::nullopt;
    return fits_double_ ? roll<double>(a, b, c) : roll<long double>(a, b, c);
  }
  std::vector<Triangle> triangles_from(std::uint32_t first) const {
    meshops::require(first < points(), "RollingBall: no such point");
    if (place(first) == none) return {};
    return fits_double_ ? triangles_from<double>(first) : triangles_from<long double>(first);
  }
  bool agrees(const Triangle& triangle) const {
    for (const std::uint32_t corner : triangle) meshops::require(corner < points(), "RollingBall: no such point");
    const auto disagreeing = agreement_.disagreeing(triangle);
    return std::find(disagreeing.begin(), disagreeing.end(), true) == disagreeing.end();
  }

 private:
  /// What a ball that touches a point can touch or hold besides, nearest first.
  struct Near {
    std::vector<Point3> points;
    std::vector<std::uint32_t> input;
  };

  std::uint32_t place(std::uint32_t index) const { return index < points() ? places_.place[index] : none; }

  template <typename Real>
  Near near_to(std::uint32_t index) const {
    struct Distance {
      Real square;  // rounded
      std::uint32_t place;
    };
    const std::uint32_t at = place(index);
    // Rounded outward, by more than the roundings of a distance.
    const Real farthest = 4 * Real(radius_) * Real(radius_) * (1 + Real(0x1p-40));
    std::vector<Distance> found;
    cells_.for_each_around(cell_[at], [&](std::size_t cell) {
      for (const std::uint32_t p : cells_.points_in(cell)) {
        const space::Vector3<Real> d = space::from<Real>(places_.points[at], places_.points[p]);
        const Real square = space::dot(d, d);
        if (p != at && !(square > farthest)) found.push_back({square, p});
      }
    });
    std::sort(found.begin(), found.end(), [](const Distance& p, const Distance& q) {
      return p.square != q.square ? p.square < q.square : p.place < q.place;
    });
    Near near;
    for (const Distance& p : found) {
      near.points.push_back(places_.points[p.place]);
      near.input.push_back(places_.input[p.place]);
    }
    return near;
  }

  template <typename Real>
  std::optional<std::uint32_t> roll(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const Near near = near_to<Real>(a);
    const auto found = std::find(near.input.begin(), near.input.end(), b);
    if (found == near.input.end()) return std::nullopt;
    const auto end = static_cast<std::size_t>(found - near.input.begin());
    std::optional<std::uint32_t> touched;
    space::EdgeRoll<Real>(places_.points[place(a)], end, radius_, near.points)
        .for_each_free_arc([&](std::size_t left, std::size_t p) {
          if (near.input[left] == c) touched = near.input[p];
        });
    return touched;
  }

  template <typename Real>
  std::vector<Triangle> triangles_from(std::uint32_t first) const {
    const Near near = near_to<Real>(first);
    std::vector<Triangle> found;
    // Each has one side that leaves `first`.
    for (std::size_t b = 0; b < near.points.size(); ++b)
      if (near.input[b] > first)
        space::EdgeRoll<Real>(places_.points[place(first)], b, radius_, near.points)
            .for_each_free_arc([&](std::size_t left, std::size_t) {
              if (near.input[left] > first) found.push_back({first, near.input[b], near.input[left]});
            });
    std::sort(found.begin(), found.end());
    return found;
  }

  std::vector<Point3> points_, normals_;
  double radius_;
  bool fits_double_ = true;
  Places places_;
  space::Agreement agreement_;
  Cells cells_;
  std::vector<std::uint32_t> cell_;  // of each place
};

RollingBall::RollingBall(std::span<const Point3> points, std::span<const Point3> normals, double radius) {
  space::check_radius(radius);
  space::check_points(points);
  space::check_normals(points, normals);
  inside_ = std::make_unique<const Inside>(points, normals, radius);
}
RollingBall::RollingBall(std::span<const Point3> points, double radius) {
  space::check_radius(radius);
  space::check_points(points);
  inside_ = std::make_unique<const Inside>(points, std::span<const Point3>(), radius);
}
RollingBall::RollingBall(RollingBall&&) noexcept = default;
RollingBall& RollingBall::operator=(RollingBall&&) noexcept = default;
RollingBall::~RollingBall() = default;

std::size_t RollingBall::points() const { return inside_->points(); }
std::optional<std::uint32_t> RollingBall::roll(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  return inside_->roll(a, b, c);
}
std::vector<RollingBall::Triangle> RollingBall::triangles_from(std::uint32_t first) const {
  return inside_->triangles_from(first);
}
bool RollingBall::agrees(const Triangle& triangle) const { return inside_->agrees(triangle); }

}  // namespace rbpa
