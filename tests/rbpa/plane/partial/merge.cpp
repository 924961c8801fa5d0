// The promises of merge(), and refused input.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "plane/partial/cuts.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/partial.h"
#include "rbpa/plane/partial_bytes.h"
#include "support/arguments.h"
#include "support/generate.h"
#include "support/infinity.h"
#include "support/pictures.h"
#include "support/refusal_of.h"

using namespace rbpa_test;
using rbpa::Partial;
using rbpa::Point;
using rbpa::Region;

TEST_SUITE_BEGIN("partial");

namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes bytes_of(const Partial& partial) { return rbpa::to_bytes(partial); }

template <typename Run>
std::string refusal(Run run) {
  return refusal_of<rbpa::InvalidInput>(run);
}

bool says(const std::string& text, const char* part) {
  const bool does = text.find(part) != std::string::npos;
  if (!does) MESSAGE(text);
  return does;
}

const Regions halves{{-infinity, -infinity, 10, infinity}, {10, -infinity, infinity, infinity}};

std::size_t corners_of(const rbpa::TakenHoles& taken) {
  std::size_t corners = 0;
  for (const rbpa::CornerRing& hole : taken.holes) corners += hole.size();
  return corners;
}

}  // namespace

TEST_CASE("merge is associative: a thousand random trees of merges give the same bytes") {
  Random random(1);
  for (const double alpha : {0.62, 0.8}) {
    const Points points = uniform(1500, 7);
    const Regions regions = quartering_cut(points, 40);
    REQUIRE(regions.size() > 40);
    const std::vector<Partial> parts = partials(regions, points, alpha);
    const Bytes expected = bytes_of(merged(parts, random));
    for (int tree = 0; tree < 500; ++tree) REQUIRE(bytes_of(merged(parts, random)) == expected);
  }
}

TEST_CASE("merging some of the regions gives the same bytes in any order, also of regions that are not adjacent") {
  Random random(2);
  for (int run = 0; run < trials(400); ++run) {
    const Points points = points_of(random_picture(9, 9, random.between(0.4, 0.8), random));
    const Regions regions = any_cut(points, 12, random);
    std::vector<Partial> some;
    for (Partial& part : partials(regions, points, picture_alpha))
      if (random.chance(0.6)) some.push_back(std::move(part));
    const Bytes expected = bytes_of(merged(some, random));
    for (int order = 0; order < 4; ++order) REQUIRE(bytes_of(merged(some, random)) == expected);
  }
}

TEST_CASE("a part of the plane has the same bytes however it is cut") {
  Random random(6);
  for (int run = 0; run < trials(300); ++run) {
    const Points points = points_of(random_picture(9, 9, random.between(0.4, 0.95), random));
    const Point middle = points[random.below(points.size())];
    const Region part{-infinity, -infinity, middle.x + 6, infinity};
    Regions cut;
    for (const double x : {-infinity, middle.x})
      for (const double y : {-infinity, middle.y})
        cut.push_back({x, y, x < middle.x ? middle.x : part.x1, y < middle.y ? middle.y : infinity});
    const Bytes expected = bytes_of(partials({part}, points, picture_alpha)[0]);
    REQUIRE(bytes_of(merged(partials(cut, points, picture_alpha), random)) == expected);
  }
}

