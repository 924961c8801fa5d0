#include "bench/contest.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iterator>
#include <string_view>

#include "bench/process.h"
#include "bench/tables.h"
#include "rbpa/hrbpa.h"
#include "rbpa/paper.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/rbpa.h"

namespace rbpa_bench {
namespace {

using Points = std::span<const rbpa::Point>;

std::size_t size_of(const rbpa::SolidAlphaComplex& found) { return found.mesh.n_faces(); }
std::size_t size_of(const rbpa::Hierarchy& found) { return found.complex.mesh.n_faces(); }
std::size_t size_of(const rbpa::AlphaComplex& found) { return found.triangles.size(); }
Triangles listed(const rbpa::SolidAlphaComplex& found) { return rbpa::triangles(found); }
Triangles listed(const rbpa::Hierarchy& found) { return rbpa::triangles(found.complex); }
Triangles listed(const rbpa::AlphaComplex& found) { return {found.triangles.begin(), found.triangles.end()}; }

template <typename Compute>
Method method(const std::string& name, Compute compute) {
  return {name, [compute](Points points, double alpha, Triangles* list) {
            const Stopwatch watch;
            const auto found = compute(points, alpha);
            const Run run = watch.run(size_of(found));
            if (list) *list = listed(found);
            return run;
          }};
}

std::string with_threads(const std::string& name, unsigned threads) {
  return threads == 1 ? name : text("%s %u threads", name.c_str(), threads);
}

Method arrays(const std::string& name, unsigned threads, bool neighbors) {
  return method(with_threads(name, threads), [=](Points points, double alpha) {
    return rbpa::alpha_complex(points, alpha, {.neighbors = neighbors, .threads = threads});
  });
}

/// Returns triangles in a form that does not depend on orientation, order and repetitions: corners ascending, the
/// lowest of equal points, sorted.
Triangles as_set(Triangles triangles, const std::vector<std::uint32_t>& lowest) {
  for (rbpa_test::Triangle& t : triangles) {
    for (std::uint32_t& corner : t) corner = lowest[corner];
    std::sort(t.begin(), t.end());
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

bool is_exact(const Method& method, double alpha) { return method.takes_alpha || std::isinf(alpha); }

}  // namespace

Method rbpa_with(unsigned threads) {
  return method(with_threads("rbpa", threads), [=](Points points, double alpha) {
    return rbpa::rbpa(points, alpha, {.threads = threads, .progress = {}});
  });
}

Method arrays_with(unsigned threads) { return arrays("arrays", threads, false); }
Method neighbors_with(unsigned threads) { return arrays("arrays, neighbors", threads, true); }

Method hrbpa(std::size_t leaf_capacity) {
  return method("hrbpa", [=](Points points, double alpha) {
    return rbpa::hrbpa(points, alpha, {.leaf_capacity = leaf_capacity, .threads = 1, .progress = {}});
  });
}

Method paper_rbpa() {
  return method("the paper's RBPA", [](Points points, double alpha) {
    return rbpa::paper::rbpa(points, alpha, {.threads = 1, .progress = {}});
  });
}

Method paper_hrbpa() {
  return method("the paper's HRBPA", [](Points points, double alpha) {
    return rbpa::paper::hrbpa(points, alpha, {.threads = 1, .progress = {}});
  });
}

std::vector<Contestant> on(Points points, double alpha, const std::vector<Method>& methods) {
  std::vector<Contestant> contestants;
  for (const Method& method : methods)
    contestants.push_back(
        {method.name, [=, run = method.run] { return run(points, alpha, nullptr); }, is_exact(method, alpha)});
  return contestants;
}

void compare_sets(Points points, double alpha, const std::vector<Method>& methods, Contest& contest) {
  const std::vector<std::uint32_t> lowest = rbpa_test::lowest_equal(points);
  Triangles expected;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    Outcome& outcome = contest.outcomes[i];
    if (!outcome.is_good() || !is_exact(methods[i], alpha)) continue;
    Triangles found, others;
    try {
      methods[i].run(points, alpha, &found);
    } catch (const std::exception& error) {
      outcome.failure = error.what();
      continue;
    }
    if (found.empty() && outcome.count > 0) continue;  // it does not list its triangles
    found = as_set(std::move(found), lowest);
    if (i == 0) expected = found;
    std::set_difference(found.begin(), found.end(), expected.begin(), expected.end(), std::back_inserter(others));
    if (!others.empty() || found.size() != expected.size())
      outcome.wrong = text("%zu of %zu triangles are others", others.size(), found.size());
  }
}

Method peer(const std::string& argument) {
  const PeerProgram program(argument);
  const auto run = [program](Points points, double, Triangles* list) {
    auto [triangles, seconds] = program.run<rbpa_test::Triangle>(points);
    const Run ended{seconds, seconds, triangles.size()};
    if (list) *list = std::move(triangles);
    return ended;
  };
  return {program.name(), run, /*takes_alpha=*/false};
}

const std::vector<Method>& cold_methods() {
  static const std::vector<Method> all = {rbpa_with(1),      rbpa_with(2),      arrays_with(1), arrays_with(2),
                                          neighbors_with(1), neighbors_with(2), cgal_points()};
  return all;
}

ColdRun run_cold(std::size_t method, const std::string& points_file) {
  const std::vector<double> told = run_again(text("--one %zu '%s'", method, points_file.c_str()), 4);
  return {{told[0], told[1], static_cast<std::size_t>(told[2])}, told[3]};
}

void answer_cold_run(int argc, char** argv) {
  if (argc != 4 || std::string_view(argv[1]) != "--one") return;
  const auto points = read_values<rbpa::Point>(argv[3]);
  const Method& method = cold_methods().at(std::stoul(argv[2]));
  Run run;
  const double bytes = rise_of_peak([&] { run = method.run(points, INFINITY, nullptr); });
  std::printf("%.9g %.9g %zu %.0f\n", run.seconds, run.processor_seconds, run.count, bytes);
  std::exit(0);
}

}  // namespace rbpa_bench
