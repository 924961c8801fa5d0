#include "support/sets.h"

#include <cmath>
#include <limits>

#include "support/generate.h"
#include "support/random.h"

namespace rbpa_test {
namespace {

/// Returns the radius of a tie, and the doubles next to it.
std::vector<double> around(double alpha) {
  return {std::nextafter(alpha, 0.0), alpha, std::nextafter(alpha, std::numeric_limits<double>::infinity())};
}

std::vector<NamedSet> table() {
  return {
      {"nothing", [] { return Points{}; }},
      {"one_point",
       [] {
         return Points{{3, 4}};
       }},
      {"two_points",
       [] {
         return Points{{3, 4}, {1, 2}};
       }},
      {"one_triangle",
       [] {
         return Points{{0, 0}, {3, 0}, {0, 4}};
       },
       around(2.5)},
      {"all_equal",
       [] {
         return Points(7, {1, 2});
       }},
      {"plus_and_minus_zero",
       [] {
         return Points{{0.0, -0.0}, {1, 0}, {-0.0, 0.0}, {0.0, 1}, {-0.0, -0.0}};
       }},

      {"uniform", [] { return uniform(3000, 1); }},
      {"jittered_grid", [] { return jittered_grid(50, 0.9, 2); }},
      {"barely_jittered_grid", [] { return jittered_grid(40, 1e-13, 3); }},
      {"perfect_grid", [] { return perfect_grid(40, 1); }, {std::sqrt(0.5), 0.7072}},
      {"grid_of_tenths", [] { return perfect_grid(40, 0.1); }},
      {"sparse_grid", [] { return sparse_grid(50, 0.55, 4); }, {0.75, 1.0, 1.25}},
      {"very_sparse_grid", [] { return sparse_grid(60, 0.2, 5); }, {1.0, 1.25, 2.5}},
      {"sparse_grid_of_ties", [] { return sparse_grid(100, 0.35, 31); }, {1.0, 1.25, std::sqrt(1.25), 2.5}},
      {"rotated_integer_grid", [] { return rotated_integer_grid(35); }, {3.5, 3.6}},
      {"rotated_rounded_grid", [] { return rotated_rounded_grid(35); }, {std::sqrt(0.5), 0.7072}},
      {"triangular_lattice", [] { return triangular_lattice(35); }, around(std::sqrt(1.0 / 3))},
      {"full_small_grid", [] { return random_grid(30, 900, false, 6); }, around(std::sqrt(0.5))},
      {"half_small_grid", [] { return random_grid(30, 450, false, 7); }, {1.0, 1.25, 2.5, 5}},
      {"grid_with_repetitions", [] { return random_grid(20, 500, true, 8); }, {1.0, 2.5}},
      {"clusters_over_nine_decades", [] { return clusters(150, 9); }, {1e-10, 1e-8, 1e-6, 1e-4, 1e-2}},
      {"duplicates", [] { return duplicates(300, 5, 10); }, {1.0, 2.5}},
      {"nearest_doubles", [] { return nearest_doubles(500, 11); }, {1e-15, 1e-14}},
      {"lidar_lines", [] { return lidar_lines(40, 60, 12); }, {0.1, 0.4}},
      {"along_curves", [] { return along_curves(700); }, {0.01, 0.1, 0.4}},

      {"integer_circle", [] { return integer_circle(32045); }, around(32045)},
      {"integer_circle_moved", [] { return moved(integer_circle(1105), 123456789, -987654321); }, around(1105)},
      {"integer_circle_mirrored",
       [] {
         Points points = integer_circle(1105);
         for (rbpa::Point& p : points) p = {p.y / 1024, p.x / 1024};
         return points;
       },
       around(1105.0 / 1024)},
      {"integer_concentric", [] { return integer_concentric(1105, false); }, around(1105)},
      {"integer_concentric_with_center", [] { return integer_concentric(5525, true); }, around(5525)},
      {"rounded_concentric", [] { return rounded_concentric(300); }, around(1)},
      {"rectangles_of_circumradius_5", [] { return rectangles_of_circumradius_5(30); }, around(5)},
      {"triangles_3_4_5", [] { return triangles_3_4_5(30, 5); }, around(50)},

      {"collinear_horizontal", [] { return collinear_run(100, 1, 0, 13); }, {0.5, 50}},
      {"collinear_vertical", [] { return collinear_run(100, 0, 1, 14); }, {0.5, 50}},
      {"collinear_slanted", [] { return collinear_run(100, 7, -3, 15); }, {0.5, 50}},
      {"collinear_horizontal_some_off", [] { return collinear_run_with_points_off(200, 1, 0, 8, 16); }, {2.5, 50}},
      {"collinear_vertical_some_off", [] { return collinear_run_with_points_off(200, 0, 1, 8, 17); }, {2.5, 50}},
      {"collinear_slanted_some_off", [] { return collinear_run_with_points_off(200, 7, -3, 8, 18); }, {20, 400}},
      {"collinear_one_off", [] { return collinear_run_with_points_off(300, 3, 4, 1, 19); }, {50, 5000}},
      {"nearly_collinear", [] { return collinear_run(300, 0.1, 0.3, 20); }, {1, 1e9}},
      {"crossing_runs", [] { return crossing_runs(60); }, {2.5, 5}},

      {"rounded_circle", [] { return rounded_circle(4000); }, {0.5, 0.99, 1.0, 2.0}},
      {"many_rounded_circles", [] { return many_rounded_circles(20, 150); }, {0.6, 1.0, 5.0}},
      {"along_a_curve", [] { return along_a_curve(3000); }, {0.002, 0.1, 0.3, 0.5}},
      {"circle_line_and_cluster", [] { return circle_line_and_cluster(1000, 32); }, {1e-12, 0.1, 0.5, 0.99, 1.0}},

      {"tiny_components", [] { return tiny_components(2500, 21); }, {0.4, std::sqrt(0.5), 5, 75}},
      {"chain_of_triangles", [] { return chain_of_triangles(500); }, {3}},
      {"ring_of_pinches", [] { return ring_of_pinches(300); }, {ring_of_pinches_alpha}},
      {"small_ring_of_pinches", [] { return ring_of_pinches(24); }, {ring_of_pinches_alpha}},
      {"pairs_at_distance_2", [] { return pairs_at_distance_2(400, 22); }, around(1)},
      {"star", [] { return star(32045); }, {16023, 0.5001 * 32045, 0.51 * 32045}},
      {"small_star", [] { return star(325); }, {163, 0.51 * 325}},

      {"far_from_the_origin", [] { return moved(jittered_grid(30, 0.9, 23), 0x1p40, -0x1p41); }},
      {"farther_from_the_origin", [] { return moved(jittered_grid(30, 0.9, 24), 0x1p52, 0x1p51); }, {1.0, 1.25}},
      {"huge", [] { return scaled(uniform(600, 25), 990); }},
      {"huge_grid", [] { return scaled(perfect_grid(20, 1), 1019); }, {std::ldexp(0.75, 1019)}},
      {"tiny", [] { return scaled(uniform(600, 26), -1000); }},
      {"tiny_grid", [] { return scaled(perfect_grid(20, 1), -1070); }, {std::ldexp(0.75, -1070)}},
      {"denormals", [] { return denormals(1000, 400, 27); }, {std::ldexp(40, -1074)}},
      {"denormal_grid", [] { return denormals(12, 100, 28); }, around(std::ldexp(2, -1074))},
      {"mixed_exponents", [] { return mixed_exponents(120, 29); }, {1e-301, 1e-300, 0.1, 1}},
      {"far_and_tiny", [] { return far_and_tiny(60, 30); }, {1e-301, 1e-300, 1}},
      {"with_a_stranger", [] { return with_strangers(600, 1, 33); }},
      {"with_strangers", [] { return with_strangers(1500, 60, 34); }, {0.8, 1e150, 1e290}},
      {"half_strangers", [] { return with_strangers(120, 110, 35); }, {0.8, 3, 1e200}},
      {"corners_of_range", [] { return corners_of_range(); }, {1, std::numeric_limits<double>::max()}},
  };
}

}  // namespace

Points NamedSet::first(std::size_t most) const {
  Points points = make();
  if (points.size() > most) points.resize(most);
  return points;
}

Points NamedSet::some(std::size_t most) const {
  Points points = make();
  Random(points.size()).shuffle(points);
  if (points.size() > most) points.resize(most);
  return points;
}

std::span<const NamedSet> generated_sets() {
  static const std::vector<NamedSet> sets = table();
  return sets;
}

}  // namespace rbpa_test
