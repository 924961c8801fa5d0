// What: the C++ side of bench_python.py: for each line of standard input, runs alpha_complex() with neighbors and
//       boundary on a file of native float64 pairs, and writes its seconds and its processor seconds to standard
//       output.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "rbpa/plane/alpha_complex.h"

namespace {

std::vector<rbpa::Point> read_points(const std::string& path) {
  std::vector<rbpa::Point> points(std::filesystem::file_size(path) / sizeof(rbpa::Point));
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(points.data()), static_cast<std::streamsize>(points.size() * sizeof(rbpa::Point)));
  if (!file) throw std::runtime_error(path + ": cannot be read");
  return points;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: bench_arrays POINTS ALPHA THREADS < a line for each run\n");
    return 2;
  }
  try {
    const std::vector<rbpa::Point> points = read_points(argv[1]);
    const double alpha = std::atof(argv[2]);
    const auto threads = static_cast<unsigned>(std::atoi(argv[3]));
    for (std::string line; std::getline(std::cin, line);) {
      const auto start = std::chrono::steady_clock::now();
      const std::clock_t processor_start = std::clock();
      const rbpa::AlphaComplex made =
          rbpa::alpha_complex(points, alpha, {.neighbors = true, .boundary = true, .threads = threads});
      const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
      const double processor = static_cast<double>(std::clock() - processor_start) / CLOCKS_PER_SEC;
      std::printf("%.9f %.9f %zu\n", passed.count(), processor, made.triangles.size());
      std::fflush(stdout);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_arrays: %s\n", error.what());
    return 1;
  }
  return 0;
}
