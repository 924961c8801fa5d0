#include "rbpa/fill.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "fill/laws.h"
#include "fill/refusal.h"
#include "rbpa/plane/alpha_complex.h"
#include "support/data_folder.h"
#include "support/exact.h"
#include "support/generate_polygons.h"
#include "support/random.h"
#include "support/read_points.h"

TEST_SUITE_BEGIN("fill");

namespace {

using rbpa::fill;
using rbpa::Filling;
using rbpa::FillOptions;
using rbpa::Point;
using rbpa::Polygon;
using rbpa::Ring;
using rbpa_test::Points;
using rbpa_test::PolygonCase;
using rbpa_test::refusal;
using rbpa_test::square;

/// Options that alternate with the number: constant size, graded from the boundary, sizes at points, the boundary kept.
struct ChosenOptions {
  FillOptions options;
  std::vector<rbpa::SizeAt> sizes = {};
};
ChosenOptions chosen_options(const PolygonCase& polygon, std::size_t number) {
  ChosenOptions chosen{.options = {.size = polygon.size}};
  if (number / 10 % 4 == 1) chosen.options.grade = 0.3;
  if (number / 10 % 4 == 2)
    for (std::size_t i = 0; i < 3; ++i)
      chosen.sizes.push_back({polygon.points[(i * 7) % polygon.points.size()], polygon.size / 4});
  chosen.options.sizes = chosen.sizes;
  chosen.options.keep_boundary = number / 10 % 4 == 3;
  return chosen;
}

/// Returns the triangles as coordinates, which do not depend on the order of the points.
std::vector<std::array<Point, 3>> places_of(const Filling& filling) {
  std::vector<std::array<Point, 3>> places;
  for (const auto& [a, b, c] : filling.triangles) {
    std::array<Point, 3> corner{filling.points[a], filling.points[b], filling.points[c]};
    std::rotate(corner.begin(), std::min_element(corner.begin(), corner.end()), corner.end());
    places.push_back(corner);
  }
  std::sort(places.begin(), places.end());
  return places;
}

/// Fills the polygons of alpha shapes, one by one.
struct AlphaShapes {
  std::size_t filled = 0, touching = 0;
  rbpa_test::FillQuality quality = {};

  void fill_all(const Points& points, double alpha) {
    const rbpa::AlphaComplex complex = rbpa::alpha_complex(points, alpha, {.neighbors = true});
    for (const Polygon& polygon : rbpa::outline_polygons(points, complex)) {
      INFO(points.size(), " points, alpha ", alpha, ", polygon from point ", polygon.shell.points[0]);
      std::map<std::uint32_t, int> passed;
      for (const std::uint32_t i : polygon.shell.points) ++passed[i];
      for (const Ring& hole : polygon.holes)
        for (const std::uint32_t i : hole.points) ++passed[i];
      const FillOptions options{.size = polygon.perimeter / 100, .grade = 0.5};
      touching += std::any_of(passed.begin(), passed.end(), [](const auto& p) { return p.second > 1; });
      ++filled;
      const Filling filling = fill(points, std::vector{polygon}, options);
      const std::string wrong = rbpa_test::wrong_with_filling(filling, points, std::vector{polygon}, false);
      CHECK_MESSAGE(wrong.empty(), wrong);
      const rbpa_test::FillQuality one = rbpa_test::quality_of(filling, options, points, std::vector{polygon});
      quality.edges += one.edges;
      quality.edges_in_range += one.edges_in_range;
      quality.triangles += one.triangles;
      quality.with_20_degrees += one.with_20_degrees;
    }
  }
};

}  // namespace

TEST_CASE("polygons are covered once by counter-clockwise triangles that meet in whole edges") {
  std::size_t retreats = 0;
  for (std::size_t number = 0; number < 200; ++number) {
    const PolygonCase polygon = rbpa_test::polygon_case(number);
    INFO(polygon.name);
    const ChosenOptions chosen = chosen_options(polygon, number);
    const Filling filling = fill(polygon.points, polygon.polygons, chosen.options);
    retreats += filling.retreats;
    const std::string wrong =
        rbpa_test::wrong_with_filling(filling, polygon.points, polygon.polygons, chosen.options.keep_boundary);
    CHECK_MESSAGE(wrong.empty(), wrong);
  }
  CHECK(retreats > 0);  // otherwise no retreat was tested
}

