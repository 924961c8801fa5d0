#include <doctest/doctest.h>

#include <limits>
#include <stdexcept>

#include "bench/measure.h"
#include "bench/targets.h"

using namespace rbpa_bench;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const Workload corner{"corner", [](std::size_t) { return rbpa_test::Points{{0, 0}, {1, 0}, {0, 1}, {1, 0}}; }};

Contestant finding(const std::string& name, double seconds, Triangles triangles, bool takes_alpha = true) {
  return {name,
          [=](std::span<const rbpa::Point>, double, Triangles* list) {
            if (list) *list = triangles;
            return Run{seconds, triangles.size()};
          },
          takes_alpha};
}

Contest held(const std::vector<Contestant>& contestants, bool check = false, double alpha = infinity) {
  return measure({corner, 4, alpha, "α"}, contestants, {.runs = 3, .check = check});
}

}  // namespace

TEST_CASE("contestants run in turn, and each begins a round") {
  std::string order;
  const auto noting = [&order](char letter) {
    return Contestant{std::string(1, letter), [&order, letter](std::span<const rbpa::Point>, double, Triangles*) {
                        order += letter;
                        return Run{1, 0};
                      }};
  };
  held({noting('a'), noting('b'), noting('c')});
  CHECK(order == "abcbcacab");
}

TEST_CASE("a contestant that finds another number of triangles is wrong") {
  const Contest contest = held({finding("ours", 1, {{0, 1, 2}}), finding("peer", 2, {})});
  CHECK(contest.of("peer")->wrong == "0 triangles, expected 1");
  CHECK_FALSE(speedup(contest, "ours", "peer"));
}

TEST_CASE("a contestant that ignores alpha need not find the triangles at a finite alpha") {
  const std::vector<Contestant> both{finding("ours", 1, {{0, 1, 2}}), finding("peer", 2, {}, false)};
  CHECK(held(both, true, 1.0).of("peer")->is_good());
  CHECK_FALSE(held(both, true).of("peer")->is_good());
}

TEST_CASE("triangles are compared as sets: order, orientation and repeated points do not matter") {
  const Contest contest = held(
      {finding("ours", 1, {{0, 1, 2}}), finding("turned", 3, {{2, 3, 0}}), finding("other", 3, {{0, 1, 3}})}, true);
  CHECK(contest.of("turned")->is_good());
  CHECK(speedup(contest, "ours", "turned") == 3.0);
  CHECK(contest.of("other")->wrong == "1 of 1 triangles are others");
}

TEST_CASE("a contestant that fails stays in the contest as failed") {
  int runs = 0;
  const Contestant failing{"peer", [&runs](std::span<const rbpa::Point>, double, Triangles*) -> Run {
                             if (++runs == 2) throw std::runtime_error("no memory");
                             return {1, 1};
                           }};
  const Contest contest = held({finding("ours", 1, {{0, 1, 2}}), failing});
  CHECK(contest.of("peer")->failure == "no memory");
  CHECK(runs == 2);
  CHECK_FALSE(speedup(contest, "ours", "peer"));
  CHECK_FALSE(contest.of("nobody"));
}

TEST_CASE("a target is met by the ratio of medians, and is not met without a contest") {
  Measured measured;
  const auto contest = [](const Workload& workload, std::size_t points, double ours, double peer) {
    Contest result{workload.name, "∞", points, std::vector<Outcome>(2)};
    result.outcomes[0].contestant = rbpa_with(1).name;
    result.outcomes[0].seconds.of = {ours, ours, 9};
    result.outcomes[1].contestant = cgal_points.name;
    result.outcomes[1].seconds.of = {peer, peer, 9};
    return result;
  };
  measured.delaunay = {contest(uniform, 1000, 1, 2), contest(jittered, 1024, 1, 1.9), contest(uniform, 100, 0.1, 1)};
  const auto measured_at = [&](const std::string& what) {
    for (const Target& target : targets(measured, 1000))
      if (target.what == what) return target;
    FAIL("no such target: " << what);
    return Target{};
  };
  const Target met = measured_at("uniform 1000, α = ∞: CGAL points / rbpa");
  CHECK(met.measured == 2.0);
  CHECK(is_met(met));
  CHECK_FALSE(is_met(measured_at("jittered 1000, α = ∞: CGAL points / rbpa")));
  CHECK_FALSE(measured_at("uniform 1000, α = ∞: CGAL points / rbpa 2 threads").measured);
  CHECK(measured_at("uniform 100, α = ∞: CGAL points / rbpa").measured == 10.0);
}
