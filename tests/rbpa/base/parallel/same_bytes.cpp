// The number of threads changes no byte of a result.
#include <doctest/doctest.h>

#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/hrbpa.h"
#include "rbpa/rbpa.h"
#include "support/generate.h"
#include "support/infinity.h"
#include "support/sets.h"

using namespace rbpa_test;
using rbpa::SolidAlphaComplex;

TEST_SUITE_BEGIN("parallel");

namespace {

/// Returns all numbers of a complex, in a fixed order.
std::vector<double> numbers(const SolidAlphaComplex& complex) {
  std::vector<double> all = {double(complex.distinct), double(complex.isolated.size())};
  const auto& mesh = complex.mesh;
  for (const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    all.insert(all.end(), {double(mesh.halfedge_handle(v).idx()), p[0], p[1], p[2]});
  }
  for (const auto h : mesh.halfedges())
    all.insert(all.end(), {double(mesh.to_vertex_handle(h).idx()), double(mesh.next_halfedge_handle(h).idx()),
                           double(mesh.prev_halfedge_handle(h).idx()), double(mesh.face_handle(h).idx())});
  for (const auto f : mesh.faces()) all.push_back(mesh.halfedge_handle(f).idx());
  all.insert(all.end(), complex.input_index.begin(), complex.input_index.end());
  all.insert(all.end(), complex.isolated.begin(), complex.isolated.end());
  for (const auto& d : complex.duplicates) all.insert(all.end(), {double(d.index), double(d.stands_for)});
  return all;
}

std::vector<double> numbers_by_levels(const Points& points, double alpha, std::size_t leaf_capacity, unsigned threads) {
  return numbers(rbpa::hrbpa(points, alpha, {.leaf_capacity = leaf_capacity, .threads = threads}).complex);
}

/// Checks with leaves so small that triangles of all tiles wait for their level.
void check_threads(const Points& points, double alpha, std::size_t leaf_capacity) {
  CAPTURE(alpha);
  const auto expected = numbers(rbpa::rbpa(points, alpha, {.threads = 1}));
  const auto by_levels = numbers_by_levels(points, alpha, leaf_capacity, 1);
  for (const unsigned threads : {0u, 2u, 5u}) {
    CAPTURE(threads);
    CHECK(numbers(rbpa::rbpa(points, alpha, {.threads = threads})) == expected);
    CHECK(numbers_by_levels(points, alpha, leaf_capacity, threads) == by_levels);
  }
}

}  // namespace

TEST_CASE("threads change no byte of the result on sets of every kind") {
  for (const NamedSet& set : generated_sets()) {
    CAPTURE(set.name);
    const Points points = set.make();
    check_threads(points, infinity, 16);
    for (const double alpha : set.alphas) check_threads(points, alpha, 16);
  }
}

TEST_CASE("threads change no byte of many tiles, with equal points") {
  Points points = uniform(60'000, 1);
  const Points crowds = clusters(4'000, 2), again = points;
  points.insert(points.end(), crowds.begin(), crowds.end());
  points.insert(points.end(), again.begin(), again.begin() + 5'000);
  for (const double alpha : {0.7, infinity}) check_threads(points, alpha, 256);
}

TEST_CASE("threads change no byte where tiles decide little") {
  for (const Points& points : {rounded_concentric(40'000), along_curves(15'000)})
    for (const double alpha : {0.07, infinity}) check_threads(points, alpha, 256);
}

TEST_CASE("a run with any number of threads can be cancelled, in the tiles and in the remainder") {
  for (const Points& points : {uniform(50'000, 3), rounded_concentric(30'000)}) {
    int all = 0;
    rbpa::rbpa(points, infinity, {.threads = 1, .progress = [&](const auto&) { return ++all > 0; }});
    REQUIRE(all > 10);
    for (const int last : {3, all - 3})
      for (const unsigned threads : {0u, 1u, 2u, 5u}) {
        int calls = 0;
        const auto progress = [&](const auto&) { return ++calls < last; };
        CHECK_THROWS_AS(rbpa::rbpa(points, infinity, {.threads = threads, .progress = progress}), rbpa::Cancelled);
        CHECK(calls == last);
      }
  }
}

TEST_SUITE_END();
