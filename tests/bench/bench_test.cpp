// What: tests of the benchmarks: contests, peers, and each program that performance.md names first, on few points.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "bench/contest.h"
#include "bench/process.h"
#include "bench/surface_points.h"
#include "bench/workload.h"
#include "rbpa/space/surface/surface_mesh.h"

using namespace rbpa_bench;

namespace {

const rbpa_test::Points corner{{0, 0}, {1, 0}, {0, 1}, {1, 0}};

Method finding(const std::string& name, double seconds, const Triangles& triangles, bool takes_alpha = true) {
  return {name,
          [=](std::span<const rbpa::Point>, double, Triangles* list) {
            if (list) *list = triangles;
            return Run{seconds, seconds, triangles.size()};
          },
          takes_alpha};
}

/// Holds a contest, and compares sets.
Contest held(const std::vector<Method>& methods, double alpha = INFINITY) {
  Contest contest{"corner", "α", corner.size(), in_turn(on(corner, alpha, methods), {.runs = 3})};
  compare_sets(corner, alpha, methods, contest);
  return contest;
}

/// Returns why a peer has no result.
std::string failure(const std::string& command) {
  return held({finding("ours", 1, {}), peer("peer=" + command)}).outcomes[1].failure;
}

/// Returns standard output and standard error of a program that ends with `code`.
std::string output(const std::string& command, int code = 0) {
  std::FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string text;
  char part[4096];
  for (std::size_t size; (size = fread(part, 1, sizeof part, pipe)) > 0;) text.append(part, size);
  CHECK(WEXITSTATUS(pclose(pipe)) == code);
  return text;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("contestants run in turn, each begins a round, and one that fails is not run again") {
  std::string order;
  std::vector<Contestant> all;
  for (const char letter : {'a', 'b', 'c'})
    all.push_back({std::string(1, letter), [&order, letter] {
                     order += letter;
                     if (letter == 'c' && order.size() > 5) throw std::runtime_error("no memory");
                     return Run{1, 1, 0};
                   }});
  const std::vector<Outcome> of = in_turn(all, {.runs = 4});
  CHECK(order == "abcbcacabab");
  CHECK(of[2].failure == "no memory");
  CHECK(of[0].seconds.of.size() == 4);
}

TEST_CASE("times have a least, a lower quartile and a median") {
  const Timings times{{5, 1, 2, 4}};
  CHECK(times.least() == 1);
  CHECK(times.lower_quartile() == 1);
  CHECK(times.median() == 3);
  CHECK(times.text(1, 10) == "30.0 (10.0–50.0)");
}

TEST_CASE("a method that finds other triangles is wrong: order, orientation and repeated points do not matter") {
  const Contest contest = held({finding("ours", 1, {{0, 1, 2}}), finding("turned", 3, {{2, 3, 0}}),
                                finding("other", 3, {{0, 1, 3}}), finding("none", 3, {})});
  CHECK(contest.ratio("turned", "ours") == 3);
  CHECK(contest.outcomes[2].wrong == "1 of 1 triangles are others");
  CHECK(contest.outcomes[3].wrong == "found 0, expected 1");
  CHECK(std::isnan(contest.ratio("other", "ours")));
  CHECK(std::isnan(contest.ratio("nobody", "ours")));
}

TEST_CASE("a method that ignores alpha need not find the triangles at a finite alpha") {
  const std::vector<Method> both{finding("ours", 1, {{0, 1, 2}}), finding("peer", 2, {}, false)};
  CHECK(held(both, 1).outcomes[1].is_good());
  CHECK_FALSE(held(both).outcomes[1].is_good());
}

TEST_CASE("the example of a peer finds what rbpa finds, and a peer that fails is reported with the reason") {
  const rbpa_test::Points points = grid.make(400);
  Triangles ours, theirs;
  CHECK(rbpa_with(1).run(points, INFINITY, &ours).count == 722);
  CHECK(peer("example=" RBPA_EXAMPLE_PEER).run(points, INFINITY, &theirs).count == 722);
  CHECK(rbpa_test::canonical(theirs) == rbpa_test::canonical(ours));
  CHECK(failure("sh -c 'echo no memory >&2; exit 3' peer") == "ended with 3: no memory");
  CHECK(failure("sh -c 'kill -9 $$' peer").starts_with("ended "));  // the shell may turn signal 9 into 137
  CHECK(failure("true").find("result: cannot be read") != std::string::npos);
  CHECK(failure("sh -c 'printf 1234567 >\"$2\"' peer").find("is incomplete") != std::string::npos);
  CHECK(failure("sh -c 'printf \"\\000\\000\\000\\000\\001\\000\\000\\000\\011\\000\\000\\000\" >\"$2\"' peer") ==
        "named point 9 of 4");
  CHECK_THROWS_AS(peer("name"), std::invalid_argument);
}

TEST_CASE("a report has peers in every contest without a radius") {
  const std::string all = output("'" RBPA_BENCH_REPORT "' --points=1K --runs=1 --check --peer 'right=" RBPA_EXAMPLE_PEER
                                 "' --peer='failing=sh -c \"echo no memory >&2; exit 3\"'");
  constexpr std::size_t contests = 7;  // six sets of points, and one of them smaller
  CHECK(all.find("| CGAL indices | right | failing |") != std::string::npos);
  CHECK(count(all, "**wrong**") == 0);
  CHECK(count(all, "**failed**: ended with 3: no memory") == contests);
  for (const char* argument :
       {"--points=ten", "--runs=0", "--threads=1,", "--threads=", "--peer=", "--quick", "more"}) {
    CAPTURE(argument);
    CHECK(output(std::string("'" RBPA_BENCH_REPORT "' ") + argument, 2).find("usage: ") != std::string::npos);
  }
  CHECK(output("'" RBPA_BENCH_REPORT "' --help").starts_with("usage: "));
}

TEST_CASE("cold runs measure every set with every method, with the same triangles") {
  const std::string all = output("'" RBPA_BENCH_COLD "' --points=400 --runs=1");
  CHECK(all.find("**wrong**") == std::string::npos);
  for (const char* set : {"uniform", "jittered", "grid", "lidar lines", "clusters", "Kuzmin"}) {
    CAPTURE(set);
    CHECK(count(all, std::string("| ") + set + " | 400 |") == 2);
  }
}

TEST_CASE("slow paths are 112 sets, on which rbpa, hrbpa and CGAL find as many triangles") {
  const std::string all = output("'" RBPA_BENCH_SLOW_PATHS "' --points=500 --runs=1");
  CHECK(all.find("### 40 points") != std::string::npos);
  CHECK(count(all, "112 sets, ") == 2);
  CHECK(count(all, "**wrong**") == 0);
  CHECK(count(all, "**failed**") == 0);
}

TEST_CASE("points on the sphere and on the double torus have the stated spacing, and the surface of their genus") {
  const SurfacePoints sphere = on_sphere(5000, 0), noisy = on_sphere(5000, 0.1), torus = on_double_torus(20000);
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
