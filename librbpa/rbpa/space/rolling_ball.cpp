#include "rbpa/space/rolling_ball.h"

#include <algorithm>
#include <cmath>

#include "meshops/core/contract.h"
#include "rbpa/core/duplicate.h"
#include "rbpa/parallel/threads.h"
#include "rbpa/space/check_input.h"
#include "rbpa/space/pivot/roll_about_edge.h"
#include "rbpa/space/predicate/agreement.h"
#include "rbpa/space/search/cells.h"
#include "rbpa/space/search/scale.h"

namespace rbpa {
namespace {

using space::Cells;

constexpr std::uint32_t none = 0xffffffff;

/// Multiplied by the power of two by which they fit double, where there is one.
std::vector<Point3> scaled(std::span<const Point3> points, std::optional<int> exponent) {
  std::vector<Point3> result(points.begin(), points.end());
  if (exponent.value_or(0) != 0)
    for (Point3& p : result) p = {std::ldexp(p.x, *exponent), std::ldexp(p.y, *exponent), std::ldexp(p.z, *exponent)};
  return result;
}

std::vector<Duplicate> duplicates_of(const Cells& cells) {
  std::vector<Duplicate> duplicates;
  for (const auto& [site, index] : cells.equals()) duplicates.push_back({index, cells.input_index()[site]});
  return duplicates;
}

}  // namespace

class RollingBall::Inside {
 public:
  Inside(std::span<const Point3> points, std::span<const Point3> normals, double radius, Threads threads = Threads(1))
      : points_(points.begin(), points.end()),
        normals_(normals.begin(), normals.end()),
        exponent_(space::scale_to_double(points, radius)),
        cells_(scaled(points, exponent_), std::ldexp(radius, exponent_.value_or(0)), threads),
        agreement_(points_, normals_, duplicates_of(cells_)),
        site_(points.size(), none) {
    for (space::Site s = 0; s < cells_.sites().size(); ++s) site_[cells_.input_index()[s]] = s;
  }

  std::size_t points() const { return points_.size(); }

  std::optional<std::uint32_t> roll(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    if (site(a) == none || site(b) == none || site(c) == none || a == b) return std::nullopt;
    return exponent_ ? roll<double>(a, b, c) : roll<long double>(a, b, c);
  }
  std::vector<Triangle> triangles_from(std::uint32_t first) const {
    meshops::require(first < points(), "RollingBall: no such point");
    if (site(first) == none) return {};
    return exponent_ ? triangles_from<double>(first) : triangles_from<long double>(first);
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

  space::Site site(std::uint32_t index) const { return index < points() ? site_[index] : none; }
  const Point3& at(std::uint32_t index) const { return cells_.sites()[site(index)]; }

  template <typename Real>
  Near near_to(std::uint32_t index) const {
    struct Distance {
      Real square;  // rounded
      space::Site site;
    };
    // Rounded outward, by more than the roundings of a distance.
    const Real radius = cells_.radius(), farthest = 4 * radius * radius * (1 + Real(0x1p-40));
    std::vector<Distance> found;
    const auto look_at = [&](space::Site first, space::Site last) {
      for (space::Site p = first; p < last; ++p) {
        const space::Vector3<Real> d = space::from<Real>(at(index), cells_.sites()[p]);
        const Real square = space::dot(d, d);
        if (p != site(index) && !(square > farthest)) found.push_back({square, p});
      }
    };
    Cells::Around(cells_).for_each_run(cells_.cell_of(site(index)), look_at);
    std::sort(found.begin(), found.end(), [](const Distance& p, const Distance& q) {
      return p.square != q.square ? p.square < q.square : p.site < q.site;
    });
    Near near;
    for (const Distance& p : found) {
      near.points.push_back(cells_.sites()[p.site]);
      near.input.push_back(cells_.input_index()[p.site]);
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
    space::EdgeRoll<Real>(at(a), end, cells_.radius(), near.points)
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
        space::EdgeRoll<Real>(at(first), b, cells_.radius(), near.points)
            .for_each_free_arc([&](std::size_t left, std::size_t) {
              if (near.input[left] > first) found.push_back({first, near.input[b], near.input[left]});
            });
    std::sort(found.begin(), found.end());
    return found;
  }

  std::vector<Point3> points_, normals_;
  std::optional<int> exponent_;  // of two: the cells have the points multiplied, where that makes them fit double
  Cells cells_;
  space::Agreement agreement_;
  std::vector<space::Site> site_;  // of each input index; none for duplicates
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
