#include "bench/cold.h"

#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "bench/memory.h"

namespace rbpa_bench {
namespace {

std::vector<rbpa::Point> read_points(const std::string& path) {
  std::vector<rbpa::Point> points(std::filesystem::file_size(path) / sizeof(rbpa::Point));
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(points.data()), static_cast<std::streamsize>(points.size() * sizeof points[0]));
  if (!file) throw std::runtime_error(path + ": cannot be read");
  return points;
}

}  // namespace

const std::vector<Contestant>& cold_contestants() {
  static const std::vector<Contestant> all = {rbpa_with(1),      rbpa_with(2),      arrays_with(1), arrays_with(2),
                                              neighbors_with(1), neighbors_with(2), cgal_points};
  return all;
}

PointsFile::PointsFile(const rbpa_test::Points& points)
    : path_((std::filesystem::temp_directory_path() / "bench_points_XXXXXX").string()) {
  const int file = mkstemp(path_.data());
  if (file < 0) throw std::runtime_error(path_ + ": cannot be made");
  close(file);
  std::ofstream out(path_, std::ios::binary);
  out.write(reinterpret_cast<const char*>(points.data()),
            static_cast<std::streamsize>(points.size() * sizeof points[0]));
  out.close();
  if (out) return;
  std::filesystem::remove(path_);
  throw std::runtime_error(path_ + ": cannot be written");
}

PointsFile::~PointsFile() { std::filesystem::remove(path_); }

ColdRun run_cold(const std::string& program, std::size_t contestant, const std::string& points_file) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe can be made");
  const std::string number = "--one=" + std::to_string(contestant);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process can be started");
  if (child == 0) {
    if (dup2(ends[1], STDOUT_FILENO) >= 0)
      execl(program.c_str(), program.c_str(), number.c_str(), points_file.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  close(ends[1]);
  FILE* const input = fdopen(ends[0], "r");
  ColdRun run{};
  const bool complete =
      std::fscanf(input, "%lf %lf %zu %lf", &run.seconds, &run.processor_seconds, &run.triangles, &run.bytes) == 4;
  std::fclose(input);
  int status = 0;
  waitpid(child, &status, 0);
  if (!complete || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw std::runtime_error(cold_contestants()[contestant].name + ": the process reported nothing");
  return run;
}

int one(std::size_t contestant, const std::string& points_file) {
  if (contestant >= cold_contestants().size()) return 2;
  const std::vector<rbpa::Point> points = read_points(points_file);
  Run run{};
  const std::optional<double> bytes =
      rise_of_peak([&] { run = cold_contestants()[contestant].run(points, INFINITY, nullptr); });
  std::printf("%.9g %.9g %zu %.0f\n", run.seconds, run.processor_seconds.value_or(NAN), run.triangles,
              bytes.value_or(NAN));
  return 0;
}

}  // namespace rbpa_bench
