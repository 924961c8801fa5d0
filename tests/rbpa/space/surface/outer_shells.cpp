#include "rbpa/space/surface/outer_shells.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "meshops/core/contract.h"
#include "support/arguments.h"
#include "support/space_sets.h"
#include "support/spiral.h"
#include "support/triangle.h"
#include "support/vectors.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::Surface;
using rbpa::SurfaceComponents;

TEST_SUITE_BEGIN("space");

namespace {

void add_sphere(Points3& points, const Point3& center, double radius, int count) {
  for (const Point3& p : spiral(count)) points.push_back(center + radius * p);
}

struct Shells {
  Surface surface;
  SurfaceComponents components;
  std::vector<bool> outer;

  Shells(const Points3& points, double radius)
      : surface(rbpa::exposed_triangles(points, radius)),
        components(rbpa::surface_components(points, surface)),
        outer(rbpa::outer_shells(points, radius, surface, components)) {}

  std::ptrdiff_t count() const { return std::count(outer.begin(), outer.end(), true); }
};

using Vector = std::array<long double, 3>;

/// Returns how often a shell winds around a place, by the solid angles of its triangles (Van Oosterom and Strackee,
/// 1983).
long double winding(const Points3& points, const Shells& shells, std::uint32_t shell, const Vector& at) {
  long double sum = 0;
  for (std::size_t t = 0; t < shells.surface.triangles.size(); ++t) {
    if (shells.components.number[t] != shell) continue;
    std::array<Vector, 3> v;
    std::array<long double, 3> length;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3& p = points[shells.surface.triangles[t][k]];
      v[k] = {p.x - at[0], p.y - at[1], p.z - at[2]};
      length[k] = std::hypot(v[k][0], v[k][1], v[k][2]);
    }
    const auto dot = [&](std::size_t i, std::size_t j) {
      return v[i][0] * v[j][0] + v[i][1] * v[j][1] + v[i][2] * v[j][2];
    };
    const long double triple = v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) +
                               v[0][1] * (v[1][2] * v[2][0] - v[1][0] * v[2][2]) +
                               v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
    sum += std::atan2(triple, length[0] * length[1] * length[2] + dot(0, 1) * length[2] + dot(1, 2) * length[0] +
                                  dot(2, 0) * length[1]);
  }
  return sum / (2 * static_cast<long double>(M_PI));
}

/// Returns the center of the ball on a triangle: on the normal through the point that is equally far from all corners.
Vector center_of(const Points3& points, const Triangle& triangle, double radius, long double* height) {
  const Point3 &a = points[triangle[0]], &b = points[triangle[1]], &c = points[triangle[2]];
  const Vector u = {(long double)b.x - a.x, (long double)b.y - a.y, (long double)b.z - a.z};
  const Vector v = {(long double)c.x - a.x, (long double)c.y - a.y, (long double)c.z - a.z};
  const Vector n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const auto dot = [](const Vector& p, const Vector& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; };
  // s u + t v has the same product with u as u²/2, and with v as v²/2.
  const long double uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), det = uu * vv - uv * uv;
  const long double s = vv * (uu - uv) / (2 * det), t = uu * (vv - uv) / (2 * det);
  Vector center;
  for (std::size_t k = 0; k < 3; ++k) center[k] = s * u[k] + t * v[k];
  *height = std::sqrt(std::max((long double)radius * radius - dot(center, center), 0.0L));
  const long double length = std::sqrt(dot(n, n));
  const Vector from = {a.x, a.y, a.z};
  for (std::size_t k = 0; k < 3; ++k) center[k] += from[k] + *height * n[k] / length;
  return center;
}

}  // namespace

TEST_CASE("the shell around a closed body is outer, and the one inside is not") {
  Points3 points;
  add_sphere(points, {5, -3, 2}, 1, 400);
  const Shells one(points, 0.3);
  REQUIRE(one.components.all.size() == 2);
  CHECK(one.outer == std::vector<bool>{true, false});  // areas are equal, the outer shell encloses more
  CHECK(one.components.all[0].volume == doctest::Approx(-one.components.all[1].volume));

  // A ball inside is not outer, however far from the shell; a ball outside is.
  add_sphere(points, {5, -3, 2}, 0.2, 100);
  const Shells nested(points, 0.15);
  CHECK(nested.components.all.size() > 2);
  CHECK(nested.count() == 1);
  add_sphere(points, {5, -1, 2}, 0.2, 100);
  CHECK(Shells(points, 0.15).count() == 2);
}

