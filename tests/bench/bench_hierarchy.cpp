// Measures hrbpa() against rbpa(), CGAL and the paper's RBPA, and the effect of the leaf capacity
// (docs/explanation/plane.md, section 17).
//   bench_hierarchy [--runs=N] [--points=N]      5 runs of each in turn, on 1,000,000 points
#include <cmath>
#include <cstdio>

#include "bench/contest.h"
#include "bench/options.h"
#include "bench/tables.h"
#include "bench/workload.h"
#include "rbpa/hrbpa.h"

namespace rbpa_bench {
namespace {

/// Returns the number of sites that take part, over all levels, a point.
double taking_part(const rbpa::Hierarchy& hierarchy, std::size_t points) {
  auto sum = static_cast<double>(hierarchy.looked_in_vain);
  for (const rbpa::Level& level : hierarchy.levels) sum += static_cast<double>(level.taking_part);
  return sum / static_cast<double>(points);
}

void against_cgal(const Sizes& sizes) {
  std::printf("Alpha = ∞. Nanoseconds a point: median (min–max).\n\n");
  print_head({"points"},
             {"number", "hrbpa", "rbpa", "CGAL", "hrbpa / CGAL", "rbpa / CGAL", "levels", "Σ taking part / n"});
  for (const Workload& workload : {uniform, jittered, grid, clusters, kuzmin, lidar}) {
    const rbpa_test::Points points = workload.make(sizes.points);
    const double unit = 1e9 / static_cast<double>(points.size());
    const auto of = in_turn(on(points, INFINITY, {hrbpa(), rbpa_with(1), cgal_indices()}), {.runs = sizes.runs});
    const double cgal = of[2].seconds.median();
    const rbpa::Hierarchy hierarchy = rbpa::hrbpa(points, INFINITY);
    print_row({workload.name, text("%zu", points.size()), of[0].seconds.text(0, unit), of[1].seconds.text(0, unit),
               of[2].seconds.text(0, unit), text("%.2f", of[0].seconds.median() / cgal),
               text("%.2f", of[1].seconds.median() / cgal), text("%zu", hierarchy.levels.size()),
               text("%.2f", taking_part(hierarchy, points.size()))});
  }
}

/// Measures figure 9: at twice α₀, and with strongly varying spacing.
void against_the_paper(int runs) {
  std::printf("\nMilliseconds: median (min–max).\n\n");
  print_head({"points"}, {"number", "alpha", "hrbpa", "the paper's HRBPA", "the paper's RBPA", "ratio"});
  const auto row = [&](const std::string& what, const rbpa_test::Points& points, double alpha, std::size_t capacity) {
    const auto of = in_turn(on(points, alpha, {hrbpa(capacity), paper_hrbpa(), paper_rbpa()}), {.runs = runs});
    print_row({what, text("%zu", points.size()), text("%.4g", alpha), of[0].seconds.text(2, 1e3),
               of[1].seconds.text(2, 1e3), of[2].seconds.text(2, 1e3),
               text("%.1f", of[2].seconds.median() / of[0].seconds.median())});
  };
  const rbpa_test::Points two_scales = two_level_sampling(700);
  const std::size_t few = 8;
  const double least = rbpa::hrbpa(two_scales, INFINITY, {.leaf_capacity = few, .progress = {}}).least_radius;
  row("two scales, as figure 9", two_scales, 2 * least, few);
  row("two scales, default leaves", two_scales, 2 * least, rbpa::usual_leaf_capacity);
  row(decades.name, decades.make(20000), 100, rbpa::usual_leaf_capacity);
}

/// Measures points with a pair at a distance of 10⁻¹² spacings.
void close_pair(const Sizes& sizes) {
  const rbpa_test::Points points = uniform.make(sizes.points);
  rbpa_test::Points with_pair = points;
  with_pair.push_back({points[sizes.points / 2].x, std::nextafter(points[sizes.points / 2].y, INFINITY)});
  std::vector<Contestant> both = on(points, INFINITY, {hrbpa()});
  both.push_back({"with a pair", on(with_pair, INFINITY, {hrbpa()})[0].run, /*is_exact=*/false});
  const auto of = in_turn(both, {.runs = sizes.runs});
  std::printf(
      "\nOne pair at a distance of one last digit among %zu uniform points: %s ms, without it %s ms: %.2f times.\n",
      sizes.points, of[1].seconds.text(0, 1e3).c_str(), of[0].seconds.text(0, 1e3).c_str(),
      of[1].seconds.median() / of[0].seconds.median());
}

void leaf_capacities(const Sizes& sizes) {
  const std::vector<std::size_t> capacities{4, 16, 64, 256, 1024, 4096, 16384, 65536};
  std::vector<Method> methods;
  for (const std::size_t capacity : capacities) methods.push_back({text("%zu", capacity), hrbpa(capacity).run});
  std::printf("\nAlpha = ∞, %zu points, by leaf capacity. Nanoseconds a point, median; Σ taking part / n.\n\n",
              sizes.points);
  print_head({"points"}, columns({}, methods));
  for (const Workload& workload : {uniform, jittered, grid, clusters, kuzmin, lidar}) {
    const rbpa_test::Points points = workload.make(sizes.points);
    const Contest contest{"", "", points.size(), in_turn(on(points, INFINITY, methods), {.runs = sizes.runs})};
    std::vector<std::string> cells = {workload.name};
    for (std::size_t i = 0; i < capacities.size(); ++i)
      cells.push_back(text(
          "%.0f; %.2f", contest.nanoseconds(methods[i].name),
          taking_part(rbpa::hrbpa(points, INFINITY, {.leaf_capacity = capacities[i], .progress = {}}), points.size())));
    print_row(cells);
  }
}

}  // namespace
}  // namespace rbpa_bench

int main(int argc, char** argv) {
  using namespace rbpa_bench;
  const Sizes sizes = read_sizes(argc, argv);
  std::printf("%s; one thread, %d runs of each in turn.\n\n", machine().c_str(), sizes.runs);
  against_cgal(sizes);
  against_the_paper(sizes.runs);
  close_pair(sizes);
  leaf_capacities({sizes.points / 4, (sizes.runs + 1) / 2});
}
