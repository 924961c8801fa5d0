#include <algorithm>

#include "bench/slow_paths.h"

namespace rbpa_bench {
namespace {

using rbpa::Point;

/// Returns points anywhere on `number` lines along x, which are `apart` mean distances of neighbors within one line
/// from each other.
Points rows(std::size_t count, int number, double apart, std::uint64_t seed) {
  number = std::max(number, 2);
  const double length = static_cast<double>(count) / number;
  return scattered(count, seed, [=](Random& random) {
    const double y = apart * random.integer(1, number);
    return Point{length * random.unit(), y};
  });
}

/// Returns such rows with points on a lattice.
Points even_rows(std::size_t count, int number, double apart) {
  number = std::max(number, 2);
  Points points;
  for (int row = 0; row < number; ++row)
    for (std::size_t i = 0; i < count / static_cast<std::size_t>(number); ++i)
      points.push_back({static_cast<double>(i), apart * row});
  return points;
}

/// Returns points on the line y = slope x, and the others.
Points line_with(std::size_t count, double slope, const Points& others, std::uint64_t seed) {
  Points points = along(count - others.size(), seed, [=](double t) { return Point{t, slope * t}; });
  points.insert(points.end(), others.begin(), others.end());
  return points;
}

Points outline(std::size_t count, std::uint64_t seed) {
  return scattered(count, seed, [](Random& random) {
    const double t = random.unit();
    switch (random.integer(0, 3)) {
      case 0:
        return Point{t, 0};
      case 1:
        return Point{1, t};
      case 2:
        return Point{t, 1};
      default:
        return Point{0, t};
    }
  });
}

/// Returns vertical teeth of length 1 on a line of length 1, dense along them.
Points comb(std::size_t count, int teeth, std::uint64_t seed) {
  return scattered(count, seed, [=](Random& random) {
    if (random.chance(0.1)) return Point{random.unit(), 0};
    const double x = random.integer(0, teeth) / static_cast<double>(teeth);
    return Point{x, random.unit()};
  });
}

}  // namespace

void add_slow_rows(SlowPaths& all) {
  all.kind = "line";
  all.add("line, one point off", [](std::size_t n) { return line_with(n, 0, {{0.5, 0.25}}, 80); });
  all.add("line, one point far off", [](std::size_t n) { return line_with(n, 0, {{0.5, 1e6}}, 81); });
  all.add("slanting line, one point off", [](std::size_t n) { return line_with(n, 0.3, {{0.5, 0.25}}, 82); });
  all.add("line, one point off either side", [](std::size_t n) { return line_with(n, 0, {{0.5, 1}, {0.4, -1}}, 83); });
  all.add("line, a tenth off", [](std::size_t n) {
    const auto off = static_cast<int>(n / 10);
    return rbpa_test::collinear_run_with_points_off(static_cast<int>(n) - off, 3, 7, off, 84);
  });
  all.each("line and uniform", 85, [](Random& random) {
    const double x = random.unit();
    return Point{x, random.chance(0.5) ? 0.5 : random.unit()};
  });
  all.each("nearly a line, 1e-9", 86, [](Random& random) {
    const double x = random.unit();
    return Point{x, 1e-9 * random.unit()};
  });
  all.each("nearly a line, 1e-3", 87, [](Random& random) {
    const double x = random.unit();
    return Point{x, 1e-3 * random.unit()};
  });
  all.add("two lines", [](std::size_t n) { return rows(n, 2, 100, 88); });
  all.add("three lines", [](std::size_t n) { return rows(n, 3, 100, 89); });
  all.add("lines that cross", [](std::size_t n) { return rbpa_test::crossing_runs(static_cast<int>(n / 8)); });
  all.each("100 lines anywhere", 90, [](Random& random) {
    Random line(random.below(100));
    const Point from{line.unit(), line.unit()}, to{line.unit(), line.unit()};
    const double t = random.unit();
    return Point{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
  });
  all.add("outline of a square", [](std::size_t n) { return outline(n, 91); });
  all.add("outline of a square, and center", [](std::size_t n) {
    Points points = outline(n - 1, 92);
    points.push_back({0.5, 0.5});
    return points;
  });

  all.kind = "rows";
  all.add("dense rows, 1 : 10", [](std::size_t n) { return even_rows(n, columns_for(n / 10), 10); });
  all.add("dense rows, 1 : 100", [](std::size_t n) { return even_rows(n, columns_for(n / 100), 100); });
  all.add("dense rows, 1 : 100, uneven", [](std::size_t n) { return rows(n, columns_for(n / 100), 100, 93); });
  all.add("dense rows, 1 : 1000, uneven", [](std::size_t n) { return rows(n, columns_for(n / 1000), 1000, 94); });
  all.add("comb, 10 teeth", [](std::size_t n) { return comb(n, 10, 95); });
  all.add("comb, 100 teeth", [](std::size_t n) { return comb(n, 100, 96); });
  all.curve("stairs", 97, [](double t) {
    const double step = std::floor(100 * t), rest = 100 * t - step;
    return rest < 0.5 ? Point{step + 2 * rest, step} : Point{step + 1, step + 2 * rest - 1};
  });
  all.curve("zigzag", 98, [](double t) { return Point{t, std::abs(std::remainder(100 * t, 1))}; });
  all.each("streets", 99, [](Random& random) {
    const double along_street = random.unit(), street = random.integer(0, 30) / 30.0;
    return random.chance(0.5) ? Point{along_street, street} : Point{street, along_street};
  });
  all.add("lidar lines", [](std::size_t n) { return lidar.make(n); });

  all.kind = "grid";
  all.add("grid", [](std::size_t n) { return grid.make(n); });
  all.add("grid, pitch 0.1", [](std::size_t n) { return rbpa_test::perfect_grid(columns_for(n), 0.1); });
  all.add("grid, turned and rounded", [](std::size_t n) { return rbpa_test::rotated_rounded_grid(columns_for(n)); });
  all.add("grid, 3-4-5", [](std::size_t n) { return rbpa_test::rotated_integer_grid(columns_for(n)); });
  all.add("grid, half of it", [](std::size_t n) { return rbpa_test::sparse_grid(columns_for(2 * n), 0.5, 100); });
  all.add("grid, moved by 1e-9", [](std::size_t n) { return rbpa_test::jittered_grid(columns_for(n), 1e-9, 101); });
  all.add("triangular lattice", [](std::size_t n) { return rbpa_test::triangular_lattice(columns_for(n)); });
  all.add("uniform", [](std::size_t n) { return uniform.make(n); });
}

}  // namespace rbpa_bench
