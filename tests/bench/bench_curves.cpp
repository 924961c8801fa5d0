// Measures the data of the figures of docs/reference/performance.md: time per point against the number of points,
// against alpha,
// and against the unevenness of the points. Writes performance_scaling.csv, performance_alpha.csv and
// performance_density.csv, each complete or not at all, which draw_figures draws; values are medians in nanoseconds per
// point.
//   bench_curves [--runs=N] [--points=N] [--threads=1,2] FOLDER   5 runs of each; 1,000,000 points and up to 16 times
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/machine.h"
#include "bench/measure.h"
#include "bench/memory.h"

namespace rbpa_bench {
namespace {

/// Contestant with the name of its column.
struct Column {
  std::string name;
  Contestant contestant;
};

/// File with one curve for each contestant, written beside its target and renamed when everything is measured.
class CurveFile {
 public:
  /// Starts a file whose first column is `x`; the number of points is another column, unless it is `x`.
  CurveFile(std::filesystem::path path, const std::string& x, std::vector<Column> columns, const std::string& what,
            int runs)
      : path_(std::move(path)),
        beside_(path_.string() + ".part"),
        columns_(std::move(columns)),
        runs_(runs),
        x_is_points_(x == "points") {
    text_ = "# " + today() + "; " + processor() + "; " + memory() + "; " + compiler() + " " + compiler_flags() +
            "; medians of " + std::to_string(runs) + " runs\n# " + what + "\n" + x + (x_is_points_ ? "" : ",points") +
            ",triangles";
    for (const Column& column : columns_) text_ += "," + column.name;
    text_ += "\n";
  }

  void measure(double x, const Task& task) {
    std::vector<Contestant> contestants;
    for (const Column& column : columns_) contestants.push_back(column.contestant);
    const Contest contest = rbpa_bench::measure(task, contestants, {.runs = runs_, .warm = true});
    add("%.9g", x);
    if (!x_is_points_) add(",%.0f", static_cast<double>(contest.points));
    add(",%.0f", static_cast<double>(contest.outcomes[0].triangles));
    for (const Outcome& outcome : contest.outcomes) {
      if (!outcome.failure.empty()) throw std::runtime_error(outcome.contestant + ": " + outcome.failure);
      if (!outcome.wrong.empty())
        std::fprintf(stderr, "%s: %s\n", outcome.contestant.c_str(), outcome.wrong.c_str());  // CGAL's filter rounds
      add(",%.4g", contest.nanoseconds_a_point(outcome));
    }
    text_ += "\n";
    std::fprintf(stderr, "%s: %g\n", path_.filename().c_str(), x);
  }

  void publish() const {
    std::ofstream out(beside_, std::ios::binary);
    out << text_;
    out.close();
    if (!out) throw std::runtime_error(beside_.string() + ": cannot be written");
    std::filesystem::rename(beside_, path_);
  }

 private:
  void add(const char* format, double value) {
    char number[32];
    std::snprintf(number, sizeof number, format, value);
    text_ += number;
  }

  std::filesystem::path path_, beside_;
  std::vector<Column> columns_;
  int runs_;
  bool x_is_points_;
  std::string text_;
};

/// Returns our columns, CGAL's best case, and another contestant.
std::vector<Column> columns_with(const std::vector<unsigned>& threads, const std::string& name,
                                 const Contestant& other) {
  std::vector<Column> columns;
  for (const unsigned number : threads)
    columns.push_back({number == 1 ? "rbpa" : "rbpa_" + std::to_string(number) + "_threads", rbpa_with(number)});
  columns.push_back({"cgal_points", cgal_points});
  columns.push_back({name, other});
  return columns;
}

void scaling(const std::filesystem::path& folder, const Arguments& with) {
  CurveFile file(folder / "performance_scaling.csv", "points", columns_with(with.threads, "cgal_indices", cgal_indices),
                 "uniform points, no radius; nanoseconds a point", with.runs);
  for (const double times : {0.1, 0.2, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0}) {
    const auto count = static_cast<std::size_t>(std::lround(times * static_cast<double>(with.points)));
    file.measure(static_cast<double>(count), {uniform, count, INFINITY, "∞"});
  }
  file.publish();
}

void alphas(const std::filesystem::path& folder, const Arguments& with) {
  CurveFile file(
      folder / "performance_alpha.csv", "alpha", columns_with(with.threads, "cgal_points_filter", cgal_points_filtered),
      std::to_string(with.points) + " uniform points against alpha in mean spacings; nanoseconds a point", with.runs);
  for (const double alpha : {0.3, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0, 30.0, 100.0, 300.0, 1000.0})
    file.measure(alpha, {uniform, with.points, alpha, ""});
  file.publish();
}

/// Returns a hundred clusters whose widths span 0, 1, … 6 decades.
template <int span>
Workload clusters_over() {
  return {"clusters", [](std::size_t count) { return gaussian_clusters(count, span); }};
}

void densities(const std::filesystem::path& folder, const Arguments& with) {
  CurveFile file(folder / "performance_density.csv", "width_ratio",
                 columns_with(with.threads, "cgal_indices", cgal_indices),
                 std::to_string(with.points) + " points in 100 clusters, no radius; nanoseconds a point", with.runs);
  double ratio = 1;
  for (const Workload& workload : {clusters_over<0>(), clusters_over<1>(), clusters_over<2>(), clusters_over<3>(),
                                   clusters_over<4>(), clusters_over<5>(), clusters_over<6>()}) {
    file.measure(ratio, {workload, with.points, INFINITY, "∞"});
    ratio *= 10;
  }
  file.publish();
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  if (argc < 2 || argv[argc - 1][0] == '-') {
    std::fprintf(stderr, "usage: %s [--runs=N] [--points=N] [--threads=1,2] FOLDER\n", argv[0]);
    return 2;
  }
  const auto arguments = rbpa_bench::parse(argc - 1, argv, {.threads = true});
  if (!arguments) return 2;
  try {
    const std::filesystem::path folder = argv[argc - 1];
    rbpa_bench::keep_memory();
    rbpa_bench::scaling(folder, *arguments);
    rbpa_bench::alphas(folder, *arguments);
    rbpa_bench::densities(folder, *arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 1;
  }
  return 0;
}
