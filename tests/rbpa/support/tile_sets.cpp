#include "support/tile_sets.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "rbpa/base/exact/magnitude.h"
#include "rbpa/plane/predicate/predicates.h"
#include "support/generate.h"
#include "support/samples.h"
#include "support/sets.h"

namespace rbpa_test {
namespace {

using rbpa::Point;
using P = rbpa::Predicates<double>;
using Index = std::uint32_t;

/// Returns `each` points within `width` of every one of `crowds` points, and a thin spread of others.
Points crowds(int crowds, int each, double width, int others, std::uint64_t seed) {
  Random random(seed);
  Points points;
  for (int i = 0; i < others; ++i) points.push_back({random.between(0, 10), random.between(0, 10)});
  for (int c = 0; c < crowds; ++c) {
    const Point at = {random.between(0, 10), random.between(0, 10)};
    for (int i = 0; i < each; ++i)
      points.push_back({at.x + width * random.between(-1, 1), at.y + width * random.between(-1, 1)});
  }
  return points;
}

/// Returns points half of which are in a corner, half of those in a corner of the corner, and so on.
Points ever_denser(int levels, int each, std::uint64_t seed) {
  Random random(seed);
  Points points;
  for (int level = 0; level < levels; ++level)
    for (int i = 0; i < each; ++i)
      points.push_back({std::ldexp(random.unit(), -2 * level), std::ldexp(random.unit(), -2 * level)});
  return points;
}

Points ring(int points_on_it, double radius) {
  Points points;
  for (int i = 0; i < points_on_it; ++i) {
    const double t = 2.0 * i / points_on_it - 1, s = 1 + t * t;
    points.push_back({radius * (1 - t * t) / s, radius * 2 * t / s});
  }
  return points;
}

/// Returns a turned grid of pairs: thin rectangles, cocircular except for the last bits.
Points pairs_on_a_grid(int columns, double apart) {
  Points points;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < columns; ++j)
      for (const double y : {static_cast<double>(j), j + apart})
        points.push_back({0.6 * i - 0.8 * y, 0.8 * i + 0.6 * y});
  return points;
}

/// Returns rows of points that are on a line except for `off`.
Points rows_nearly_on_lines(int rows, int each, double off, std::uint64_t seed) {
  Random random(seed);
  Points points;
  for (int row = 0; row < rows; ++row)
    for (int i = 0; i < each; ++i) {
      const double x = random.between(0, each), y = 2 * row + off * random.between(-1, 1);
      points.push_back({0.6 * x - 0.8 * y, 0.8 * x + 0.6 * y});
    }
  return points;
}

Points together(Points a, const Points& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::optional<Index> winner(const Points& points, Index a, Index b) {
  std::optional<Index> best;
  for (Index i = 0; i < points.size(); ++i)
    if (i != a && i != b && P::orientation(points[a], points[b], points[i]) > 0 &&
        (!best || P::in_perturbed_circle(points[a], points[b], points[*best], points[i]) > 0))
      best = i;
  return best;
}

}  // namespace

Points nearly_a_lattice(int columns, double kept, double moved, Random& random) {
  static constexpr double nothings[] = {1e-20, 1e-9, 0x1p-20, 0x1p-23, 0x1p-26, 0x1p-30, 0x1p-45};
  const double pitch = random.chance(0.7) ? std::ldexp(1.0, random.integer(-20, 20)) : 0.1;
  const double nothing = pitch * nothings[random.below(std::size(nothings))];
  const double x0 = random.chance(0.5) ? 0 : pitch * std::ldexp(random.integer(-3, 3), random.integer(0, 25)),
               y0 = random.chance(0.5) ? 0 : pitch * std::ldexp(random.integer(-3, 3), random.integer(0, 25));
  Points points;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < columns; ++j) {
      if (!random.chance(kept)) continue;
      Point p = {x0 + pitch * (i - columns / 2), y0 + pitch * (j - columns / 2)};
      if (random.chance(moved)) (random.chance(0.5) ? p.x : p.y) += random.chance(0.5) ? nothing : -nothing;
      points.push_back(p);
    }
  return points;
}

Points lattice_around_a_stranger(Random& random) {
  const double nothing = random.chance(0.5) ? 1e-20 : 0x1p-60, kept = random.between(0.2, 1);
  const bool own_row = random.chance(0.5);
  const int most = random.integer(2, 6);
  Points points = {{random.chance(0.5) ? nothing : -nothing, own_row ? nothing : 0}};
  for (int i = -most; i <= most; ++i)
    for (int j = -most; j <= most; ++j)
      if (i != 0 && (j != 0 || !own_row) && random.chance(kept))
        points.push_back({static_cast<double>(i), static_cast<double>(j)});
  random.shuffle(points);
  return points;
}

