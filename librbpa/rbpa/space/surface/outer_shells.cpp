#include "rbpa/space/surface/outer_shells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "meshops/core/contract.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/base/triangle_arrays.h"
#include "rbpa/space/cells/check_input.h"
#include "rbpa/space/predicate/ray_along_x.h"
#include "rbpa/space/predicate/vector3.h"
#include "rbpa/space/surface/levels/sub_surface.h"

namespace rbpa {
namespace {

using Real = long double;  // products of double coordinates do not overflow
using LongVector = space::Vector3<Real>;

/// The ball of the radius that rests on a triangle.
class RestingBall {
 public:
  RestingBall(std::span<const Point3> points, const Triangle& triangle, Real radius) : a_(points[triangle[0]]) {
    const Point3 &b = points[triangle[1]], &c = points[triangle[2]];
    const LongVector u = space::from<Real>(a_, b), v = space::from<Real>(a_, c), w = space::from<Real>(b, c);
    const Real uu = space::dot(u, u), vv = space::dot(v, v);
    normal_ = space::cross(u, v);
    const Real nn = space::dot(normal_, normal_);
    const LongVector to_u = space::cross(v, normal_), to_v = space::cross(normal_, u);
    circumcenter_ = {(uu * to_u.x + vv * to_v.x) / (2 * nn), (uu * to_u.y + vv * to_v.y) / (2 * nn),
                     (uu * to_u.z + vv * to_v.z) / (2 * nn)};
    // The height of the center above the triangle, in units of the length of the normal.
    height_ = std::sqrt(std::max(radius * radius - uu * vv * space::dot(w, w) / (4 * nn), Real(0)) / nn);
    clearance_ = height_ * std::sqrt(nn);
    const LongVector to_center = {circumcenter_.x + height_ * normal_.x, circumcenter_.y + height_ * normal_.y,
                                  circumcenter_.z + height_ * normal_.z};
    for (const LongVector& side : {LongVector{0, 0, 0}, u, v}) {
      const LongVector d = {to_center.x - side.x, to_center.y - side.y, to_center.z - side.z};
      error_ = std::max(error_, std::abs(std::sqrt(space::dot(d, d)) - radius));
    }
  }

  /// Returns the distance from the triangle to the center, minus the possible rounding error: the center at a nearly
  /// degenerate triangle may be anywhere.
  Real clearance() const { return clearance_ - 1000 * error_; }
  Point3 center() const {
    const auto sum = [&](double from, Real at, Real along) { return static_cast<double>(from + at + height_ * along); };
    return {sum(a_.x, circumcenter_.x, normal_.x), sum(a_.y, circumcenter_.y, normal_.y),
            sum(a_.z, circumcenter_.z, normal_.z)};
  }

 private:
  Point3 a_;
  LongVector normal_{}, circumcenter_{};
  Real height_ = 0, clearance_ = 0, error_ = 0;
};

/// Calls visit(component, i) for each component that winds around place i. A triangle is compared only with the places
/// within its range of y. Requires: coordinates of places are within the range of the points' coordinates.
template <typename Visit>
void for_each_enclosed(std::span<const Point3> points, const Surface& shells, const SurfaceComponents& components,
                       std::span<const Point3> places, Steps& step, const Visit& visit) {
  std::vector<std::uint32_t> by_y(places.size()), by_shell(shells.triangles.size());
  std::iota(by_y.begin(), by_y.end(), std::uint32_t{0});
  std::sort(by_y.begin(), by_y.end(), [&](std::uint32_t i, std::uint32_t j) { return places[i].y < places[j].y; });
  std::iota(by_shell.begin(), by_shell.end(), std::uint32_t{0});
  sort(by_shell, step, [&](std::uint32_t t, std::uint32_t u) {
    const std::uint32_t c = components.number[t], d = components.number[u];
    return c != d ? c < d : t < u;
  });
  std::vector<int> winding(places.size(), 0);
  std::vector<std::uint32_t> crossed;
  for (std::size_t first = 0, last = 0; first < by_shell.size(); first = last) {
    const std::uint32_t shell = components.number[by_shell[first]];
    crossed.clear();
    for (; last < by_shell.size() && components.number[by_shell[last]] == shell; ++last) {
      const Triangle& triangle = shells.triangles[by_shell[last]];
      const std::array corners = {points[triangle[0]], points[triangle[1]], points[triangle[2]]};
      const auto [low_y, high_y] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
      const auto [low_z, high_z] = std::minmax({corners[0].z, corners[1].z, corners[2].z});
      auto near =
          std::lower_bound(by_y.begin(), by_y.end(), low_y, [&](std::uint32_t i, double y) { return places[i].y < y; });
      for (step(); near != by_y.end() && places[*near].y <= high_y; ++near) {
        step();
        if (places[*near].z < low_z || places[*near].z > high_z) continue;
        const int turn = space::crossing(corners, places[*near]);
        if (turn == 0) continue;
        winding[*near] += turn;
        crossed.push_back(*near);
      }
    }
    for (const std::uint32_t i : crossed)
      if (std::exchange(winding[i], 0) != 0) visit(shell, i);
  }
}

void require_components(const char* function, std::span<const Point3> points, const Surface& surface,
                        const SurfaceComponents& components) {
  meshops::require_one_each(function, components.number.size(), "numbers of components", surface.triangles.size(),
                            "triangles");
  require_linked(space::arrays_of(surface), points.size());
  for (const std::uint32_t c : components.number)
    if (c >= components.all.size())
      throw meshops::ContractViolation(std::string(function) + ": found component " + std::to_string(c) +
                                       " of a triangle, expected a component that exists, as surface_components() "
                                       "numbers them");
}

}  // namespace

std::vector<bool> outer_shells(std::span<const Point3> points, double radius, const Surface& shells,
                               const SurfaceComponents& components, const GoOn& go_on) {
  space::check_radius(radius);
  const std::size_t count = components.all.size();
  require_components("outer_shells", points, shells, components);
  for (const SurfaceComponent& component : components.all)
    meshops::require(
        component.is_closed(),
        "outer_shells: found a component with a boundary, expected closed ones, as exposed_triangles() has");

  // For each shell, finds the ball whose center is highest above its triangle, where rounding matters least.
  Steps step(go_on);
  std::vector<Real> clearance(count, -std::numeric_limits<Real>::infinity());
  std::vector<Point3> center(count);
  for (std::size_t t = 0; t < shells.triangles.size(); ++t) {
    step(4);
    const std::uint32_t c = components.number[t];
    const RestingBall ball(points, shells.triangles[t], radius);
    if (!(ball.clearance() > clearance[c])) continue;
    clearance[c] = ball.clearance();
    center[c] = ball.center();
  }
  std::vector<bool> outer(count, true);
  for_each_enclosed(points, shells, components, center, step,
                    [&](std::uint32_t, std::uint32_t c) { outer[c] = false; });
  return outer;
}

std::vector<std::size_t> nesting_depths(std::span<const Point3> points, const Surface& surface,
                                        const SurfaceComponents& components, const GoOn& go_on) {
  require_components("nesting_depths", points, surface, components);
  std::vector<std::vector<Triangle>> closed(components.all.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    if (const std::uint32_t c = components.number[t]; components.all[c].is_closed())
      closed[c].push_back(surface.triangles[t]);
  return nesting_depths(points, closed, go_on);
}

}  // namespace rbpa
