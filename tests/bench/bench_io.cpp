// Measures reading and writing of formats by Google Benchmark, in megabytes and in points or triangles a second of the
// processor: docs/reference/performance.md, section 9. Files lie in the folder for temporary files; files that are read
// are in the system's cache.
//   bench_io --benchmark_repetitions=9 --benchmark_enable_random_interleaving=true
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>
#include <random>
#include <span>

#include "bench/process.h"
#include "io/bytes/output_file.h"
#include "io/cloud/read_points.h"
#include "io/formats.h"
#include "io/mesh/read_mesh.h"
#include "io/mesh/write_triangles.h"
#include "rbpa/rbpa.h"

namespace rbpa_bench {
namespace {

namespace app = rbpa::app;
using app::Use;
using rbpa::Point;

/// A million points in a square of side 1000 and their triangles, as files in a temporary folder.
class Files {
 public:
  Files() {
    std::mt19937_64 random(1);
    const auto coordinate = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53 * 1000; };
    std::vector<Point> short_points;
    for (std::size_t i = 0; i < 1000000; ++i) {
      const double x = coordinate();
      points_.push_back({x, coordinate()});
      short_points.push_back({std::round(x * 1e6) / 1e6, std::round(points_.back().y * 1e6) / 1e6});
    }
    triangles_ = rbpa::triangles(rbpa::rbpa(points_, INFINITY));
    add_read_points("read .xy, 17 digits", table("p.xy", points_, " "));
    add_read_points("read .csv, 17 digits", table("p.csv", points_, ","));
    add_read_points("read .xy, 6 places", table("short.xy", short_points, " "));
    write_values(folder_ / "p.f64xy", points_);
    add_read_points("read .f64xy", folder_ / "p.f64xy");
    for (const std::string format : {"off", "obj", "ply", "npy"}) write(format);
    for (const std::string format : {"off", "ply"})
      add_read_points("read the points of a mesh ." + format, folder_ / ("m." + format));
    for (const std::string format : {"off", "obj", "ply"}) add_read_mesh(format);
    for (const std::string format : {"off", "obj", "ply", "npy"})
      add("write ." + format, folder_ / ("m." + format), triangles_.size(), [this, format] { return write(format); });
  }

 private:
  std::string table(const std::string& name, const std::vector<Point>& points, std::string_view separator) const {
    app::OutputFile file(folder_ / name);
    for (const Point& p : points) {
      file.write_number(p.x);
      file.write(separator);
      file.write_number(p.y);
      file.write("\n");
    }
    file.finish();
    file.publish();
    return folder_ / name;
  }

  std::size_t write(const std::string& format) const {
    app::OutputFile file(folder_ / ("m." + format));
    app::write_triangles(file, *app::find_format(Use::triangles, format), {points_, triangles_});
    file.finish();
    file.publish();
    return triangles_.size();
  }

  void add_read_points(const std::string& name, const std::string& path) {
    add(name, path, points_.size(), [path] {
      return app::read_points({path, *app::find_format(Use::points, app::input_ending(path))}).points.size();
    });
  }
  void add_read_mesh(const std::string& format) {
    const std::string path = folder_ / ("m." + format);
    add("read the mesh ." + format, path, triangles_.size(), [path, format] {
      return app::read_mesh({path, *app::find_format(Use::mesh, format)}).soup.faces();
    });
  }

  /// Adds a measurement of work(), which returns the number of points or triangles, one run in each repetition.
  template <typename Work>
  static void add(const std::string& name, const std::string& path, std::size_t count, Work work) {
    const auto measure = [=](benchmark::State& state) {
      for ([[maybe_unused]] const auto _ : state)
        if (work() != count) return state.SkipWithError("found another number of points or triangles");
      state.SetBytesProcessed(static_cast<std::int64_t>(std::filesystem::file_size(path)));
      state.SetItemsProcessed(static_cast<std::int64_t>(count));
    };
    benchmark::RegisterBenchmark(name.c_str(), measure)
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond)
        ->ComputeStatistics("min",
                            [](const std::vector<double>& all) { return *std::min_element(all.begin(), all.end()); })
        ->ComputeStatistics("max",
                            [](const std::vector<double>& all) { return *std::max_element(all.begin(), all.end()); });
  }

  Folder folder_ = {};
  std::vector<Point> points_ = {};
  std::vector<app::Triangle> triangles_ = {};
};

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  try {
    const rbpa_bench::Files files;
    benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& error) {
    std::cerr << "bench_io: " << error.what() << '\n';
    return 1;
  }
}