std::vector<TileSet> tile_sets() {
  std::vector<TileSet> sets = {
      {"uniform", uniform(300, 1)},
      {"perfect grid", perfect_grid(17, 1)},
      {"grid of tenths", perfect_grid(17, 0.1)},
      {"fine grid far out", moved(scaled(random_grid(20, 250, true, 2), -20), 0x1p30, -0x1p30)},
      {"fine grid of 2^-20 within large coordinates", moved(perfect_grid(17, 0x1p-20), 0x1p30, 3 * 0x1p30)},
      {"grid of 3 at large coordinates", moved(perfect_grid(17, 3), 0x1p50, 0x1p51)},
      {"two grids of unlike pitch", together(perfect_grid(10, 1), moved(perfect_grid(13, 0x1p-9), 2.5, 3.25))},
      {"triangular lattice", triangular_lattice(17)},
      {"rotated integer grid", rotated_integer_grid(16)},
      {"rotated rounded grid", rotated_rounded_grid(16)},
      {"random grid with repetitions", random_grid(15, 300, true, 3)},
      {"sparse grid", sparse_grid(30, 0.3, 4)},
      {"barely jittered grid", jittered_grid(17, 1e-13, 5)},
      {"grid jittered as single precision rounds", jittered_grid(17, 1e-6, 26)},
      {"grid jittered a little less", jittered_grid(17, 1e-7, 27)},
      {"grid jittered still less", jittered_grid(17, 3e-8, 28)},
      {"jittered grid far out", moved(jittered_grid(17, 0.9, 6), 0x1p40, -0x1p41)},
      {"jittered grid at the end of doubles", moved(jittered_grid(17, 0.9, 7), 0x1p52, 0x1p51)},
      {"integer circle", integer_circle(32045)},
      {"integer concentric with center", integer_concentric(1105, true)},
      {"rounded concentric", rounded_concentric(120)},
      {"ring of rounded points", ring(250, 1)},
      {"ring in a ring, and a grid", together(together(ring(90, 100), ring(90, 1)), perfect_grid(9, 0.0625))},
      {"rectangles of circumradius 5", rectangles_of_circumradius_5(15)},
      {"clusters over nine decades", clusters(30, 8)},
      {"two crowds", crowds(2, 120, 1e-3, 60, 9)},
      {"crowds of 1e-12", crowds(4, 60, 1e-12, 60, 10)},
      {"pairs of 1e-12", crowds(120, 2, 1e-12, 40, 11)},
      {"pairs of 1e-15", crowds(120, 2, 1e-15, 40, 12)},
      {"pairs on a grid, 0.01 apart", pairs_on_a_grid(12, 0.01)},
      {"pairs on a grid, 0.001 apart", pairs_on_a_grid(12, 0.001)},
      {"pairs on a grid, 0.0001 apart", pairs_on_a_grid(12, 0.0001)},
      {"rows nearly on lines, 1e-5 off", rows_nearly_on_lines(6, 45, 1e-5, 29)},
      {"rows nearly on lines, 1e-7 off", rows_nearly_on_lines(6, 45, 1e-7, 30)},
      {"ever denser", ever_denser(10, 30, 13)},
      {"duplicates", duplicates(100, 4, 14)},
      {"nearest doubles", nearest_doubles(100, 15)},
      {"lidar lines", lidar_lines(12, 25, 16)},
      {"on a horizontal line", collinear_run(100, 1, 0, 17)},
      {"on a slanted line", collinear_run(100, 7, -3, 18)},
      {"on a line but for some", collinear_run_with_points_off(200, 1, 0, 8, 19)},
      {"on a line but for one", collinear_run_with_points_off(200, 3, 4, 1, 20)},
      {"nearly on a line", collinear_run(200, 0.1, 0.3, 21)},
      {"crossing runs", crossing_runs(60)},
      {"along curves", along_curves(80)},
      {"tiny components", tiny_components(60, 22)},
      {"chain of triangles", chain_of_triangles(80)},
      {"ring of pinches", ring_of_pinches(60)},
      {"star", star(1105)},
      {"large", scaled(uniform(250, 23), 90)},
      {"small", scaled(uniform(250, 24), -90)},
  };
  Random random(25);
  for (int i = 0; i < 12; ++i) {
    const double moved = i % 3 == 0 ? 0.02 : i % 3 == 1 ? 0.3 : 0;
    sets.push_back({"nearly a lattice", nearly_a_lattice(17, i % 2 == 0 ? 1 : 0.6, moved, random)});
  }
  std::erase_if(sets, [](const TileSet& set) { return !rbpa::fits_double(rbpa::magnitude(set.points)); });
  return sets;
}

TileSet few_points(Random& random) {
  switch (random.below(5)) {
    case 4:
      return {"lattice around a stranger", lattice_around_a_stranger(random)};
    case 0: {
      const Kind kind = kinds_that_fit_double[random.below(kinds_that_fit_double.size())];
      TileSet set{name(kind), Points(static_cast<std::size_t>(random.integer(3, 30)))};
      fill(set.points, kind, random);
      return set;
    }
    case 1:
      return {"nearly a lattice", nearly_a_lattice(random.integer(2, 6), 0.9, 0.2, random)};
    case 2:
      return {"crowds", crowds(random.integer(1, 3), random.integer(1, 20), std::ldexp(1.0, random.integer(-50, -1)),
                               random.integer(0, 10), random.bits())};
    default:
      return {"uniform", uniform(static_cast<std::size_t>(random.integer(3, 40)), random.bits())};
  }
}

std::vector<Triangle> delaunay_by_winners(const Points& points) {
  std::vector<std::pair<Index, Index>> queue;
  for (Index i = 1; i < points.size(); ++i) {
    // The nearest neighbor of a point is one of its Delaunay neighbors.
    if (queue.empty() || P::compare_distances(points[0], points[i], points[queue[0].second]) < 0) queue = {{0, i}};
  }
  if (!queue.empty()) queue.emplace_back(queue[0].second, queue[0].first);
  std::set<std::pair<Index, Index>> done;
  std::vector<Triangle> found;
  while (!queue.empty()) {
    const auto [a, b] = queue.back();
    queue.pop_back();
    if (done.contains({a, b})) continue;
    const auto c = winner(points, a, b);
    if (!c) continue;
    found.push_back({a, b, *c});
    done.insert({{a, b}, {b, *c}, {*c, a}});
    queue.insert(queue.end(), {{*c, b}, {a, *c}});
  }
  return canonical(std::move(found));
}

}  // namespace rbpa_test
