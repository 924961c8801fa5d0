// Compares hrbpa() with CGAL: the final complex, and the mesh after every level, for leaf capacities from 1 to 64.
//   --largest=N   only sets with at most that many points
//   --paper=N     the paper's method, which is slow, only on sets with at most that many points
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "oracle/check.h"
#include "oracle/delaunay.h"
#include "support/arguments.h"
#include "support/data_folder.h"
#include "support/levels.h"
#include "support/random.h"
#include "support/read_points.h"
#include "support/sets.h"
#include "support/shrink.h"
#include "support/spacing.h"

namespace rbpa_test {
namespace {

constexpr std::size_t max_levels = 5;  // number of levels checked in a set with many

template <typename Compute>
void check_set(Compute compute, const std::string& name, const Points& points, std::vector<double> alphas,
               Random& random) {
  const DelaunayOracle oracle(points);
  alphas.push_back(INFINITY);
  for (const double alpha : alphas) {
    const std::size_t capacity = std::size_t{1} << random.below(7);
    INFO(name, ", ", points.size(), " points, alpha ", literal(alpha), ", leaf capacity ", capacity);
    const rbpa::Hierarchy h = compute(points, alpha, capacity);
    const std::string wrong = wrong_with(h.complex, points, oracle.triangles(alpha));
    CHECK_MESSAGE(wrong.empty(), wrong);
    const std::size_t step = std::max<std::size_t>(1, h.levels.size() / max_levels);
    for (std::size_t i = 0; i < h.levels.size(); i += step) {
      INFO("after level ", h.levels[i].number, ", alpha ", literal(h.levels[i].alpha));
      const std::string wrong_here = difference(oracle.triangles(h.levels[i].alpha), triangles_after(h, i));
      CHECK_MESSAGE(wrong_here.empty(), wrong_here);
    }
  }
}

bool of_asked_size(const Points& points) { return points.size() <= argument("largest", 20000); }

TEST_CASE("after every level of generated sets the mesh is the Delaunay triangles within its radius") {
  Random random(21);
  for (const NamedSet& set : generated_sets()) {
    const Points points = set.make();
    if (of_asked_size(points)) check_set(hierarchy, std::string(set.name), points, set.alphas, random);
  }
}

TEST_CASE("after every level of the paper's HRBPA the mesh is the Delaunay triangles within its radius") {
  Random random(23);
  for (const NamedSet& set : generated_sets()) {
    const Points points = set.make();
    if (of_asked_size(points) && points.size() <= argument("paper", 20000))
      check_set(hierarchy_by_paper, std::string(set.name), points, set.alphas, random);
  }
}

/// Checks the sets of a folder, and returns how many there are.
std::size_t check_files(const std::filesystem::path& folder) {
  Random random(22);
  std::size_t sets = 0;
  for (const PointFile& file : point_files(folder)) {
    const Points points = read_points(file);
    if (!of_asked_size(points)) continue;
    ++sets;
    check_set(hierarchy, file.name, points, {2 * mean_spacing(points)}, random);
  }
  return sets;
}

TEST_CASE("after every level of bundled point files the mesh is the Delaunay triangles within its radius") {
  CHECK(check_files(bundled_data()) >= 14);
}

TEST_CASE("further point files have after every level the Delaunay triangles within its radius") {
  CHECK((check_files(further_data()) > 0) == has_further_data());
}

}  // namespace
}  // namespace rbpa_test