TEST_CASE("a sheet is outer on both sides") {
  const Points3 points = corners_of_bricks(9, 9, 1);
  const Shells sheet(points, 1);
  REQUIRE(sheet.components.all.size() == 1);
  CHECK(sheet.outer == std::vector<bool>{true});
  CHECK(sheet.components.all[0].volume == 0);
}

TEST_CASE("shells are outer if and only if no shell winds around any ball that rests on them") {
  Random random(311);
  std::size_t inner = 0, outer = 0;
  for (int trial = 0; trial < trials(400); ++trial) {
    const auto kind = static_cast<SpaceKind>(random.below(space_kinds));
    if (kind == SpaceKind::extreme) continue;  // solid angles have no digits there
    CAPTURE(name(kind));
    CAPTURE(trial);
    const Points3 points = space_set(kind, 10 + random.below(60), random);
    const double radius = space_radius(points, random);
    double greatest = 0;
    for (const Point3& p : points) greatest = std::max({greatest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    if (radius < 1e-9 * greatest) continue;  // centers are rounded to the last bits of the coordinates
    const Shells shells(points, radius);
    REQUIRE(shells.outer.size() == shells.components.all.size());
    if (!shells.outer.empty()) CHECK(shells.count() > 0);
    for (std::size_t t = 0; t < shells.surface.triangles.size(); ++t) {
      long double height = 0;
      const Vector at = center_of(points, shells.surface.triangles[t], radius, &height);
      if (!(height >= 1e-6L * radius)) continue;  // the center may be on the surface, or anywhere
      const auto is_off = [&](std::uint32_t corner) {
        const Point3& p = points[corner];
        return std::abs(std::hypot(p.x - at[0], p.y - at[1], p.z - at[2]) - radius) > 1e-9L * radius;
      };
      const Triangle& corners = shells.surface.triangles[t];
      if (std::any_of(corners.begin(), corners.end(), is_off)) continue;  // nearly a line, whose ball may be anywhere
      bool is_outside = true, is_certain = true;
      for (std::uint32_t shell = 0; shell < shells.outer.size(); ++shell) {
        const long double turns = winding(points, shells, shell, at);
        is_certain = is_certain && std::abs(turns - std::round(turns)) <= 1e-3L;
        is_outside = is_outside && std::lround(turns) == 0;
      }
      if (!is_certain) continue;  // solid angles near the surface have too few digits
      REQUIRE(shells.outer[shells.components.number[t]] == is_outside);
      ++(is_outside ? outer : inner);
    }
  }
  CHECK(outer > 2000);
  CHECK(inner > 50);  // compilers draw different sets, as they evaluate arguments in different orders
}

TEST_CASE("a surface that is not closed is refused") {
  Points3 points;
  add_sphere(points, {0, 0, 0}, 1, 100);
  const Surface open = rbpa::surface(points, Points3(points.size(), {0, 0, 1}), 0.4);
  CHECK_THROWS_AS(rbpa::outer_shells(points, 0.4, open, rbpa::surface_components(points, open)),
                  meshops::ContractViolation);
  const Shells shells(points, 0.4);
  CHECK_THROWS_AS(rbpa::outer_shells(points, 0.4, shells.surface, {}), meshops::ContractViolation);
  CHECK(rbpa::outer_shells({}, 1, {}, {}).empty());
}

TEST_CASE("nesting depths count bodies in bodies and walls of cavities, and ignore open and touching surfaces") {
  Points3 points;
  Surface surface;
  const auto add_cube = [&](const Point3& at, double size, bool outward, bool open = false) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (unsigned i = 0; i < 8; ++i)
      points.push_back({at.x + size * (i & 1U), at.y + size * (i >> 1U & 1U), at.z + size * (i >> 2U & 1U)});
    constexpr std::array<std::array<std::uint32_t, 4>, 6> sides{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    std::vector<std::array<std::uint32_t, 3>> rows;
    for (const auto& [a, b, c, d] : sides) {
      if (open && rows.size() == 10) break;
      rows.push_back({first + a, first + b, first + c});
      rows.push_back({first + a, first + c, first + d});
    }
    for (auto& row : rows) {
      if (!outward) std::swap(row[1], row[2]);
      std::rotate(row.begin(), std::min_element(row.begin(), row.end()), row.end());
    }
    const auto begin = static_cast<std::uint32_t>(surface.triangles.size());
    for (std::uint32_t t = 0; t < rows.size(); ++t) {
      auto& across = surface.neighbors.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        across[k] = Surface::none;
        for (std::uint32_t u = 0; u < rows.size(); ++u)
          for (std::size_t j = 0; j < 3; ++j)
            if (rows[u][j] == rows[t][(k + 2) % 3] && rows[u][(j + 1) % 3] == rows[t][(k + 1) % 3])
              across[k] = begin + u;
      }
    }
    surface.triangles.insert(surface.triangles.end(), rows.begin(), rows.end());
  };
  add_cube({0, 0, 0}, 8, true);
  add_cube({1, 1, 1}, 6, false);       // its cavity
  add_cube({2, 2, 2}, 1, true);        // a body in the cavity
  add_cube({4, 4, 4}, 2, true, true);  // an open body
  add_cube({8, 8, 8}, 3, true);        // touches the first body from outside
  add_cube({20, 2, 2}, 1, true);       // in line with the inner bodies
  surface.distinct = points.size();
  const SurfaceComponents components = rbpa::surface_components(points, surface);
  REQUIRE(components.all.size() == 6);
  const std::vector<std::size_t> depths = rbpa::nesting_depths(points, surface, components);
  const std::array<std::size_t, 6> right{0, 1, 2, 0, 0, 0};  // in the order in which they are added
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    CHECK(depths[components.number[t]] == right[surface.triangles[t][0] / 8]);
  CHECK(rbpa::nesting_depths({}, rbpa::Surface{}, {}).empty());
  CHECK_THROWS_AS(rbpa::nesting_depths(points, surface, SurfaceComponents{}), meshops::ContractViolation);
}

TEST_CASE("corners in the plane and in the box of a triangle, but not on it, are inside or outside as they are") {
  // A box with half of its ceiling at z = 0, and half at z = 8.
  const Points3 points = {{0, 0, -8}, {8, 0, -8}, {8, 8, -8}, {0, 8, -8}, {0, 0, 0}, {8, 0, 0}, {0, 8, 0},
                          {8, 0, 8},  {8, 8, 8},  {0, 8, 8},  {5, 5, 0},  {6, 5, 0}, {5, 6, 0}, {3, 3, 0}};
  const std::vector<Triangle> outer = {{0, 1, 2}, {0, 2, 3}, {0, 3, 6}, {0, 6, 4}, {0, 1, 5}, {0, 5, 4},
                                       {1, 2, 5}, {5, 2, 8}, {5, 8, 7}, {3, 2, 6}, {6, 2, 8}, {6, 8, 9},
                                       {4, 5, 6}, {5, 6, 9}, {5, 9, 7}, {7, 8, 9}};
  const std::vector<std::vector<Triangle>> surfaces = {outer, {{10, 11, 12}, {10, 12, 11}}};
  CHECK(rbpa::nesting_depths(points, surfaces) == std::vector<std::size_t>{0, 1});
  // With one corner on the ceiling the others decide; the whole may be turned.
  const std::vector<std::vector<Triangle>> touching = {outer, {{13, 11, 12}, {13, 12, 11}}};
  for (int turn = 0; turn < 3; ++turn) {
    CAPTURE(turn);
    Points3 turned;
    for (const Point3& p : points)
      turned.push_back(turn == 0 ? p : turn == 1 ? Point3{p.y, p.z, p.x} : Point3{p.z, p.x, p.y});
    CHECK(rbpa::nesting_depths(turned, surfaces) == std::vector<std::size_t>{0, 1});
    CHECK(rbpa::nesting_depths(turned, touching) == std::vector<std::size_t>{0, 1});
  }
}

TEST_SUITE_END();
