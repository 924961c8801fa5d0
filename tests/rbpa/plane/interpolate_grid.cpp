#include "rbpa/plane/interpolate_grid.h"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "rbpa/base/error.h"
#include "rbpa/plane/constrained_delaunay.h"
#include "support/arguments.h"
#include "support/delaunay_arrays.h"
#include "support/exact.h"
#include "support/generate.h"
#include "support/random.h"
#include "support/refusal_of.h"
#include "support/sets.h"

using namespace rbpa_test;
using rbpa::AlphaComplex;
using rbpa::Interpolation;
using rbpa::Locator;
using rbpa::Point;
using rbpa::Raster;

TEST_SUITE_BEGIN("locate");

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Returns the points, middles of sides (on a side or nearly), and centers of triangles.
Points places_on(const Points& points, const AlphaComplex& of) {
  Points places = points;
  for (const auto& t : of.triangles) {
    const Point &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    places.push_back({a.x / 2 + b.x / 2, a.y / 2 + b.y / 2});
    places.push_back({b.x / 2 + c.x / 2, b.y / 2 + c.y / 2});
    places.push_back({a.x / 3 + b.x / 3 + c.x / 3, a.y / 3 + b.y / 3 + c.y / 3});
  }
  return places;
}

std::vector<std::uint64_t> bits_of(const std::vector<double>& values) {
  std::vector<std::uint64_t> bits;
  for (const double value : values) bits.push_back(std::isnan(value) ? 1 : std::bit_cast<std::uint64_t>(value));
  return bits;
}

std::vector<double> grid_of(const Locator& locator, const std::vector<double>& values, const Raster& raster,
                            const rbpa::InterpolateOptions& options = {}) {
  std::vector<double> all;
  rbpa::interpolate_grid(
      locator, values, raster, [&](auto cells) { all.insert(all.end(), cells.begin(), cells.end()); }, options);
  return all;
}

}  // namespace

TEST_CASE("there is a value exactly where a triangle of the alpha complex contains the query, sides included") {
  std::size_t without = 0;
  for (const NamedSet& set : generated_sets()) {
    CAPTURE(set.name);
    const std::size_t most = all_trials() ? 30 : 12;  // exact arithmetic is slow
    Points points = set.first(most);
    const AlphaComplex of = delaunay_arrays(points);
    const Points places = places_on(points, of);
    const Locator locator(points, of);
    const std::vector<double> values(points.size(), 1);
    for (const double alpha : {0.5, 0.75, 5.0, infinite}) {
      const AlphaComplex part = rbpa::alpha_complex(points, alpha);
      for (const auto method : {Interpolation::linear, Interpolation::natural_neighbor}) {
        if (method != Interpolation::linear && alpha != 0.75) continue;  // exact shares are slow
        const auto found = locator.interpolate(values, 1, places, {.method = method, .alpha = alpha});
        for (std::size_t i = 0; i < places.size(); ++i) {
          const bool expected = std::any_of(part.triangles.begin(), part.triangles.end(), [&](const auto& t) {
            for (std::size_t k = 0; k < 3; ++k)
              if (exact::orientation(points[t[k]], points[t[(k + 1) % 3]], places[i]) < 0) return false;
            return true;
          });
          REQUIRE(std::isnan(found[i]) == !expected);
          without += expected ? 0 : 1;
        }
      }
    }
  }
  CHECK(without > 500);
}

TEST_CASE("shuffled points have the same values to the last bit, on sides and points too, by both methods") {
  Random random(7);
  std::size_t compared = 0;
  for (const NamedSet& set : generated_sets()) {
    CAPTURE(set.name);
    const std::size_t most = all_trials() ? 60 : 12;  // exact shares are slow
    Points points = set.first(most);
    const AlphaComplex of = delaunay_arrays(points);
    const Points places = places_on(points, of);
    const auto values_of = [](const Points& at) {  // a function of the place, as equal points have one value
      std::vector<double> values;
      for (const Point& p : at)
        values.push_back(
            static_cast<double>(
                (std::bit_cast<std::uint64_t>(p.x + 0.0) * 31 + std::bit_cast<std::uint64_t>(p.y + 0.0) * 17) >> 20) *
            0x1p-44);
      return values;
    };
    Points shuffled = points;
    random.shuffle(shuffled);
    const AlphaComplex again = delaunay_arrays(shuffled);
    for (const auto method : {Interpolation::linear, Interpolation::natural_neighbor}) {
      CAPTURE(int(method));
      const auto first = Locator(points, of).interpolate(values_of(points), 1, places, {.method = method});
      const auto second = Locator(shuffled, again).interpolate(values_of(shuffled), 1, places, {.method = method});
      CHECK(bits_of(first) == bits_of(second));
      compared += first.size();
    }
  }
  CHECK(compared > 3000);
}

