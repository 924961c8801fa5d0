// Example of a program that takes part in bench_report as a peer: CGAL's Delaunay triangulation, with only what a peer
// must do.
//   bench_report --peer "CGAL by files=example_peer"
#include <cmath>
#include <cstdio>
#include <exception>

#include "bench/contest.h"
#include "bench/process.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: example_peer POINTS TRIANGLES\n");
    return 2;
  }
  try {
    const auto points = rbpa_bench::read_values<rbpa::Point>(argv[1]);
    rbpa_bench::Triangles triangles;
    const rbpa_bench::Run run = rbpa_bench::cgal_indices().run(points, INFINITY, &triangles);
    rbpa_bench::write_values(argv[2], triangles);
    std::fprintf(stderr, "seconds %.9f\n", run.seconds);  // without this line, the time of the process would count
  } catch (const std::exception& error) {
    std::fprintf(stderr, "example_peer: %s\n", error.what());
    return 1;
  }
}
