#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "oracle/cgal_periodic.h"
#include "oracle/cgal_tetrahedra.h"
#include "rbpa/base/error.h"
#include "rbpa/periodic_solid.h"
#include "support/arguments.h"
#include "support/periodic_sets.h"

using namespace rbpa_test;
using rbpa::PeriodicSolid;
using rbpa::Point3;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// For people: points and sides as doubles that read back.
std::string text(const PeriodicSet& set) {
  std::ostringstream out;
  out << std::hexfloat << set.name << ", box " << set.box.x << " " << set.box.y << " " << set.box.z << ", points";
  for (const Point3& p : set.points) out << " {" << p.x << ", " << p.y << ", " << p.z << "}";
  return out.str();
}

std::vector<std::array<PeriodicCorner, 4>> sorted_rows(const PeriodicSolid& solid) {
  std::vector<std::array<PeriodicCorner, 4>> rows;
  for (const PeriodicCorners& corners : rows_of(solid)) {
    auto& row = rows.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& [point, offset] = corners[k];
      row[k] = {static_cast<int>(point), offset[0], offset[1], offset[2]};
    }
    std::sort(row.begin(), row.end());
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

}  // namespace

TEST_CASE("cubes that repeat have CGAL's periodic Delaunay tetrahedra") {
  const std::uint64_t sets = argument("count", 100);
  std::size_t compared = 0, tetrahedra = 0;
  for (std::uint64_t trial = 0; trial < sets; ++trial) {
    Random random(600 + trial);
    PeriodicSet set = periodic_set(trial, 20 + random.below(200), random);
    set.box = {8, 8, 8};
    set.points = wrapped(set, set.box);
    std::sort(set.points.begin(), set.points.end());
    set.points.erase(std::unique(set.points.begin(), set.points.end()), set.points.end());
    random.shuffle(set.points);
    PeriodicSolid actual;
    try {
      actual = rbpa::periodic_solid(set.points, set.box, infinity);
    } catch (const rbpa::InvalidInput&) {
      continue;
    }
    if (sorted_rows(actual) != periodic_by_cgal(set.points, 8)) FAIL_CHECK(text(set));
    ++compared;
    tetrahedra += actual.simplices.size();
  }
  CHECK(compared > sets / 3);
  CHECK(tetrahedra > 200 * compared);
}

TEST_CASE("boxes that repeat have those of CGAL's Delaunay tetrahedra of 27 images that are within alpha") {
  const std::uint64_t sets = argument("count", 100);
  std::size_t tetrahedra = 0;
  for (std::uint64_t trial = 0; trial < sets; ++trial) {
    Random random(700'000 + trial);
    const PeriodicSet set = periodic_set(trial, 2 + random.below(40), random);
    const double least = std::min({set.box.x, set.box.y, set.box.z});
    const double alpha = trial % 4 == 0 ? std::sqrt(3.0) / 2 : least * random.between(0.05, 0.499);
    const PeriodicSolid actual = rbpa::periodic_solid(set.points, set.box, std::min(alpha, 0.499 * least));
    const AllImages all = all_images(wrapped(set, actual.box), actual.box);
    const TetrahedraByCgal around = DelaunayByCgal(all.positions).within(std::min(alpha, 0.499 * least));
    std::vector<PeriodicCorners> expected;
    for (const auto& row : around.simplices)
      if (all.vertices[row[0]].offset == std::array<std::int8_t, 3>{0, 0, 0})
        expected.push_back({all.vertices[row[0]], all.vertices[row[1]], all.vertices[row[2]], all.vertices[row[3]]});
    if (rows_of(actual) != expected) FAIL_CHECK(text(set));
    tetrahedra += expected.size();
  }
  CHECK(tetrahedra > 20 * sets);
}