TEST_CASE("a raster has at each cell the value at its center, from the top row on, with any number of threads") {
  const Points points = uniform(12000, 3);
  std::vector<double> values;
  for (const Point& p : points) values.push_back(std::sin(p.x) + p.y);
  const AlphaComplex of = delaunay_arrays(points);
  const Locator locator(points, of);
  const Raster raster = rbpa::raster_around({-1, -1}, {111, 111}, 0.1);  // of more than one block
  REQUIRE(raster.columns * raster.rows > (std::size_t{1} << 20U));
  const std::vector<double> found = grid_of(locator, values, raster, {.threads = 1, .alpha = 2});
  REQUIRE(found.size() == raster.columns * raster.rows);
  for (const unsigned threads : {2U, 7U})
    CHECK(bits_of(grid_of(locator, values, raster, {.threads = threads, .alpha = 2})) == bits_of(found));
  for (std::size_t i = 0; i < found.size(); i += 997) {
    const Point at{-1 + (double(i % raster.columns) + 0.5) * 0.1,
                   -1 + (double(raster.rows - 1 - i / raster.columns) + 0.5) * 0.1};
    const double expected = locator.interpolate(values, 1, std::span(&at, 1), {.alpha = 2})[0];
    CHECK((found[i] == expected || (std::isnan(found[i]) && std::isnan(expected))));
  }
  CHECK_THROWS_AS(grid_of(locator, values, raster, {.go_on = [] { return false; }}), rbpa::Cancelled);
  CHECK_THROWS_AS(grid_of(locator, values, raster, {.alpha = 0}), rbpa::InvalidInput);
  CHECK_THROWS_AS(grid_of(locator, values, raster, {.alpha = std::nan("")}), rbpa::InvalidInput);
}

TEST_CASE("natural neighbors of a constrained triangulation are refused, and linear values are not") {
  const Points points = uniform(300, 4);
  const std::vector<double> values(points.size(), 2);
  const std::vector<rbpa::Segment> segments = {{0, 1}};
  const rbpa::ConstrainedDelaunay made = rbpa::constrained_delaunay(points, segments, {});
  const Locator locator(points, made);
  const Raster raster = rbpa::raster_around({2, 2}, {4, 4}, 1);
  const std::string as_expected = "method: found \"natural\", expected \"linear\", as segments bound neighbors";
  for (const bool as_grid : {false, true}) {
    const auto interpolate = [&](Interpolation method) {
      return as_grid ? grid_of(locator, values, raster, {.method = method})
                     : locator.interpolate(values, 1, points, {.method = method});
    };
    CHECK(interpolate(Interpolation::linear)[0] == 2);
    CHECK(refusal_of<rbpa::InvalidInput>([&] { interpolate(Interpolation::natural_neighbor); }) == as_expected);
  }
}

TEST_CASE("sides of a raster are at multiples of the cell, and impossible cells are refused") {
  const Raster around = rbpa::raster_around({0.3, -0.2}, {2.1, 0.9}, 0.5);
  CHECK(around.origin == Point{0, -0.5});
  CHECK(around.columns == 5);
  CHECK(around.rows == 3);
  CHECK(around.center(0, 0) == Point{0.25, 0.75});
  const Raster exact = rbpa::raster_around({1, 1}, {3, 2}, 1);  // no cell outside of the box
  CHECK(exact.columns == 2);
  CHECK(exact.rows == 1);
  const Raster large = rbpa::raster_around({1, 1}, {3, 2}, 100), point = rbpa::raster_around({3, 3}, {3, 3}, 1);
  CHECK(large.columns * large.rows == 1);
  CHECK(point.columns * point.rows == 1);
  for (const double cell : {0.0, -1.0, infinite, std::nan(""), 1e-300, 1e-10, 1e-6})
    CHECK_THROWS_AS(rbpa::raster_around({0, 0}, {1, 1}, cell), rbpa::InvalidInput);
  CHECK_THROWS_AS(rbpa::raster_around({1e300, 0}, {1e300, 1}, 1), rbpa::InvalidInput);
  CHECK_THROWS_AS(rbpa::raster_around({-1e308, 0}, {1e308, 1}, 1), rbpa::InvalidInput);
  CHECK(rbpa::raster_around({0, 0}, {1, 1}, 1e-5).columns == 100000);
}

TEST_SUITE_END();
