// Checks polygons() by GEOS: valid under OGC Simple Features, with the same areas and perimeters.
//   --largest=N   only point files with at most that many points
//   --count=N     number of random pictures and grids
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "oracle/geos_geometry.h"
#include "rbpa/plane/outline_polygons.h"
#include "rbpa/rbpa.h"
#include "support/arguments.h"
#include "support/data_folder.h"
#include "support/generate.h"
#include "support/pictures.h"
#include "support/polygon_laws.h"
#include "support/random.h"
#include "support/read_points.h"
#include "support/sets.h"
#include "support/shrink.h"
#include "support/spacing.h"

namespace rbpa_test {
namespace {

/// Returns the first fault that GEOS finds, "" when there is none. Areas in double lose digits far from the origin.
std::string wrong_by_geos(const std::vector<rbpa::Polygon>& polygons, std::span<const rbpa::Point> points) {
  const GeosGeometry all = GeosGeometry::of(polygons, points);
  if (all.parts() != polygons.size()) return "GEOS counts other parts";
  double extent = 0;
  for (const rbpa::Point& p : points) extent = std::max({extent, std::abs(p.x), std::abs(p.y)});
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const GeosGeometry one = all.part(i);
    if (std::string why = one.invalid(); !why.empty()) return "polygon " + std::to_string(i) + ": " + why;
    if (!one.runs_as_it_should()) return "polygon " + std::to_string(i) + ": a ring runs the wrong way round";
    if (one.holes() != polygons[i].holes.size()) return "polygon " + std::to_string(i) + ": GEOS counts other holes";
    const double rounding = 1e-14 * (extent * polygons[i].perimeter + polygons[i].area);
    if (!(std::abs(one.area() - polygons[i].area) <= rounding))
      return "polygon " + std::to_string(i) + ": area " + literal(polygons[i].area) + ", by GEOS " +
             literal(one.area());
    if (!(std::abs(one.perimeter() - polygons[i].perimeter) <= 1e-10 * polygons[i].perimeter))
      return "polygon " + std::to_string(i) + ": perimeter " + literal(polygons[i].perimeter) + ", by GEOS " +
             literal(one.perimeter());
  }
  return all.invalid();
}

void check(const std::string& name, const Points& points, double alpha) {
  INFO(name, ", ", points.size(), " points, alpha ", literal(alpha));
  const rbpa::SolidAlphaComplex complex = rbpa::rbpa(points, alpha);
  const std::vector<rbpa::Polygon> polygons = rbpa::outline_polygons(complex);
  std::string wrong = wrong_by_geos(polygons, points);
  CHECK_MESSAGE(wrong.empty(), wrong);
  if (points.size() <= 20000) {
    wrong = wrong_with_polygons(polygons, triangles(complex), points);
    CHECK_MESSAGE(wrong.empty(), wrong);
  }
  // Filters as a user might: by a few triangles, and by a share of the largest polygon.
  const double spacing = mean_spacing(points);
  double largest = 0;
  for (const rbpa::Polygon& p : polygons) largest = std::max(largest, p.area);
  for (const rbpa::PolygonFilter& filter :
       {rbpa::PolygonFilter{4 * spacing * spacing, 0}, rbpa::PolygonFilter{largest / 10, largest / 10}}) {
    wrong = wrong_by_geos(rbpa::outline_polygons(complex, filter), points);
    CHECK_MESSAGE(wrong.empty(), "filtered: ", wrong);
  }
}

void check_file(const PointFile& file, const Points& points) {
  if (points.size() > argument("largest", 200000)) return;
  std::vector<double> alphas = usual_alphas(points);
  const double spacing = mean_spacing(points);
  alphas.insert(alphas.end(), {0.7 * spacing, 1.4 * spacing});  // radii with most pinches
  for (const double alpha : alphas) check(file.name, points, alpha);
}

TEST_CASE("polygons of bundled point files are valid, one by one and together, with the area that GEOS finds") {
  std::size_t sets = 0;
  for (const PointFile& file : point_files(bundled_data())) {
    ++sets;
    check_file(file, read_points(file));
  }
  CHECK(sets >= 30);
}

TEST_CASE("further point files have valid polygons, one by one and together, with the area that GEOS finds") {
  const std::vector<PointFile> files = point_files(further_data());
  CHECK(files.empty() != has_further_data());
  std::set<std::string> bundled;
  for (const PointFile& file : point_files(bundled_data())) bundled.insert(file.name);
  for (const PointFile& file : files)
    if (!bundled.contains(file.name)) check_file(file, read_points(file));
}

TEST_CASE("polygons of random pictures, full of pinches, are valid") {
  Random random(1);
  const std::uint64_t count = argument("count", 300);
  for (std::uint64_t run = 0; run < count; ++run) {
    const Picture picture = random_picture(20, 20, random.between(0.4, 0.9), random);
    check("picture", points_of(picture), picture_alpha);
  }
}

TEST_CASE("polygons of random grids, full of pinches, are valid") {
  Random random(2);
  const std::uint64_t count = argument("count", 300);
  for (std::uint64_t run = 0; run < count; ++run) {
    const int columns = random.integer(3, 25);
    const auto points =
        random_grid(columns, static_cast<std::size_t>(random.integer(3, columns * columns)), false, random.bits());
    for (const double alpha : {0.75, 1.0, 1.25, 1.6, 2.5}) check("grid", points, alpha);
  }
}

TEST_CASE("polygons of generated sets are valid, if GEOS can hold the products of coordinates") {
  for (const NamedSet& set : generated_sets()) {
    const Points points = set.make();
    bool fits = true;
    for (const rbpa::Point& p : points)
      for (const double c : {p.x, p.y}) fits = fits && (c == 0 || (std::abs(c) < 1e60 && std::abs(c) > 1e-60));
    if (!fits) continue;
    std::vector<double> alphas = usual_alphas(points);
    alphas.insert(alphas.end(), set.alphas.begin(), set.alphas.end());
    for (const double alpha : alphas) check(std::string(set.name), points, alpha);
  }
}

}  // namespace
}  // namespace rbpa_test
