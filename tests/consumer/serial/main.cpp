// A program for one thread: it calls every function that shares work among threads in other builds, and checks for the
// same triangles.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "rbpa/plane/alpha_complex.h"
#include "rbpa/rbpa.h"
#include "rbpa/space/normals/estimate_normals.h"
#include "rbpa/space/surface/surface.h"

namespace {

std::vector<rbpa::Point> scattered(std::size_t count) {
  std::uint64_t state = 1;
  const auto next = [&] {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state >> 32U) / 65536.0;
  };
  std::vector<rbpa::Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = next(), y = next();
    points.push_back({x, y});
  }
  return points;
}

std::uint64_t fingerprint(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const auto& triangle : triangles)
    for (const std::uint32_t index : triangle) hash = (hash ^ index) * 0x100000001b3U;
  return hash;
}

}  // namespace

int main() {
  const bool is_one = rbpa::threads_used(1'000'000, 0) == 1 && rbpa::threads_used(1'000'000, 8) == 1;
  std::puts(is_one ? "one thread" : "not the one thread that is expected");

  const std::vector<rbpa::Point> points = scattered(50'000);
  rbpa::AlphaComplexOptions options;
  options.threads = 8;
  const auto triangles = rbpa::alpha_complex(points, 500, options).triangles;
  // Hash from a build with oneTBB.
  constexpr std::uint64_t with_threads = 0xd3ae08a6fd0d85d4U;
  const bool is_same = fingerprint(triangles) == with_threads &&
                       rbpa::triangles(rbpa::rbpa(points, 500, {.threads = 8})).size() == triangles.size();
  std::printf("%zu triangles, %016llx: %s\n", triangles.size(), static_cast<unsigned long long>(fingerprint(triangles)),
              is_same ? "those of threads" : "not the ones that are expected");

  std::vector<rbpa::Point3> sphere;
  for (int i = 0; i < 2000; ++i) {
    const double z = (2 * i + 1) / 2000.0 - 1, r = std::sqrt(1 - z * z);
    sphere.push_back({r * std::cos(2.4 * i), r * std::sin(2.4 * i), z});
  }
  const bool is_closed = rbpa::surface(sphere, rbpa::estimate_normals(sphere), 0.2).triangles.size() == 3996;
  std::puts(is_closed ? "a sphere" : "not the surface that is expected");
  return is_one && is_same && is_closed ? 0 : 1;
}
