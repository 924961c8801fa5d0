#include "rbpa/plane/smallest_covering_alpha.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "meshops/core/contract.h"
#include "plane/filtration/small_sets.h"
#include "plane/filtration/solid_sizes.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/filtration/part_sizes.h"
#include "rbpa/rbpa.h"
#include "support/delaunay_arrays.h"
#include "support/generate.h"
#include "support/infinity.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::Covering;
using rbpa::Filtration;

TEST_SUITE_BEGIN("filtration");

namespace {

std::optional<double> covering_of(const Points& points, const Covering& covering) {
  const auto delaunay = delaunay_arrays(points);
  return rbpa::smallest_covering(delaunay, rbpa::filtration(delaunay, points), covering);
}

/// Returns the number of points that the `most` largest components of the complex at alpha, built anew, cover.
std::size_t left_over(const Points& points, double alpha, std::optional<std::size_t> most) {
  const auto complex = rbpa::rbpa(points, alpha);
  const std::size_t covered = complex.distinct - complex.isolated.size();
  if (!most) return covered;
  const std::vector<std::size_t> sizes = solid_sizes(complex.mesh);
  const std::size_t gone = std::accumulate(sizes.begin() + static_cast<std::ptrdiff_t>(std::min(*most, sizes.size())),
                                           sizes.end(), std::size_t{0});
  return gone < covered ? covered - gone : 0;
}

constexpr double shares[] = {1e-9, 0.1, 0.5, 0.75, 0.9, 0.99, 1};

}  // namespace

TEST_CASE("smallest_covering of a share is the least alpha at which the complex built anew covers it") {
  std::size_t below_all = 0, one_less_helps = 0;
  on_small_sets([&](const Points& points) {
    const auto delaunay = delaunay_arrays(points);
    const Filtration all = rbpa::filtration(delaunay, points);
    for (const std::optional<std::size_t> most : std::initializer_list<std::optional<std::size_t>>{{}, 0, 1, 2, 5}) {
      CAPTURE(most.value_or(99));
      std::vector<std::size_t> left;
      for (const auto& step : all.steps) left.push_back(left_over(points, step.alpha, most));
      for (const double share : shares) {
        CAPTURE(share);
        std::optional<double> expected;
        for (std::size_t i = 0; i < left.size() && !expected; ++i)
          if (rbpa::is_share(left[i], all.distinct, share)) expected = all.steps[i].alpha;
        const auto found = rbpa::smallest_covering(delaunay, all, {share, most});
        CHECK(found == expected);
        CHECK(rbpa::smallest_covering(rbpa::Delaunay(points), {share, most}) == expected);
        if (share == 1) CHECK(found == rbpa::smallest_covering(all, most));
        below_all += found && *found < rbpa::smallest_covering(all, most);
        one_less_helps += most && found && share < 1 && *found < rbpa::smallest_covering(all, most);
      }
    }
  });
  CHECK(below_all > 300);
  CHECK(one_less_helps > 200);
}

TEST_CASE("a share in decimals is met exactly") {
  for (std::size_t all = 1; all <= 1000; all = all * 10)
    for (std::size_t count = 1; count <= all; ++count) {
      const double share = std::stod(std::to_string(count) + "e-" + std::to_string(std::to_string(all).size() - 1));
      CHECK(rbpa::is_share(count, all, share));
      CHECK_FALSE(rbpa::is_share(count - 1, all, share));
      CHECK_FALSE(rbpa::is_share(count, all, std::nextafter(share, 2)));
    }
}

TEST_CASE("outliers and dust below the share do not change the alpha of the other points") {
  const Points points = uniform(400, 31);
  const std::optional<double> alone = covering_of(points, {0.98, 1});
  const std::optional<double> every_point = covering_of(points, {1, 1});
  for (const double far : {100.0, 1e6, 1e12}) {
    CAPTURE(far);
    Points more = points;
    for (const rbpa::Point& p : Points{{far, 0}, {far + 0.1, 0}, {far, 0.1}}) more.push_back(p);
    const auto found = covering_of(more, {0.98, 1});
    REQUIRE(found);
    // The three new points make a triangle of their own at a small alpha; no other component needs to reach them.
    CHECK(*found >= *alone);
    CHECK(*found < 2 * *every_point);
    CHECK(*covering_of(more, {1, 1}) > 20);
    CHECK(*covering_of(more, {1, 2}) <= *every_point);
  }
}