TEST_CASE("where there is room, edges have about the target length and angles are not small") {
  for (std::size_t number = 0; number < 200; ++number) {
    const PolygonCase polygon = rbpa_test::polygon_case(number);
    const ChosenOptions chosen = chosen_options(polygon, number);
    if (!polygon.is_roomy || chosen.options.keep_boundary) continue;
    INFO(polygon.name);
    const rbpa_test::FillQuality quality = rbpa_test::quality_of(fill(polygon.points, polygon.polygons, chosen.options),
                                                                 chosen.options, polygon.points, polygon.polygons);
    CHECK(double(quality.edges_in_range) >= 0.95 * double(quality.edges));
    CHECK(double(quality.with_20_degrees) >= 0.99 * double(quality.triangles));
  }
}

TEST_CASE("sizes grow from short edges, where a grade is given, and from points with a size") {
  std::vector<rbpa::SizeAt> sizes = {{{1.5, 0.5}, 0.01}, {{0.2, 0.8}, 0.05}};
  for (std::size_t number = 7; number < 200; number += 50) {  // notched
    const PolygonCase polygon = rbpa_test::polygon_case(number);
    for (const double grade : {0.2, 0.5}) {
      INFO(polygon.name, ", grade ", grade);
      const FillOptions options{.size = polygon.size, .grade = grade, .sizes = sizes};
      const Filling filling = fill(polygon.points, polygon.polygons, options);
      CHECK(rbpa_test::wrong_with_filling(filling, polygon.points, polygon.polygons, false) == "");
      const rbpa_test::FillQuality quality = rbpa_test::quality_of(filling, options, polygon.points, polygon.polygons);
      CHECK(double(quality.edges_in_range) >= 0.95 * double(quality.edges));
      CHECK(double(quality.with_20_degrees) >= 0.99 * double(quality.triangles));
      const Filling constant = fill(polygon.points, polygon.polygons, {.size = polygon.size});
      CHECK(4 * constant.triangles.size() < 3 * filling.triangles.size());
    }
  }
}

TEST_CASE("no inner edge is illegal: the triangulation is the constrained Delaunay triangulation of its points") {
  for (std::size_t number = 0; number < 40; ++number) {
    const PolygonCase polygon = rbpa_test::polygon_case(number);
    INFO(polygon.name);
    const ChosenOptions chosen = chosen_options(polygon, number);
    const Filling filling = fill(polygon.points, polygon.polygons, chosen.options);
    std::size_t illegal = 0;
    for (std::size_t t = 0; t < filling.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t other = filling.neighbors[t][k];
        if (other == rbpa::TriangleArrays::none || other < t) continue;
        const auto& across = filling.neighbors[other];
        const std::size_t j = static_cast<std::size_t>(std::find(across.begin(), across.end(), t) - across.begin());
        const auto& [a, b, c] = filling.triangles[t];
        illegal += rbpa_test::exact::in_circle(filling.points[a], filling.points[b], filling.points[c],
                                               filling.points[filling.triangles[other][j]]) > 0;
      }
    CHECK(illegal == 0);
  }
}

TEST_CASE("triangles do not depend on where rings begin, their direction and their order") {
  rbpa_test::Random random(7);
  for (const std::size_t number : {0U, 1U, 2U, 3U, 4U, 5U, 7U, 8U, 18U, 28U, 38U, 9U}) {
    const PolygonCase polygon = rbpa_test::polygon_case(number);
    INFO(polygon.name);
    const ChosenOptions chosen = chosen_options(polygon, number);
    const Filling first = fill(polygon.points, polygon.polygons, chosen.options);
    CHECK(fill(polygon.points, polygon.polygons, chosen.options).triangles == first.triangles);
    for (int turn = 0; turn < 3; ++turn) {
      std::vector<std::uint32_t> name(polygon.points.size());
      for (std::uint32_t i = 0; i < name.size(); ++i) name[i] = i;
      random.shuffle(name);
      Points points(name.size());
      for (std::size_t i = 0; i < name.size(); ++i) points[name[i]] = polygon.points[i];
      std::vector<Polygon> polygons = polygon.polygons;
      const auto change = [&](Ring& ring) {
        for (std::uint32_t& i : ring.points) i = name[i];
        std::rotate(ring.points.begin(),
                    ring.points.begin() + static_cast<std::ptrdiff_t>(random.below(ring.points.size())),
                    ring.points.end());
        if (random.chance(0.5)) std::reverse(ring.points.begin(), ring.points.end());
      };
      for (Polygon& one : polygons) {
        change(one.shell);
        for (Ring& hole : one.holes) change(hole);
        random.shuffle(one.holes);
      }
      random.shuffle(polygons);
      CHECK(places_of(fill(points, polygons, chosen.options)) == places_of(first));
    }
  }
}