TEST_CASE("the order of points, points beyond the halo and threads change no byte") {
  Random random(3);
  const Points points = uniform(3000, 3);
  for (const Region& region : quartering_cut(points, 400)) {
    const Bytes expected = bytes_of(rbpa::partial(region, given(region, points, 0.9), 0.9));
    CHECK(bytes_of(rbpa::partial(region, given(region, points, 0.9, &random), 0.9)) == expected);
    CHECK(bytes_of(rbpa::partial(region, given(region, points, 3.5), 0.9)) == expected);
  }
  const Points many = uniform(60'000, 4);
  const Region region{20, 20, 200, 180};
  const Bytes expected = bytes_of(rbpa::partial(region, given(region, many, 0.7), 0.7, {.threads = 1}));
  for (const unsigned threads : {0U, 2U, 5U})
    CHECK(bytes_of(rbpa::partial(region, given(region, many, 0.7), 0.7, {.threads = threads})) == expected);
}

TEST_CASE("polygons taken at any time are complete, with the same counts") {
  Random random(4);
  std::size_t early = 0;
  for (int run = 0; run < trials(200); ++run) {
    const Points points = points_of(random_picture(12, 12, random.between(0.3, 0.7), random));
    std::vector<Partial> parts = partials(halving_cut(points, 8, random), points, picture_alpha);
    std::vector<rbpa::CornerPolygon> taken;
    Partial all;
    for (Partial& part : parts) {
      all = rbpa::merge(std::move(part), std::move(all));
      if (!random.chance(0.7)) continue;
      const std::vector<rbpa::CornerPolygon> now = rbpa::take_settled(all);
      CHECK(std::is_sorted(now.begin(), now.end(), rbpa::comes_before));
      taken.insert(taken.end(), now.begin(), now.end());
      CHECK(rbpa::take_settled(all).empty());
    }
    early += taken.size();
    rbpa::WholeComplex found = rbpa::finish(std::move(all));
    taken.insert(taken.end(), found.polygons.begin(), found.polygons.end());
    std::sort(taken.begin(), taken.end(), rbpa::comes_before);
    found.polygons = taken;
    REQUIRE(difference(found, whole(points, picture_alpha)) == "");
  }
  CHECK(early > 200);
}

TEST_CASE("holes taken at any time belong to the polygons of their names") {
  Random random(5);
  std::size_t early = 0, late = 0;
  for (int run = 0; run < trials(300); ++run) {
    const Points points = points_of(random_picture(12, 12, random.between(0.6, 0.95), random));
    std::vector<Partial> parts = partials(any_cut(points, 12, random), points, picture_alpha);
    std::vector<rbpa::TakenHoles> taken;
    const auto take = [&](Partial& from) {
      const std::vector<rbpa::TakenHoles> now = rbpa::take_holes(from);
      for (const rbpa::TakenHoles& some : now)
        CHECK(std::is_sorted(some.holes.begin(), some.holes.end(),
                             [](const auto& a, const auto& b) { return a[0].at < b[0].at; }));
      taken.insert(taken.end(), now.begin(), now.end());
      CHECK(rbpa::take_holes(from).empty());
    };
    const auto take_many = [&](Partial& from) {
      constexpr std::size_t many = 7;
      const std::vector<rbpa::TakenHoles> now = rbpa::take_holes(from, many);
      for (const rbpa::TakenHoles& some : now) CHECK(corners_of(some) >= many);
      Partial copy = from;
      for (const rbpa::TakenHoles& some : rbpa::take_holes(copy)) CHECK(corners_of(some) < many);
      taken.insert(taken.end(), now.begin(), now.end());
    };
    while (parts.size() > 1) {
      Partial last = std::move(parts.back());
      parts.pop_back();
      Partial& with = parts[random.below(parts.size())];
      if (random.chance(0.3)) take_many(last);
      if (random.chance(0.5)) take(last);
      with = rbpa::merge(std::move(with), std::move(last));
      if (random.chance(0.5)) take(with);
      if (random.chance(0.3)) with = rbpa::partial_from_bytes(rbpa::to_bytes(with));
    }
    rbpa::WholeComplex found = rbpa::finish(std::move(parts[0]));
    for (rbpa::CornerPolygon& polygon : found.polygons) {
      const std::size_t had = polygon.holes.size();
      for (const rbpa::TakenHoles& some : taken)
        if (std::binary_search(polygon.names.begin(), polygon.names.end(), some.component))
          polygon.holes.insert(polygon.holes.end(), some.holes.begin(), some.holes.end());
      std::sort(polygon.holes.begin(), polygon.holes.end(),
                [](const auto& a, const auto& b) { return std::pair(a[0].at, a[1].at) < std::pair(b[0].at, b[1].at); });
      REQUIRE(polygon.holes.size() == had + polygon.taken_holes);
      late += had;
      early += polygon.taken_holes;
    }
    REQUIRE(difference(found, whole(points, picture_alpha)) == "");
  }
  CHECK(early > trials(300));
  CHECK(late > 100);
}

TEST_CASE("finished parts are released: a long row of islands has a small rim") {
  Points points;
  for (int i = 0; i < 1000; ++i)
    for (const double y : {0.0, 1.0, 2.0})
      for (const double x : {0.0, 1.0}) points.push_back({4.0 * i + x, y});
  Partial all;
  std::size_t taken = 0;
  for (int i = -1; i < 250; ++i) {
    const Region region{i < 0 ? -infinity : 16.5 * i, -infinity, i == 249 ? infinity : 16.5 * (i + 1), infinity};
    all = rbpa::merge(std::move(all), rbpa::partial(region, given(region, points, 0.8), 0.8));
    taken += rbpa::take_settled(all).size();
    REQUIRE(rbpa::to_bytes(all).size() < 2000);
  }
  CHECK(taken == 1000);
  CHECK(rbpa::finish(std::move(all)).polygons.empty());
}

TEST_CASE("a polygon is finished when an open component that it touches certainly comes first") {
  // A block of squares, and one square that touches it in (14, 14).
  Points points{{16, 14}, {14, 16}, {16, 16}, {15, 15}};
  for (int x = 0; x <= 14; ++x)
    for (int y = 0; y <= 14; ++y)
      if (x % 2 == y % 2) points.push_back({double(x), double(y)});
  const auto part = [&](const Region& region) { return rbpa::partial(region, given(region, points, 1), 1); };
  const auto check = [](Partial& partial) {
    const std::vector<rbpa::CornerPolygon> settled = rbpa::take_settled(partial);
    REQUIRE(settled.size() == 1);
    CHECK(settled[0].area == 4);
    CHECK(settled[0].points == 4);
  };
  // Finished by a chain.
  Partial above = part({-infinity, 8, infinity, infinity});
  CHECK(above.rim().components == 1);
  check(above);
  // Finished by a ring: only the middle of the block is missing.
  Partial around;
  for (const double x : {-infinity, 6.5, 7.5})
    for (const double y : {-infinity, 6.5, 7.5}) {
      const auto end = [](double from) { return from == 6.5 ? 7.5 : from < 0 ? 6.5 : infinity; };
      if (x != 6.5 || y != 6.5) around = rbpa::merge(std::move(around), part({x, y, end(x), end(y)}));
    }
  CHECK(around.rim().chains == 0);
  CHECK(around.rim().components == 1);
  check(around);
}

TEST_CASE("a partial of no region is neutral for merge()") {
  const Points points = uniform(100, 1);
  const Partial some = rbpa::partial(halves[0], given(halves[0], points, 2), 2);
  CHECK(bytes_of(rbpa::merge(Partial(), Partial(some))) == bytes_of(some));
  CHECK(bytes_of(rbpa::merge(Partial(some), Partial())) == bytes_of(some));
  const Region empty{3, 0, 3, 9};
  CHECK(bytes_of(rbpa::merge(Partial(some), rbpa::partial(empty, given(empty, points, 2), 2))) == bytes_of(some));
  const auto from = [&](double x) {
    const Region region{x, 2, 7, 9};
    return bytes_of(rbpa::partial(region, given(region, points, 2), 2));
  };
  CHECK(from(-0.0) == from(0.0));
  CHECK(Partial().alpha() == 0);
  CHECK(!Partial().is_whole());
}

TEST_CASE("an infinite radius is refused with the reason, and so is other invalid input") {
  const Points points = uniform(50, 1);
  const Given all = given(Region{}, points, 1);
  CHECK(says(refusal([&] { rbpa::partial({}, all, infinity); }), "no halo around a region is enough"));
  CHECK(says(refusal([&] { rbpa::halo({}, infinity); }), "no halo"));
  CHECK(rbpa::halo({infinity, 0, infinity, 1}, 1e308) == Region{});
  for (const double alpha : {0.0, -1.0, std::nan(""), -infinity})
    CHECK(says(refusal([&] { rbpa::partial({}, all, alpha); }), "expected a finite radius above 0"));
  CHECK(says(refusal([&] { rbpa::partial({2, 0, 1, 1}, all, 1); }), "x from 2 to 1"));
  CHECK(says(refusal([&] { rbpa::partial({0, std::nan(""), 1, 1}, all, 1); }), "ascending"));
  Given wrong = all;
  wrong.indices[7] = wrong.indices[30];
  CHECK(says(refusal([&] { rbpa::partial({}, wrong, 1); }), "index 30 is given twice"));
  wrong.indices.pop_back();
  CHECK(says(refusal([&] { rbpa::partial({}, wrong, 1); }), "50 points with 49 indices"));
  wrong = all;
  wrong.indices[3] = 5'000'000'000;
  wrong.points[3].y = infinity;
  CHECK(says(refusal([&] { rbpa::partial({}, wrong, 1); }), "point 5000000000 is ("));
}

TEST_CASE("different radii and overlapping regions are not merged") {
  const Points points = uniform(400, 1);
  const auto part = [&](const Region& region, double alpha) {
    return rbpa::partial(region, given(region, points, alpha), alpha);
  };
  CHECK(says(refusal([&] { rbpa::merge(part(halves[0], 1), part(halves[1], 2)); }),
             "merge: found parts of alpha 1 and of alpha 2, expected one alpha"));
  CHECK(says(refusal([&] { rbpa::merge(part(halves[0], 1), part(halves[0], 1)); }), "both sets of regions contain"));
  CHECK(says(refusal([&] {
               rbpa::merge(part({0, 0, 6, 9}, 1), part({5, 8, 7, 12}, 1));
             }),
             "the area with the lower left corner (5, 8), expected disjoint regions"));
}

TEST_CASE("a refusal names the missing region") {
  const Points points = uniform(400, 1);
  const auto part = [&](const Region& region) { return rbpa::partial(region, given(region, points, 1), 1); };
  CHECK(says(refusal([&] { rbpa::finish(part(halves[0])); }),
             "none contains the area with the lower left corner (10, -inf)"));
  CHECK(
      says(refusal([] { rbpa::finish(Partial()); }), "none contains the area with the lower left corner (-inf, -inf)"));
  CHECK(refusal([&] { rbpa::finish(rbpa::merge(part(halves[0]), part(halves[1]))); }).empty());
}

TEST_CASE("incomplete halos are found where they matter") {
  const Points points = uniform(400, 1);
  // The second half has only its own points.
  const auto both = [&] {
    return rbpa::merge(rbpa::partial(halves[0], given(halves[0], points, 1), 1),
                       rbpa::partial(halves[1], given(halves[1], points, 0x1p-60), 1));
  };
  CHECK(says(refusal([&] { rbpa::finish(both()); }), "halos were not complete"));
}

TEST_CASE("a run can be cancelled") {
  const Points points = uniform(30'000, 1);
  const Given all = given(Region{}, points, 0.7);
  int calls = 0;
  rbpa::partial({}, all, 0.7, {.threads = 1, .progress = [&](const auto&) { return ++calls > 0; }});
  REQUIRE(calls > 5);
  for (const int last : {1, calls / 2, calls - 1, calls}) {
    int so_far = 0;
    CHECK_THROWS_AS(
        rbpa::partial({}, all, 0.7, {.threads = 1, .progress = [&](const auto&) { return ++so_far < last; }}),
        rbpa::Cancelled);
    CHECK(so_far == last);
  }
}

TEST_SUITE_END();
