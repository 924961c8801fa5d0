// Reads the output of `rbpa shape` by GEOS: it is the polygons of the library, to the last bit.
#include <doctest/doctest.h>

#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "apps/support/program.h"
#include "oracle/geos_geometry.h"
#include "rbpa/rbpa.h"
#include "support/data_folder.h"
#include "support/pictures.h"
#include "support/random.h"
#include "support/read_points.h"
#include "support/shrink.h"
#include "support/spacing.h"

namespace rbpa_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string shortest(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

void check(const std::string& name, const Points& points, double alpha) {
  INFO(name, ", alpha ", literal(alpha));
  std::string text;
  for (const rbpa::Point& p : points) text += shortest(p.x) + " " + shortest(p.y) + "\n";
  const apps_test::Folder folder;
  folder.file("p.xy", text);
  REQUIRE(folder.rbpa("shape p.xy --alpha " + shortest(alpha) + " -o s.wkt -o s.geojson -q").code == 0);

  const std::vector<rbpa::Polygon> polygons = rbpa::outline_polygons(rbpa::rbpa(points, alpha));
  const GeosGeometry expected = GeosGeometry::of(polygons, points);
  const GeosGeometry wkt = GeosGeometry::from_wkt(folder.content("s.wkt"));
  CHECK(wkt.is_exactly(expected));
  CHECK(wkt.invalid() == "");
  const GeosGeometry geojson = GeosGeometry::from_geojson(folder.content("s.geojson"));
  REQUIRE(geojson.parts() == polygons.size());
  for (std::size_t i = 0; i < polygons.size(); ++i) CHECK(geojson.part(i).is_exactly(expected.part(i)));
}

TEST_CASE("GEOS reads the polygons of bundled point files to the last bit") {
  std::size_t sets = 0;
  for (const PointFile& file : point_files(bundled_data())) {
    const Points points = read_points(file);
    if (points.size() > 5000) continue;
    ++sets;
    for (const double share : {0.7, 1.4, infinity}) check(file.name, points, share * mean_spacing(points));
  }
  CHECK(sets >= 20);
}

TEST_CASE("GEOS reads the polygons of random pictures, full of pinches, to the last bit") {
  Random random(1);
  for (int run = 0; run < 20; ++run)
    check("picture", points_of(random_picture(15, 15, random.between(0.4, 0.9), random)), picture_alpha);
}

}  // namespace
}  // namespace rbpa_test
