// Measures the data of the figure of docs/reference/performance.md, time per point against the number of points,
// against alpha, and against the unevenness of the points; and of figure 6 of docs/explanation/paper.md. Writes
// performance_scaling.csv, performance_alpha.csv, performance_density.csv and paper_6_timing.csv, each complete or not
// at all, which docs/drawings/draw.py draws. Values are medians, in nanoseconds per point, of figure 6 in seconds.
//   bench_curves [--runs=N] [--points=N] FOLDER      5 runs of each; 1,000,000 points and up to 16 times
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "bench/contest.h"
#include "bench/options.h"
#include "bench/process.h"
#include "bench/tables.h"
#include "bench/workload.h"

namespace rbpa_bench {
namespace {

/// Method with the name of its column.
struct Column {
  std::string name;
  Method method;
};

/// File with one curve for each method, written in the folder of its target and renamed when everything is measured.
class CurveFile {
 public:
  /// Starts a file whose first column is `x`; the number of points is another column, unless it is `x`.
  CurveFile(std::filesystem::path path, const std::string& x, const std::vector<Column>& all, const std::string& what)
      : path_(std::move(path)), x_is_points_(x == "points") {
    text_ = "# " + machine() + "; medians of the runs\n# " + what + "\n" + x + (x_is_points_ ? "" : ",points") +
            ",triangles";
    for (const Column& column : all) {
      text_ += "," + column.name;
      methods_.push_back(column.method);
    }
    text_ += "\n";
  }

  /// Adds a row. A unit of 0 stands for one nanosecond a point.
  void measure(double x, const rbpa_test::Points& points, double alpha, const Settings& settings, double unit = 0) {
    const std::vector<Outcome> outcomes = in_turn(on(points, alpha, methods_), settings);
    if (unit == 0) unit = 1e-9 * static_cast<double>(points.size());
    text_ += text("%.9g", x);
    if (!x_is_points_) text_ += text(",%zu", points.size());
    text_ += text(",%zu", outcomes[0].count);
    for (const Outcome& outcome : outcomes) {
      if (!outcome.failure.empty()) throw std::runtime_error(outcome.name + ": " + outcome.failure);
      if (!outcome.wrong.empty())  // CGAL's filter rounds
        std::fprintf(stderr, "%s: %s\n", outcome.name.c_str(), outcome.wrong.c_str());
      text_ += text(",%.4g", outcome.seconds.median() / unit);
    }
    text_ += "\n";
    std::fprintf(stderr, "%s: %g\n", path_.filename().c_str(), x);
  }

  void publish() const {
    const std::string beside = path_.string() + ".part";
    std::ofstream out(beside, std::ios::binary);
    out << text_;
    out.close();
    if (!out) throw std::runtime_error(beside + ": cannot be written");
    std::filesystem::rename(beside, path_);
  }

 private:
  std::filesystem::path path_;
  bool x_is_points_;
  std::vector<Method> methods_ = {};
  std::string text_ = {};
};

/// Returns our columns, CGAL's best case, and another method.
std::vector<Column> columns_with(const std::string& name, const Method& other) {
  return {{"rbpa", rbpa_with(1)}, {"rbpa_2_threads", rbpa_with(2)}, {"cgal_points", cgal_points()}, {name, other}};
}

void scaling(const std::filesystem::path& folder, const Sizes& sizes) {
  CurveFile file(folder / "performance_scaling.csv", "points", columns_with("cgal_indices", cgal_indices()),
                 "uniform points, no radius; nanoseconds a point");
  for (const double times : {0.1, 0.2, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0}) {
    const auto count = static_cast<std::size_t>(std::lround(times * static_cast<double>(sizes.points)));
    file.measure(static_cast<double>(count), uniform.make(count), INFINITY, {.runs = sizes.runs, .warm = true});
  }
  file.publish();
}

void alphas(const std::filesystem::path& folder, const Sizes& sizes) {
  CurveFile file(folder / "performance_alpha.csv", "alpha", columns_with("cgal_points_filter", cgal_points_filtered()),
                 text("%zu uniform points against alpha in mean spacings; nanoseconds a point", sizes.points));
  const rbpa_test::Points points = uniform.make(sizes.points);
  for (const double alpha : {0.3, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0, 30.0, 100.0, 300.0, 1000.0})
    file.measure(alpha, points, alpha, {.runs = sizes.runs, .warm = true});
  file.publish();
}

/// A hundred clusters whose widths span 0, 1, … 6 decades.
void densities(const std::filesystem::path& folder, const Sizes& sizes) {
  CurveFile file(folder / "performance_density.csv", "width_ratio", columns_with("cgal_indices", cgal_indices()),
                 text("%zu points in 100 clusters, no radius; nanoseconds a point", sizes.points));
  for (const double span : {0, 1, 2, 3, 4, 5, 6})
    file.measure(std::pow(10, span), gaussian_clusters(sizes.points, span), INFINITY,
                 {.runs = sizes.runs, .warm = true});
  file.publish();
}

/// hrbpa(), also with leaves so small that there are several levels (with the default, the first radius is above
/// alpha), rbpa(), and the paper's RBPA and HRBPA, on 1,000, 2,000, 5,000, … points.
void paper_6(const std::filesystem::path& folder, const Sizes& sizes) {
  constexpr double alpha = 3;
  CurveFile file(folder / "paper_6_timing.csv", "points",
                 {{"hrbpa", hrbpa()},
                  {"hrbpa_small_leaves", hrbpa(16)},
                  {"rbpa", rbpa_with(1)},
                  {"paper", paper_rbpa()},
                  {"paper_hrbpa", paper_hrbpa()}},
                 "uniform points, alpha = 3 mean spacings, one thread; seconds from points in memory to the mesh");
  for (std::size_t power = 1000; power <= sizes.points; power *= 10)
    for (const std::size_t count : {power, 2 * power, 5 * power}) {
      if (count > sizes.points) break;
      // Short runs are repeated more often, because they scatter more.
      const int runs = sizes.runs * static_cast<int>(std::clamp<std::size_t>(20000 / count, 1, 10));
      file.measure(static_cast<double>(count), uniform.make(count), alpha, {.runs = runs}, 1);
    }
  file.publish();
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  using namespace rbpa_bench;
  std::string folder, only;
  const Sizes sizes = read_sizes(argc, argv, {},
                                 {{"FOLDER", &folder, "for the files, such as docs/figures"},
                                  {"--only", &only, "scaling, alpha, density or timing"}});
  try {
    keep_memory();
    if (only.empty() || only == "scaling") scaling(folder, sizes);
    if (only.empty() || only == "alpha") alphas(folder, sizes);
    if (only.empty() || only == "density") densities(folder, sizes);
    if (only.empty() || only == "timing") paper_6(folder, sizes);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 1;
  }
}
