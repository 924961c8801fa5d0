// What: point sets on which a fast path may have to be left, each with a radius and the allowed time relative to CGAL.
// Law:  a set is a function of the number of points alone; seeds are fixed.
#pragma once

#include <string>
#include <vector>

#include "bench/workload.h"

namespace rbpa_bench {

/// Point set, radius, and the bound on the time of the complex, in multiples of CGAL's Delaunay triangulation of the
/// points.
struct SlowPath {
  std::string kind;
  Workload workload;
  std::string alpha_text = "∞";
  double (*alpha)(const rbpa_test::Points& points) = nullptr;  ///< null: no radius
  double max_rbpa = 1.2, max_hrbpa = 1.4;
};

/// Returns curves, dust, lines, crowds, duplicates, grids and exponents.
std::vector<SlowPath> slow_paths();

/// Add the parts of this list (slow_curves.cpp, slow_dust.cpp, slow_rows.cpp).
void add_slow_curves(std::vector<SlowPath>& all);
void add_slow_dust(std::vector<SlowPath>& all);
void add_slow_rows(std::vector<SlowPath>& all);
void add_slow_exponents(std::vector<SlowPath>& all);

}  // namespace rbpa_bench
