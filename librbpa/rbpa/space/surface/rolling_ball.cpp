#include "rbpa/space/surface/rolling_ball.h"

#include <algorithm>
#include <string>

#include "meshops/core/contract.h"
#include "rbpa/base/duplicate.h"
#include "rbpa/base/progress.h"
#include "rbpa/space/cells/cells.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/cells/scaled_points.h"
#include "rbpa/space/predicate/agreement.h"
#include "rbpa/space/surface/pivot/roll_about_edge.h"
#include "rbpa/space/surface/star/find_rings.h"

namespace rbpa {
namespace {

using space::Cells;

constexpr space::Site no_site = 0xffffffff;

/// Returns the site of each input point; no_site for a duplicate.
std::vector<space::Site> sites_of(const Cells& cells, std::size_t points) {
  std::vector<space::Site> site(points, no_site);
  for (space::Site s = 0; s < cells.sites().size(); ++s) site[cells.input_index()[s]] = s;
  return site;
}

Cells cells_of(const space::ScaledPoints& scaled) {
  Threads threads;
  return Cells(scaled.points(), scaled.radius(), threads);
}

}  // namespace

class RollingBall::Inside {
 public:
  Inside(std::span<const Point3> points, std::span<const Point3> normals, double radius)
      : Inside(points, normals, space::ScaledPoints(points, radius)) {}

  std::span<const Point3> points() const { return points_; }

  std::vector<Roll> rolls(std::uint32_t a, std::uint32_t b) const {
    if (site(a) == no_site || site(b) == no_site || a == b) return {};
    return fits_double_ ? rolls<double>(a, b) : rolls<long double>(a, b);
  }
  std::vector<Triangle> triangles_from(std::uint32_t first) const {
    require_point(first);
    const space::Site v = site(first);
    if (v == no_site) return {};
    space::Rings rings;
    const GoOn never;
    meshops::Steps step(never);
    space::find_rings(cells_, fits_double_, v, v + 1, rings, step);
    std::vector<Triangle> found;
    const auto index = cells_.input_index();
    for (auto cycle = rings.points.begin(); cycle != rings.points.end();) {
      const auto end = std::find(cycle, rings.points.end(), space::Rings::end_of_cycle);
      for (auto x = cycle, y = end - 1; x != end; y = x++)
        if (index[*x] > first && index[*y] > first) found.push_back({first, index[*x], index[*y]});
      cycle = end + 1;
    }
    std::sort(found.begin(), found.end());
    return found;
  }
  bool agrees(const Triangle& triangle) const {
    for (const std::uint32_t corner : triangle) require_point(corner);
    return agreement_(triangle[0], triangle[1], triangle[2]);
  }

 private:
  void require_point(std::uint32_t i) const {
    if (i >= points_.size())
      throw meshops::ContractViolation("RollingBall: found point " + std::to_string(i) + ", expected one of " +
                                       std::to_string(points_.size()) + " points");
  }
  Inside(std::span<const Point3> points, std::span<const Point3> normals, const space::ScaledPoints& scaled)
      : points_(points.begin(), points.end()),
        normals_(normals.begin(), normals.end()),
        cells_(cells_of(scaled)),
        fits_double_(scaled.fits_double()),
        site_(sites_of(cells_, points.size())),
        agreement_(points_, normals_, cells_.duplicates()) {}

  /// The other points that the ball can touch or contain while it touches a given point, the nearest first.
  struct Near {
    std::vector<Point3> points;
    std::vector<std::uint32_t> input;
  };

  space::Site site(std::uint32_t index) const { return index < points_.size() ? site_[index] : no_site; }

  template <typename Real>
  Near near_to(std::uint32_t index) const {
    struct Distance {
      Real square;  // squared distance, rounded
      space::Site site;
    };
    const space::Site at = site(index);
    const std::span<const Point3> sites = cells_.sites();
    // The limit is rounded outward, by more than the rounding error of a distance.
    const Real radius = cells_.radius(), farthest = 4 * radius * radius * (1 + Real(0x1p-40));
    std::vector<Distance> found;
    Cells::Around(cells_).for_each_run(cells_.cell_of(at), [&](space::Site first, space::Site last) {
      for (space::Site p = first; p < last; ++p) {
        const space::Vector3<Real> d = space::from<Real>(sites[at], sites[p]);
        const Real square = space::dot(d, d);
        if (p != at && !(square > farthest)) found.push_back({square, p});
      }
    });
    std::sort(found.begin(), found.end(), [](const Distance& p, const Distance& q) {
      return p.square != q.square ? p.square < q.square : p.site < q.site;
    });
    Near near;
    for (const Distance& p : found) {
      near.points.push_back(sites[p.site]);
      near.input.push_back(cells_.input_index()[p.site]);
    }
    return near;
  }

  template <typename Real>
  std::vector<Roll> rolls(std::uint32_t a, std::uint32_t b) const {
    const Near near = near_to<Real>(a);
    const auto found = std::find(near.input.begin(), near.input.end(), b);
    if (found == near.input.end()) return {};
    const auto end = static_cast<std::size_t>(found - near.input.begin());
    std::vector<Roll> all;
    space::EdgeRoll<Real>(cells_.sites()[site(a)], end, cells_.radius(), near.points)
        .for_each_free_arc([&](std::size_t left, std::size_t touched) {
          all.push_back({near.input[left], near.input[touched]});
        });
    std::sort(all.begin(), all.end(), [](const Roll& r, const Roll& s) { return r.from < s.from; });
    return all;
  }

  std::vector<Point3> points_, normals_;
  Cells cells_;
  bool fits_double_;
  std::vector<space::Site> site_;  // the site of each input point, or no_site
  space::Agreement agreement_;
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

std::span<const Point3> RollingBall::points() const { return inside_->points(); }
std::optional<std::uint32_t> RollingBall::roll(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  for (const Roll& roll : inside_->rolls(a, b))
    if (roll.from == c) return roll.to;
  return std::nullopt;
}
std::vector<RollingBall::Roll> RollingBall::rolls(std::uint32_t a, std::uint32_t b) const {
  return inside_->rolls(a, b);
}
std::vector<RollingBall::Triangle> RollingBall::triangles_from(std::uint32_t first) const {
  return inside_->triangles_from(first);
}
bool RollingBall::agrees(const Triangle& triangle) const { return inside_->agrees(triangle); }

}  // namespace rbpa
