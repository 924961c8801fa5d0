#include <doctest/doctest.h>

#include <string>

#include "bench/program_output.h"

using rbpa_bench::Report;
using rbpa_bench::run;

namespace {

Report report(const std::string& arguments) { return run(RBPA_BENCH_REPORT, arguments); }

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

constexpr std::size_t contests = 7;  // six sets of points, and one of them smaller, without a radius

}  // namespace

TEST_CASE("a report has peers that are right, wrong and failing in every contest without a radius") {
  const std::string none = "sh -c \": >\\\"\\$2\\\"\" peer";  // no triangles
  const Report all = report(
      "--points=200 --runs=1 --trap-points=100 --check --peer 'right=" RBPA_EXAMPLE_PEER "' --peer 'none=" + none +
      "' --peer='failing=sh -c \"echo no memory >&2; exit 3\"'");
  CHECK(all.code == 0);
  CHECK(all.text.find("| CGAL indices | right | none | failing |") != std::string::npos);
  CHECK(count(all.text, "**wrong**: 0 triangles, expected ") == contests);
  CHECK(count(all.text, "**wrong**") == contests);
  CHECK(count(all.text, "**failed**: ended with 3: no memory") == contests);
  CHECK(all.text.find("right: another program; time as it says itself") != std::string::npos);
  CHECK(all.text.find("none: another program; time of its whole process") != std::string::npos);
}

TEST_CASE("a report ends with the targets, which name what was not measured") {
  const Report all = report("--points=200 --runs=1 --trap-points=0");
  CHECK(all.code == 0);
  CHECK(all.text.find("| uniform 200, α = ∞: CGAL points / rbpa ≥ 2 | ") != std::string::npos);
  CHECK(all.text.find("| uniform, α = ∞, a point: at 3200 / at 20 ≤ 1.35 | – | not measured |") != std::string::npos);
}

TEST_CASE("an unknown argument is refused with the usage") {
  for (const char* argument : {"--points=ten", "--points=10", "--runs=0", "--threads=1,", "--threads=", "--peer=name",
                               "--peer", "--peer==command", "--quick"}) {
    CAPTURE(argument);
    const Report refused = report(argument);
    CHECK(refused.code == 2);
    CHECK(refused.text.find(std::string("found '") + argument + "'\nusage: ") != std::string::npos);
  }
}

TEST_CASE("cold runs measure every set with every contestant, with the same triangles, and print targets") {
  const Report all = run(RBPA_BENCH_COLD, "--points=400 --runs=1");
  CHECK(all.code == 0);
  CHECK(all.text.find("**wrong**") == std::string::npos);
  CHECK(all.text.find("| points | number | rbpa | rbpa 2 threads | arrays |") != std::string::npos);
  for (const char* set : {"uniform", "jittered", "grid", "lidar lines", "clusters", "Kuzmin"}) {
    CAPTURE(set);
    CHECK(count(all.text, std::string("| ") + set + " | 400 |") == 3);
    CHECK(count(all.text, std::string("| ") + set + ": CGAL points / arrays ≥ ") == 1);
  }
  CHECK(run(RBPA_BENCH_COLD, "--points=none").code == 2);
}

TEST_CASE("slow paths are at least eighty sets, on which rbpa, hrbpa and CGAL find as many triangles") {
  const Report all = run(RBPA_BENCH_SLOW_PATHS, "--points=500 --runs=1");
  CHECK(all.code == 0);
  CHECK(all.text.find("### 500 points") != std::string::npos);
  CHECK(all.text.find("### 40 points") != std::string::npos);
  const std::size_t lines_beside_the_sets = 24;
  CHECK(count(all.text, "\n") > 2 * 80 + lines_beside_the_sets);
  CHECK(count(all.text, "**wrong**") == 0);
  CHECK(count(all.text, "**failed**") == 0);
  CHECK(count(all.text, "times as long as uniform") == 4);
}