TEST_CASE("a greater share and fewer components need a greater alpha") {
  for (const Points& points :
       {uniform(300, 32), clusters(20, 33), tiny_components(40, 34), random_grid(20, 150, true, 35)}) {
    const auto delaunay = delaunay_arrays(points);
    const Filtration all = rbpa::filtration(delaunay, points);
    double before = 0;
    for (const double share : shares) {
      double fewer = infinity;
      for (std::size_t most = 1; most <= 8; ++most) {
        const double found = rbpa::smallest_covering(delaunay, all, {share, most}).value();
        CHECK(found <= fewer);
        fewer = found;
      }
      const double found = rbpa::smallest_covering(delaunay, all, {share, 1}).value();
      CHECK(found >= before);
      CHECK(found >= rbpa::smallest_covering(delaunay, all, {share, std::nullopt}).value());
      before = found;
    }
  }
}

TEST_CASE("order, duplicates and scaling by a power of two change a share's alpha only by its unit") {
  Random random(36);
  on_small_sets([&](const Points& points) {
    Points shuffled = points;
    if (!shuffled.empty()) shuffled.push_back(shuffled.front());
    random.shuffle(shuffled);
    for (const double share : {0.5, 0.9})
      for (const std::optional<std::size_t> most : {std::optional<std::size_t>{}, std::optional<std::size_t>{1}})
        CHECK(covering_of(points, {share, most}) == covering_of(shuffled, {share, most}));
  });
  const Points points = uniform(60, 37);
  for (const int exponent : {-900, 3, 900})
    CHECK(covering_of(scaled(points, exponent), {0.8, 2}) ==
          std::ldexp(covering_of(points, {0.8, 2}).value(), exponent));
}

TEST_CASE("an invalid share, and a filtration of other points, are refused") {
  const Points points = uniform(30, 38);
  const auto delaunay = delaunay_arrays(points);
  const Filtration all = rbpa::filtration(delaunay, points);
  for (const double share : {0.0, -1.0, 1.5, std::nan("")})
    CHECK_THROWS_AS(rbpa::smallest_covering(delaunay, all, {share, 1}), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::smallest_covering(rbpa::Delaunay(points), {.share = 1.5}), meshops::ContractViolation);
  const Points others = uniform(31, 38);
  CHECK_THROWS_AS(rbpa::smallest_covering(delaunay_arrays(others), all, Covering{}), meshops::ContractViolation);
}

TEST_CASE("false from go_on cancels a search for a share, in every phase") {
  const Points points = random_grid(200, 20000, false, 39);
  const auto delaunay = delaunay_arrays(points);
  const Filtration all = rbpa::filtration(delaunay, points);
  std::size_t calls = 0;
  const auto whole = rbpa::smallest_covering(delaunay, all, {0.99, 1}, [&] { return ++calls > 0; });
  CHECK(whole == rbpa::smallest_covering(delaunay, all, {0.99, 1}));
  REQUIRE(calls > 3);
  for (std::size_t last = 1; last <= calls; ++last) {
    std::size_t call = 0;
    CHECK_THROWS_AS(rbpa::smallest_covering(delaunay, all, {0.99, 1}, [&] { return ++call < last; }), rbpa::Cancelled);
  }
  for (const double share : {0.99, 1.0}) {
    std::size_t call = 0;
    CHECK_THROWS_AS(rbpa::smallest_covering(rbpa::Delaunay(delaunay, points), {share, 1}, [&] { return ++call < 3; }),
                    rbpa::Cancelled);
  }
}

TEST_CASE("the largest parts hold as many points as a sorted list shows") {
  Random random(40);
  rbpa::PartSizes sizes(50);
  std::vector<std::uint32_t> list;
  for (int i = 0; i < 600; ++i) {
    if (!list.empty() && random.below(3) == 0) {
      sizes.remove(list.back());
      list.pop_back();
    } else {
      list.push_back(1 + static_cast<std::uint32_t>(random.below(50)));
      sizes.add(list.back());
    }
    std::vector<std::uint32_t> sorted = list;
    std::sort(sorted.begin(), sorted.end(), std::greater());
    std::size_t sum = 0;
    for (std::size_t k = 0; k <= sorted.size() + 1; ++k) {
      REQUIRE(sizes.largest(k) == sum);
      if (k < sorted.size()) sum += sorted[k];
    }
    REQUIRE(sizes.sum() == sum);
  }
}

TEST_SUITE_END();
