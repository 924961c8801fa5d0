#include "bench/contest.h"

#include <chrono>
#include <cmath>

#include "rbpa/rbpa.h"
#include "support/generate.h"

namespace rbpa_bench {
namespace {

Run timed(std::span<const rbpa::Point> points, double alpha, rbpa::Search search) {
  const auto start = std::chrono::steady_clock::now();
  const rbpa::SolidAlphaComplex complex = rbpa::rbpa(points, alpha, {.search = search, .progress = {}});
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  return {seconds.count(), complex.mesh.n_faces()};
}

int columns(std::size_t count) { return static_cast<int>(std::lround(std::sqrt(static_cast<double>(count)))); }

}  // namespace

Run run_rbpa(std::span<const rbpa::Point> points, double alpha) {
  return timed(points, alpha, rbpa::Search::near_to_far);
}

Run run_rbpa_paper_grid(std::span<const rbpa::Point> points, double alpha) {
  return timed(points, alpha, rbpa::Search::paper_grid);
}

const Workload uniform{"uniform", [](std::size_t count) { return rbpa_test::uniform(count, 1); }};
const Workload jittered{"jittered", [](std::size_t count) { return rbpa_test::jittered_grid(columns(count), 0.9, 2); }};
const Workload grid{"grid", [](std::size_t count) { return rbpa_test::perfect_grid(columns(count), 1); }};

}  // namespace rbpa_bench
