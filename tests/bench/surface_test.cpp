#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "bench/surface_contest.h"
#include "rbpa/space/surface/surface_mesh.h"

using namespace rbpa_bench;

namespace {

Contest hold(const SurfaceContestant& contestant) {
  return measure_surface(on_sphere(1000, 0), 2, {surface_with(1), contestant}, {.runs = 1});
}
std::string failure(const std::string& command) { return hold(surface_program("one", command)).outcomes[1].failure; }

}  // namespace

TEST_CASE("points on the sphere and on the double torus have the stated spacing, and the surface of their genus") {
  const SurfacePoints sphere = on_sphere(5000, 0), noisy = on_sphere(5000, 0.1), torus = on_double_torus(20000);
  CHECK(sphere.points.size() == 5000);
  CHECK(std::abs(static_cast<double>(torus.points.size()) - 20000) < 500);
  for (const SurfacePoints* samples : {&sphere, &noisy, &torus}) {
    CAPTURE(samples->name);
    const auto& points = samples->points;
    const rbpa::Surface surface = rbpa::surface(points, samples->normals, 2 * samples->spacing);
    for (const auto& across : surface.neighbors)
      REQUIRE(std::count(across.begin(), across.end(), rbpa::Surface::none) == 0);
    const auto made = rbpa::surface_mesh(points, surface);
    const int euler = static_cast<int>(made.mesh.n_vertices()) - static_cast<int>(made.mesh.n_edges()) +
                      static_cast<int>(made.mesh.n_faces());
    CHECK(euler == (samples == &torus ? -2 : 2));
    double area = 0;
    for (const auto& corners : surface.triangles) {
      const rbpa::Point3& a = points[corners[0]];
      const auto minus = [&](std::uint32_t i) {
        return rbpa::Point3{points[i].x - a.x, points[i].y - a.y, points[i].z - a.z};
      };
      const rbpa::Point3 u = minus(corners[1]), v = minus(corners[2]);
      area += std::hypot(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x) / 2;
    }
    CHECK(samples->spacing == doctest::Approx(std::sqrt(area / static_cast<double>(points.size()))).epsilon(0.03));
  }
}

TEST_CASE(
    "the mesh and the policy on the engine have the triangles of the arrays, and other triangles are reported as "
    "wrong") {
  for (const SurfaceContestant& exact : {surface_with(2), surface_mesh_with(1), ball_pivoting_on_engine()}) {
    const Contest contest = hold(exact);
    CHECK(contest.outcomes[0].triangles == 1996);
    CHECK(contest.outcomes[1].is_good());
    CHECK(contest.outcomes[1].seconds.of.size() == 1);
  }
  const SurfaceContestant wrong{"wrong", [](const SurfacePoints&, double) { return Run{1, 7}; }};
  CHECK(hold(wrong).outcomes[1].wrong == "7 triangles, expected 1996");
}

TEST_CASE("a program reads the points as PLY, receives the radius, and the faces of its mesh are counted") {
  const Contest contest = hold(surface_program(
      "one", R"sh(printf 'ply\nelement face 12\nend_header\n' >{out} && grep -aq 'element vertex 1000' {in} &&)sh"
             R"sh( test $(wc -c <{in}) -gt 48000 && echo {radius} | grep -q '^0.22' && echo seconds 0.5 >&2)sh"));
  CHECK(contest.outcomes[1].failure == "");
  CHECK(contest.outcomes[1].triangles == 12);
  CHECK(contest.outcomes[1].seconds.of == std::vector{0.5});
  CHECK(contest.outcomes[1].clock == Clock::peer);
}

TEST_CASE("a program that fails is reported with the reason, and a command that cannot work is refused") {
  CHECK(failure(": {in} {out}") == "wrote no mesh");
  CHECK(failure("cp {in} {out}") == "wrote PLY without faces");
  CHECK(failure("echo no >{out}; : {in}") == "wrote something that is not PLY");
  CHECK(failure(": {in} {out}; exit 3") == "ended with 3");
  CHECK_THROWS_AS(surface_program("one", "mine {in}"), std::invalid_argument);
  CHECK_THROWS_AS(surface_program("one", "mine {out}"), std::invalid_argument);
}
