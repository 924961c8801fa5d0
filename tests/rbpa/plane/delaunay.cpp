#include "rbpa/plane/delaunay.h"

#include <doctest/doctest.h>

#include <array>
#include <span>
#include <string>
#include <type_traits>

#include "meshops/core/contract.h"
#include "plane/filtration/small_sets.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/filtration.h"
#include "rbpa/plane/persistence.h"
#include "rbpa/plane/plateaus.h"
#include "rbpa/plane/smallest_covering_alpha.h"
#include "support/delaunay_arrays.h"
#include "support/generate.h"
#include "support/refusal_of.h"

using namespace rbpa_test;
using rbpa::AlphaComplex;
using rbpa::Delaunay;
using rbpa::Point;

TEST_SUITE_BEGIN("filtration");

// A span of a temporary would dangle.
static_assert(std::is_constructible_v<Delaunay, Points&> && std::is_constructible_v<Delaunay, std::span<Point>>);
static_assert(std::is_constructible_v<Delaunay, AlphaComplex, const Points&>);
static_assert(!std::is_constructible_v<Delaunay, Points> && !std::is_constructible_v<Delaunay, const Points>);
static_assert(!std::is_constructible_v<Delaunay, std::array<Point, 3>>);
static_assert(!std::is_constructible_v<Delaunay, const AlphaComplex&, Points>);
static_assert(!std::is_constructible_v<Delaunay, AlphaComplex, Points>);

namespace {

/// Returns the message that refuses `triangulation` as the Delaunay triangulation of `points`.
std::string refusal(const AlphaComplex& triangulation, std::span<const rbpa::Point> points) {
  return refusal_of<meshops::ContractViolation>(
      [&] { const Delaunay unexpected(triangulation, points, {}, "who asks"); });
}

}  // namespace

TEST_CASE("a computed and a checked triangulation are equal, and give equal results") {
  on_small_sets([&](const Points& points) {
    const AlphaComplex arrays = delaunay_arrays(points);
    const Delaunay computed(points), checked(arrays, points);
    CHECK(computed.triangulation().triangles == arrays.triangles);
    CHECK(computed.triangulation().neighbors == arrays.neighbors);
    CHECK(computed.triangulation().duplicates == arrays.duplicates);
    CHECK(computed.points().data() == points.data());
    const rbpa::Filtration all = rbpa::filtration(computed);
    CHECK(all.steps == rbpa::filtration(checked).steps);
    CHECK(all.steps == rbpa::filtration(arrays, points).steps);
    CHECK(rbpa::plateaus(computed, all) == rbpa::plateaus(arrays, points, all));
    for (const auto kind : {rbpa::ComplexKind::solid, rbpa::ComplexKind::full})
      CHECK(rbpa::persistence(computed, all, kind) == rbpa::persistence(arrays, points, all, kind));
    CHECK(rbpa::smallest_covering(computed, all, {0.8, 1}) == rbpa::smallest_covering(arrays, all, {0.8, 1}));
  });
}

TEST_CASE("a triangulation is referred to, a temporary is kept, and copies share it") {
  const Points points = uniform(30, 9);
  const AlphaComplex arrays = delaunay_arrays(points);
  CHECK(&Delaunay(arrays, points).triangulation() == &arrays);
  Delaunay copy(points);
  {
    const Delaunay kept(delaunay_arrays(points), points);
    copy = kept;
    CHECK(&copy.triangulation() == &kept.triangulation());
  }
  CHECK(copy.triangulation().triangles == arrays.triangles);
}

TEST_CASE("an obviously wrong triangulation of the points is refused, and the message names the function called") {
  const Points points = uniform(30, 9);
  const AlphaComplex arrays = delaunay_arrays(points);
  CHECK(refusal(arrays, points).empty());
  CHECK(refusal(arrays, std::span(points).first(29)) ==
        "who asks: the triangulation is of other points than those given");
  Points mirrored = points;
  for (rbpa::Point& p : mirrored) p.x = -p.x;
  CHECK(refusal(arrays, mirrored) == "who asks: the triangulation is of other points than those given");
  CHECK(refusal(rbpa::alpha_complex(points, 0.5, {.neighbors = true}), points) ==
        "who asks: the triangulation leaves points out, so it is not the Delaunay triangulation");
  AlphaComplex unlinked = arrays;
  std::swap(unlinked.neighbors[3][0], unlinked.neighbors[3][1]);
  CHECK(refusal(unlinked, points).starts_with("triangle "));
  CHECK_THROWS_AS(Delaunay(rbpa::AlphaComplex(unlinked), points), meshops::ContractViolation);
}

TEST_CASE("a triangulation is checked once") {
  const Points points = uniform(40000, 9);
  const AlphaComplex arrays = delaunay_arrays(points);
  std::size_t calls = 0;
  const auto calls_of = [&](const auto& work) {
    calls = 0;
    work([&] { return ++calls > 0; });
    return calls;
  };
  const std::size_t of_check = calls_of([&](const auto& go_on) { Delaunay(arrays, points, go_on); });
  CHECK(of_check > 2);
  const Delaunay delaunay(points);
  const std::size_t of_filtration = calls_of([&](const auto& go_on) { rbpa::filtration(delaunay, go_on); });
  CHECK(calls_of([&](const auto& go_on) { rbpa::filtration(arrays, points, go_on); }) == of_filtration + of_check);
}

TEST_CASE("triangulating and checking can be cancelled") {
  const Points points = uniform(40000, 9);
  CHECK_THROWS_AS(Delaunay(points, {.progress = [](const rbpa::Progress&) { return false; }}), rbpa::Cancelled);
  const AlphaComplex arrays = delaunay_arrays(points);
  for (std::size_t last = 1; last <= 4; ++last) {
    std::size_t calls = 0;
    CHECK_THROWS_AS(Delaunay(arrays, points, [&] { return ++calls < last; }), rbpa::Cancelled);
    CHECK(calls == last);
  }
}

TEST_SUITE_END();
