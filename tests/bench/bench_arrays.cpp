// What: the C++ side of bench_python.py: for each line of standard input, runs alpha_complex() with neighbors and
//       boundary on a file of native float64 pairs, and writes its seconds, its processor seconds and its number of
//       triangles to standard output.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>

#include "bench/measure.h"
#include "bench/process.h"
#include "rbpa/plane/alpha_complex.h"

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: bench_arrays POINTS ALPHA THREADS < a line for each run\n");
    return 2;
  }
  try {
    const auto points = rbpa_bench::read_values<rbpa::Point>(argv[1]);
    const double alpha = std::atof(argv[2]);
    const auto threads = static_cast<unsigned>(std::atoi(argv[3]));
    for (std::string line; std::getline(std::cin, line);) {
      const rbpa_bench::Stopwatch watch;
      const rbpa::AlphaComplex made =
          rbpa::alpha_complex(points, alpha, {.neighbors = true, .boundary = true, .threads = threads});
      std::printf("%.9f %.9f %zu\n", watch.seconds(), watch.processor_seconds(), made.triangles.size());
      std::fflush(stdout);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_arrays: %s\n", error.what());
    return 1;
  }
}
