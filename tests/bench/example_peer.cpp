// Example of a program that takes part in bench_report as a peer: CGAL's Delaunay triangulation, with only what a peer
// must do.
//   bench_report --peer "CGAL by files=example_peer"
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>

#include "bench/contest.h"

namespace {

rbpa_test::Points read_points(const std::string& path) {
  rbpa_test::Points points(std::filesystem::file_size(path) / sizeof(rbpa::Point));
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(points.data()), static_cast<std::streamsize>(points.size() * sizeof(rbpa::Point)));
  if (!file) throw std::runtime_error(path + ": cannot be read");
  return points;
}

void write_triangles(const std::string& path, const rbpa_bench::Triangles& triangles) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(triangles.data()),
             static_cast<std::streamsize>(triangles.size() * sizeof(rbpa_test::Triangle)));
  file.close();
  if (!file) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: example_peer POINTS TRIANGLES\n");
    return 2;
  }
  try {
    const rbpa_test::Points points = read_points(argv[1]);
    rbpa_bench::Triangles triangles;
    const rbpa_bench::Run run = rbpa_bench::run_cgal_indices(points, std::numeric_limits<double>::infinity(),
                                                             rbpa_bench::Filter::none, &triangles);
    write_triangles(argv[2], triangles);
    std::fprintf(stderr, "seconds %.9f\n", run.seconds);  // without this line, the time of the process would count
  } catch (const std::exception& error) {
    std::fprintf(stderr, "example_peer: %s\n", error.what());
    return 1;
  }
  return 0;
}
