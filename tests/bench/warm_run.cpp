#include "bench/warm_run.h"

#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>
#include <vector>

#include "bench/memory.h"
#include "bench/stopwatch.h"
#include "io/cloud/point_blocks.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/outline_polygons.h"

namespace rbpa_bench {
namespace {

std::vector<rbpa::Point> points_of(const std::string& file) {
  const auto blocks = rbpa::app::open_point_blocks({.path = file, .format = rbpa::app::Format::raw});
  std::vector<rbpa::Point> all;
  for (std::vector<rbpa::Point> block; blocks->next(block);) all.insert(all.end(), block.begin(), block.end());
  return all;
}

WarmRun timed(const std::vector<rbpa::Point>& points, double alpha, unsigned threads, bool with_polygons) {
  const Stopwatch watch;
  const rbpa::AlphaComplex found = rbpa::alpha_complex(points, alpha, {.neighbors = true, .threads = threads});
  std::vector<rbpa::Polygon> polygons;
  if (with_polygons) polygons = rbpa::outline_polygons(points, found);
  return {watch.seconds(), watch.processor_seconds(), found.triangles.size()};
}

}  // namespace

WarmRun compute_warm(const std::string& file, double alpha, unsigned threads, bool with_polygons) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe can be made");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process can be started");
  if (child == 0) {
    bool complete = false;
    try {
      keep_memory();
      const std::vector<rbpa::Point> points = points_of(file);
      WarmRun run;
      constexpr int runs = 3;
      for (int i = 0; i < runs; ++i) run = timed(points, alpha, threads, with_polygons);
      complete = write(ends[1], &run, sizeof run) == sizeof run;
    } catch (...) {  // nothing is reported
    }
    _exit(complete ? 0 : 1);
  }
  close(ends[1]);
  WarmRun run;
  const bool complete = read(ends[0], &run, sizeof run) == sizeof run;
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!complete) throw std::runtime_error(file + ": computing it in memory failed");
  return run;
}

}  // namespace rbpa_bench