TEST_CASE("a power of two scales the triangles and changes nothing else") {
  for (const std::size_t number : {0U, 4U, 7U}) {
    const PolygonCase polygon = rbpa_test::polygon_case(number);
    INFO(polygon.name);
    std::vector<rbpa::SizeAt> sizes = {{polygon.points[1], polygon.size / 3}};
    const Filling plain = fill(polygon.points, polygon.polygons, {.size = polygon.size, .grade = 0.3, .sizes = sizes});
    for (const int exponent : {40, -40, 900, -900}) {
      Points points = polygon.points;
      for (Point& p : points) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
      const std::vector<rbpa::SizeAt> scaled = {{points[1], std::ldexp(sizes[0].size, exponent)}};
      const Filling filling =
          fill(points, polygon.polygons, {.size = std::ldexp(polygon.size, exponent), .grade = 0.3, .sizes = scaled});
      CHECK(filling.triangles == plain.triangles);
      CHECK(filling.points.size() == plain.points.size());
    }
  }
}

TEST_CASE("a polygon as small as the last place of its coordinates is filled") {
  // The polygon is a few representable numbers wide: nearly every new point coincides with an existing one.
  for (const double far : {1.0, 0x1p30, 0x1p52}) {
    const double unit = far * 0x1p-52;
    for (const double wide : {1.0, 2.0, 3.0, 8.0})
      for (const double size : {0.3, 1.0, 2.5}) {
        INFO(far, " ", wide, " ", size);
        const Points points = {
            {far, far}, {far + wide * unit, far}, {far + wide * unit, far + unit}, {far, far + 2 * unit}};
        const Filling filling = fill(points, std::vector{square()}, {.size = size * unit});
        const std::string wrong = rbpa_test::wrong_with_filling(filling, points, std::vector{square()}, false);
        CHECK_MESSAGE(wrong.empty(), wrong);
      }
  }
}

TEST_CASE("an edge stays whole where its pieces, rounded, would meet other edges") {
  rbpa_test::Random random(11);
  std::size_t filled = 0, whole = 0;
  for (int i = 0; i < 300; ++i) {
    // An edge of a hole lies below a slanted edge of the shell, some units in the last place away.
    const Point a{0, random.between(1, 2)}, b{1, random.between(1, 2)};
    const auto below = [&](double share) {
      double y = a.y + share * (b.y - a.y);
      for (int step = random.integer(1, 2); step > 0; --step) y = std::nextafter(y, 0);
      return Point{share, y};
    };
    const Points points = {{0, 0}, {1, 0}, b, a, below(0.125), below(0.875), {0.5, 0.25}};
    Polygon polygon = square();
    polygon.holes.push_back({{4, 5, 6}});
    if (refusal(points, {polygon}, {.size = 3}) != "") continue;  // they do meet
    ++filled;
    const Filling filling = fill(points, std::vector{polygon}, {.size = 0.07});
    const std::string wrong = rbpa_test::wrong_with_filling(filling, points, std::vector{polygon}, false);
    CHECK_MESSAGE(wrong.empty(), wrong);
    const auto& hole = filling.polygons[0].holes[0].points;
    const auto at = static_cast<std::size_t>(std::find(hole.begin(), hole.end(), 4U) - hole.begin());
    whole += hole[(at + 1) % hole.size()] == 5 || hole[(at + hole.size() - 1) % hole.size()] == 5;
  }
  CHECK(filled > 100);
  CHECK(whole > 3);
  CHECK(whole < filled);
}

