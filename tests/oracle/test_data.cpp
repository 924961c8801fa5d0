// Checks rbpa() on point sets from outside the project.
//   --smallest=N, --largest=N   only sets with at least, at most that many points
#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <string>

#include "oracle/check.h"
#include "oracle/delaunay.h"
#include "rbpa/rbpa.h"
#include "support/arguments.h"
#include "support/data_folder.h"
#include "support/random.h"
#include "support/read_points.h"
#include "support/shrink.h"
#include "support/spacing.h"

namespace rbpa_test {
namespace {

bool of_asked_size(const Points& points) {
  return points.size() >= argument("smallest", 0) && points.size() <= argument("largest", 200000);
}

void check_set(const std::string& name, const Points& points) {
  const DelaunayOracle oracle(points);
  Random random(points.size());
  for (const double alpha : usual_alphas(points)) {
    INFO(name, ", ", points.size(), " points, alpha ", literal(alpha));
    const std::vector<Triangle> expected = oracle.triangles(alpha);
    const std::string wrong = wrong_with(rbpa::rbpa(points, alpha), points, expected);
    CHECK_MESSAGE(wrong.empty(), report(wrong, points, alpha));
  }
  const double alpha = 2 * mean_spacing(points);
  INFO(name, ", ", points.size(), " points, alpha ", literal(alpha));
  Points shuffled = points;
  random.shuffle(shuffled);
  const std::string wrong =
      difference(oracle.triangles(alpha), translated(triangles(rbpa::rbpa(shuffled, alpha)), shuffled, points));
  CHECK_MESSAGE(wrong.empty(), "shuffled: ", wrong);
}

TEST_CASE("the complex of bundled point files is the Delaunay triangles of circumradius at most alpha") {
  std::size_t sets = 0;
  for (const PointFile& file : point_files(bundled_data())) {
    const Points points = read_points(file);
    ++sets;
    if (of_asked_size(points)) check_set(file.name, points);
  }
  CHECK(sets >= 30);
}

TEST_CASE("further point files have the complex of Delaunay triangles of circumradius at most alpha") {
  const std::vector<PointFile> files = point_files(further_data());
  CHECK(files.empty() != has_further_data());
  std::set<std::string> bundled;
  for (const PointFile& file : point_files(bundled_data())) bundled.insert(file.name);
  for (const PointFile& file : files) {
    if (bundled.contains(file.name)) continue;
    const Points points = read_points(file);
    if (of_asked_size(points)) check_set(file.name, points);
  }
}

}  // namespace
}  // namespace rbpa_test
