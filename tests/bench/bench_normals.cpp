// Prints how many estimated normals are on the right side, and how many of the others are marked as doubtful.
//   bench_normals   the bodies of known_normals.h, then the sets of the further data, as a table of
//   docs/explanation/surfaces.md
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <numbers>

#include "bench/known_normals.h"
#include "rbpa/space/surface/estimate_normals.h"

namespace rbpa_bench {
namespace {

void row(const KnownNormals& known) {
  const rbpa::EstimatedNormals found = rbpa::estimate_normals_and_confidence(known.points);
  std::size_t count = 0, wrong = 0, sure = 0, wrong_sure = 0;
  double angle = 0;
  for (std::size_t i = 0; i < known.points.size(); ++i) {
    const rbpa::Point3 &n = found.normals[i], &m = known.normals[i];
    if (m == rbpa::Point3{}) continue;
    const double along = (n.x * m.x + n.y * m.y + n.z * m.z) / std::sqrt(m.x * m.x + m.y * m.y + m.z * m.z);
    const bool is_wrong = along <= 0, is_sure = found.confidence[i] >= rbpa::least_confidence;
    ++count;
    wrong += is_wrong;
    sure += is_sure;
    wrong_sure += is_wrong && is_sure;
    angle += std::acos(std::min(1.0, std::abs(along))) * 180 / std::numbers::pi;
  }
  const auto percent = [](std::size_t part, std::size_t of) {
    return of == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(of);
  };
  std::printf("| %s | %zu | %.2f | %.1f | %.2f | %zu | %zu |\n", known.name.c_str(), count,
              percent(count - wrong, count), angle / static_cast<double>(count), percent(count - sure, count), wrong,
              wrong_sure);
  std::fflush(stdout);
}

void run() {
  std::puts("| points | | right side, % | off, degrees | in doubt, % | wrong side | of these sure |");
  std::puts("|---|--:|--:|--:|--:|--:|--:|");
  for (const KnownNormals& known : bodies_with_normals()) row(known);
  for (const KnownNormals& known : scans_with_normals()) row(known);
}

}  // namespace
}  // namespace rbpa_bench

int main() {
  try {
    rbpa_bench::run();
  } catch (const std::exception& e) {
    std::fprintf(stderr, "bench_normals: %s\n", e.what());
    return 1;
  }
}
