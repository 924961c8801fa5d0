#include "plane/filtration/small_sets.h"

#include "support/generate.h"

namespace rbpa_test {

const std::vector<SmallSet>& small_sets() {
  static const std::vector<SmallSet> sets = [] {
    std::vector<SmallSet> all = {
        {"nothing", {}},
        {"one point", {{3, 4}}},
        {"two points", {{3, 4}, {1, 2}}},
        {"one triangle", {{0, 0}, {3, 0}, {0, 4}}},
        {"all equal", Points(5, {1, 2})},
        {"two triangles that touch in a point", {{0, 0}, {1, 0.5}, {1, -0.5}, {-1, 0.5}, {-1, -0.5}, {0, 40}}},
        // The triangle in the middle comes before any that joins it to one of the others: from three pieces to four.
        {"three triangles far apart",
         {{0, 0}, {-9, -4}, {-7, -6}, {1000, 0}, {1009, -4}, {1007, -6}, {500, 870}, {498, 880}, {502, 880}}},
        {"ring of pinches", ring_of_pinches(12)},
        {"chain of triangles", chain_of_triangles(8)},
        {"grid", perfect_grid(7, 1)},
        {"grid of tenths", perfect_grid(7, 0.1)},
        {"rotated grid", rotated_integer_grid(6)},
        {"rotated rounded grid", rotated_rounded_grid(7)},
        {"triangular lattice", triangular_lattice(7)},
        {"circle", integer_circle(65)},
        {"two circles", integer_concentric(25, false)},
        {"two circles and their center", integer_concentric(25, true)},
        {"two rounded circles", rounded_concentric(20)},
        {"rectangles", rectangles_of_circumradius_5(5)},
        {"triangles 3 4 5", triangles_3_4_5(4, 3)},
        {"on a line", collinear_run(20, 3, 1, 6)},
        {"on a line but one", collinear_run_with_points_off(25, 3, 4, 1, 7)},
        {"on a line but some", collinear_run_with_points_off(30, 7, -3, 6, 8)},
        {"crossing lines", crossing_runs(10)},
        {"repeated", duplicates(25, 4, 9)},
        {"last bits", nearest_doubles(20, 10)},
        {"clusters", clusters(6, 11)},
        {"tiny components", tiny_components(12, 12)},
        {"pairs", pairs_at_distance_2(12, 13)},
        {"star", star(65)},
        {"curves", along_curves(20)},
        {"huge", scaled(uniform(40, 14), 990)},
        {"huge grid", scaled(perfect_grid(6, 1), 1018)},
        {"tiny", scaled(uniform(40, 15), -1000)},
        {"denormal grid", denormals(8, 40, 16)},
        {"huge and tiny", mixed_exponents(10, 17)},
        {"far and tiny", far_and_tiny(6, 18)},
        {"corners of the range", corners_of_range()},
    };
    for (unsigned seed = 0; seed < 12; ++seed) {
      all.push_back({"uniform " + std::to_string(seed), uniform(5 + 5 * seed, 100 + seed)});
      all.push_back({"small grid " + std::to_string(seed), random_grid(7, 4 + 3 * seed, seed % 2 == 0, 200 + seed)});
      all.push_back({"sparse grid " + std::to_string(seed), sparse_grid(8, 0.2 + 0.05 * seed, 300 + seed)});
    }
    return all;
  }();
  return sets;
}

}  // namespace rbpa_test
