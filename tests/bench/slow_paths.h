// What: point sets on which a fast way may have to be left: each with the radius and how slow it may be beside CGAL.
// Law:  a function of the number of points alone; seeds are fixed.
#pragma once

#include <string>
#include <vector>

#include "bench/workload.h"

namespace rbpa_bench {

/// A set, a radius, and the bound on the time of the complex, in times of CGAL's Delaunay triangulation of the points.
struct SlowPath {
  std::string kind;
  Workload workload;
  std::string alpha_text = "∞";
  double (*alpha)(const rbpa_test::Points& points) = nullptr;  ///< null: no radius
  double max_rbpa = 1.2, max_hrbpa = 1.4;
};

/// Curves, dust, lines, crowds, duplicates, grids and exponents.
std::vector<SlowPath> slow_paths();

/// The parts of it (slow_curves.cpp, slow_dust.cpp, slow_rows.cpp).
void add_slow_curves(std::vector<SlowPath>& all);
void add_slow_dust(std::vector<SlowPath>& all);
void add_slow_rows(std::vector<SlowPath>& all);
void add_slow_exponents(std::vector<SlowPath>& all);

}  // namespace rbpa_bench