TEST_CASE("a polygon with coordinates of very different magnitudes is filled") {
  const Points points = {{0, 0}, {1e-200, 1e-210}, {1, 0}, {1, 1}, {1e-250, 0.5}, {-1e-250, 1e-220}};
  const std::vector<Polygon> polygons = {{.shell = {{0, 1, 2, 3, 4, 5}}}};
  const Filling filling = fill(points, polygons, {.size = 0.3});
  CHECK(rbpa_test::wrong_with_filling(filling, points, polygons, false) == "");
  Points larger = points;
  for (Point& p : larger) p = {p.x * 0x1p700, p.y * 0x1p700};
  CHECK(fill(larger, polygons, {.size = std::ldexp(0.3, 700)}).triangles == filling.triangles);
  const Points too_far = {{5e-324, 0}, {1e300, 0}, {1e300, 1e300}, {0, 1e300}};
  CHECK(refusal(too_far, {square()}, {.size = 1e299}).find("closer in magnitude") != std::string::npos);
}

TEST_CASE("a size larger than the polygon adds no points") {
  for (const std::size_t number : {0U, 1U, 2U, 3U, 4U, 5U, 8U, 9U}) {
    const PolygonCase polygon = rbpa_test::polygon_case(number);
    INFO(polygon.name);
    const Filling filling = fill(polygon.points, polygon.polygons, {.size = 1e6, .keep_boundary = true});
    CHECK(filling.boundary_points == polygon.points.size());
    CHECK(rbpa_test::wrong_with_filling(filling, polygon.points, polygon.polygons, true) == "");
  }
  const Points triangle = {{0, 0}, {1, 0}, {0, 1}};
  CHECK(fill(triangle, std::vector<Polygon>{{.shell = {{0, 1, 2}}}}, {.size = 5}).triangles.size() == 1);
}

TEST_CASE("points on no ring stay where they are and are in no triangle") {
  const Points points = {{0.5, 0.5}, {0, 0}, {1, 0}, {7, 7}, {1, 1}, {0, 1}};
  const std::vector<Polygon> polygons = {{.shell = {{1, 2, 4, 5}}}};
  const Filling filling = fill(points, polygons, {.size = 0.4});
  CHECK(rbpa_test::wrong_with_filling(filling, points, polygons, false) == "");
  for (const auto& triangle : filling.triangles)
    for (const std::uint32_t i : triangle) CHECK((i != 0 && i != 3));
  CHECK(fill(points, {}, {.size = 1}).triangles.empty());
  CHECK(fill(points, {}, {.size = 1}).points == points);
}

TEST_CASE("polygons of alpha shapes are filled, also those that touch themselves") {
  AlphaShapes shapes;
  for (const char* name : {"mol_2xhe_xy", "geo_usgs_quakes_week", "shape_concaveman_1k", "geo_us_zipcodes"}) {
    const double alpha = std::string(name).starts_with("geo") ? 1.5 : std::string(name).starts_with("mol") ? 2 : 40;
    shapes.fill_all(rbpa_test::read_points({name, {rbpa_test::bundled_data() / (std::string(name) + ".xy")}}), alpha);
  }
  CHECK(shapes.filled > 20);
  CHECK(shapes.touching > 0);
}

TEST_CASE("how coasts and counties are filled, and two thousand generated polygons" * doctest::skip()) {
  AlphaShapes shapes;
  for (const rbpa_test::PointFile& file : rbpa_test::point_files(rbpa_test::further_data())) {
    if (file.name != "geo_ne_50m_coastline" && file.name != "geo_us_counties_10m") continue;
    for (const double alpha : {0.2, 0.5, 1.0, 2.0, 4.0, 8.0}) shapes.fill_all(read_points(file), alpha);
  }
  MESSAGE(shapes.filled << " filled, " << shapes.touching << " of them touch themselves; of " << shapes.quality.edges
                        << " edges " << shapes.quality.edges_in_range << " in range, of " << shapes.quality.triangles
                        << " triangles " << shapes.quality.with_20_degrees << " with 20 degrees");
  for (std::size_t number = 200; number < 2200; ++number) {
    const PolygonCase polygon = rbpa_test::polygon_case(number);
    INFO(polygon.name);
    const ChosenOptions chosen = chosen_options(polygon, number);
    const Filling filling = fill(polygon.points, polygon.polygons, chosen.options);
    const std::string wrong =
        rbpa_test::wrong_with_filling(filling, polygon.points, polygon.polygons, chosen.options.keep_boundary);
    CHECK_MESSAGE(wrong.empty(), wrong);
  }
}

TEST_SUITE_END();
