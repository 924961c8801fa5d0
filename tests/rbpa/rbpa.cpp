#include "rbpa/rbpa.h"
#include "rbpa/paper.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "far_sets.h"
#include "rbpa/base/error.h"
#include "rbpa/base/exact/magnitude.h"
#include "support/check_ascending.h"
#include "support/generate.h"
#include "support/infinity.h"
#include "support/sets.h"
#include "support/spacing.h"
#include "support/text.h"
#include "support/triangle.h"

using namespace rbpa_test;
using rbpa::Duplicate;
using rbpa::InvalidInput;
using rbpa::Point;
using rbpa::SolidAlphaComplex;

TEST_SUITE_BEGIN("rbpa");

namespace {

const double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Returns the message of a refusal; "" when there is none.
std::string refusal(const Points& points, double alpha) {
  int calls = 0;
  try {
    rbpa::rbpa(points, alpha, {.progress = [&](const rbpa::Progress&) { return ++calls, true; }});
  } catch (const InvalidInput& e) {
    CHECK(calls == 0);
    return e.what();
  }
  return "";
}

std::vector<std::uint32_t> indices_up_to(std::uint32_t count) {
  std::vector<std::uint32_t> all(count);
  for (std::uint32_t i = 0; i < count; ++i) all[i] = i;
  return all;
}

/// Checks the laws of the result that hold for every input.
void check_bookkeeping(const Points& points, const SolidAlphaComplex& complex) {
  const std::vector<std::uint32_t> lowest = lowest_equal(points);
  std::vector<Duplicate> duplicates;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (lowest[i] != i) duplicates.push_back({i, lowest[i]});
  CHECK(complex.duplicates == duplicates);
  CHECK(complex.distinct == points.size() - duplicates.size());

  REQUIRE(complex.input_index.size() == complex.mesh.n_vertices());
  std::vector<bool> covered(points.size(), false);
  for (std::size_t v = 0; v < complex.input_index.size(); ++v) {
    const std::uint32_t i = complex.input_index[v];
    REQUIRE(i < points.size());
    CHECK(lowest[i] == i);
    covered[i] = true;
    const auto handle = OpenMesh::VertexHandle(static_cast<int>(v));
    CHECK_FALSE(complex.mesh.is_isolated(handle));
    const auto at = complex.mesh.point(handle);
    CHECK(at[0] == points[i].x);
    CHECK(at[1] == points[i].y);
    CHECK(at[2] == 0);
  }
  std::vector<std::uint32_t> isolated;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (lowest[i] == i && !covered[i]) isolated.push_back(i);
  CHECK(complex.isolated == isolated);
}

SolidAlphaComplex checked(const Points& points, double alpha) {
  SolidAlphaComplex complex = rbpa::rbpa(points, alpha);
  check_bookkeeping(points, complex);
  SolidAlphaComplex paper = rbpa::paper::rbpa(points, alpha);
  check_bookkeeping(points, paper);
  CHECK(rbpa::triangles(complex) == rbpa::triangles(paper));
  return complex;
}

}  // namespace

TEST_CASE("alpha must be above 0, and the refusal names it") {
  const Points points = {{0, 0}, {1, 0}, {0, 1}};
  for (const double alpha : {0.0, -0.0, -1.5, -infinity, not_a_number, -5e-324}) {
    CAPTURE(alpha);
    CHECK(contains(refusal(points, alpha), "alpha"));
    CHECK(contains(refusal({}, alpha), "alpha"));
  }
  CHECK(contains(refusal(points, -1.5), "-1.5"));
  CHECK(contains(refusal(points, not_a_number), "nan"));
  CHECK(contains(refusal(points, -infinity), "-inf"));
  CHECK(refusal(points, 5e-324) == "");
  CHECK(refusal(points, 1.7e308) == "");
  CHECK(refusal(points, infinity) == "");
}

TEST_CASE("points must be finite, and the refusal names the first that is not") {
  for (const double bad : {not_a_number, infinity, -infinity}) {
    CAPTURE(bad);
    const std::string in_x = refusal({{0, 0}, {1, 0}, {bad, 2.5}, {0, bad}}, 1);
    CHECK(contains(in_x, "point 2"));
    CHECK(contains(in_x, "2.5"));
    CHECK(contains(in_x, std::to_string(bad)));
    CHECK(contains(refusal({{7.25, bad}}, infinity), "point 0"));
    CHECK(contains(refusal({{7.25, bad}}, infinity), "7.25"));
  }
}

TEST_CASE("fewer than three points, or points on a line, have the empty complex") {
  const double steps[][2] = {{1, 0}, {0, 1}, {3, -7}, {0.5, 0.25}, {1e300, 1e300}, {5e-324, 0}};
  for (const double alpha : {1e-300, 1.0, 1e300, infinity}) {
    CAPTURE(alpha);
    CHECK(checked({}, alpha).distinct == 0);
    CHECK(checked({{1, 2}}, alpha).isolated == indices_up_to(1));
    CHECK(checked({{1, 2}, {3, 4}}, alpha).isolated == indices_up_to(2));
    CHECK(checked(Points(100, Point{0.1, 0.2}), alpha).duplicates.size() == 99);
    for (const auto& step : steps) {
      Points line;
      for (const int i : {4, 1, 5, 0, 3, 7, 2, 6}) line.push_back({i * step[0], i * step[1]});
      const SolidAlphaComplex complex = checked(line, alpha);
      CHECK(complex.mesh.n_faces() == 0);
      CHECK(complex.isolated == indices_up_to(8));
    }
  }
}

TEST_CASE("one triangle is in the complex from its circumradius on") {
  const Points right = {{0, 0}, {6, 0}, {0, 8}};
  CHECK(rbpa::triangles(checked(right, 5)) == std::vector<Triangle>{{0, 1, 2}});
  CHECK(checked(right, std::nextafter(5.0, 0.0)).isolated == indices_up_to(3));
  CHECK(rbpa::triangles(checked(right, std::nextafter(5.0, 6.0))).size() == 1);
}

TEST_CASE("equal points are one, represented by the lowest index, and -0 equals +0") {
  const Points points = {{0.0, 1}, {-0.0, 0.0}, {0.0, -0.0}, {1, -0.0}, {-0.0, 1}, {1, 0.0}, {-0.0, -0.0}};
  const SolidAlphaComplex complex = checked(points, infinity);
  CHECK(complex.distinct == 3);
  CHECK(rbpa::triangles(complex) == std::vector<Triangle>{{0, 1, 3}});
  CHECK(complex.duplicates == std::vector<Duplicate>{{2, 1}, {4, 0}, {5, 3}, {6, 1}});
}

TEST_CASE("indices, points, isolated points and duplicates are right on every kind of set") {
  for (const double alpha : {0.3, 0.5, 0.7, 1.0, 5.0, 1e4, infinity}) {
    CAPTURE(alpha);
    checked(uniform(300, 1), alpha);
    checked(duplicates(60, 5, 2), alpha);
    checked(random_grid(12, 200, true, 3), alpha);
    checked(clusters(30, 4), alpha);
    checked(tiny_components(30, 5), alpha);
    checked(chain_of_triangles(20), alpha);
    checked(far_and_tiny(10, 6), alpha);
    checked(mixed_exponents(10, 7), alpha);
  }
}

TEST_CASE("the front finds the same at extreme exponents, where there are no tiles") {
  for_each_far_set([&](std::string_view name, const Points& points, const Points& far) {
    const double spacing = mean_spacing(points);
    for (const double alpha : {0.6 * spacing, 3 * spacing, infinity}) {
      INFO(name, ", alpha ", alpha);
      const SolidAlphaComplex near = checked(points, alpha);
      CHECK(rbpa::triangles(near) == rbpa::triangles(checked(far, std::ldexp(alpha, far_exponent))));
    }
  });
}

TEST_CASE("triangles are the faces of the mesh, each from its smallest corner, sorted") {
  const auto by_definition = [](const SolidAlphaComplex& complex) {
    std::vector<Triangle> faces;
    for (const auto face : complex.mesh.faces()) {
      Triangle corners{};
      std::size_t count = 0;
      for (const auto v : face.vertices()) corners[count++] = complex.input_index[static_cast<std::size_t>(v.idx())];
      faces.push_back(corners);
    }
    return canonical(faces);
  };
  Points wheel = integer_circle(1105);
  wheel.insert(wheel.begin(), Point{0, 0});  // the smallest corner of every triangle
  for (const double alpha : {0.5, 1.0, infinity})
    for (const Points& points : {uniform(300, 1), duplicates(60, 5, 2), random_grid(12, 200, true, 3), wheel}) {
      const SolidAlphaComplex complex = rbpa::rbpa(points, alpha);
      CHECK(rbpa::triangles(complex) == by_definition(complex));
    }
  CHECK(rbpa::triangles({}).empty());
}

TEST_CASE("progress is called with ascending numbers, and true changes nothing") {
  const Points points = jittered_grid(120, 0.8, 1);
  std::vector<rbpa::Progress> seen;
  const auto watched = rbpa::rbpa(points, infinity, {.progress = [&](const rbpa::Progress& p) {
                                    seen.push_back(p);
                                    return true;
                                  }});
  check_ascending(seen, points.size(), watched.mesh.n_faces());
  CHECK(rbpa::triangles(watched) == rbpa::triangles(rbpa::rbpa(points, infinity)));
}

TEST_CASE("a progress callback that returns false cancels at once") {
  const Points points = jittered_grid(120, 0.8, 1);
  for (const int last : {1, 2}) {
    int calls = 0;
    CHECK_THROWS_AS(rbpa::rbpa(points, 2, {.progress = [&](const rbpa::Progress&) { return ++calls < last; }}),
                    rbpa::Cancelled);
    CHECK(calls == last);
  }
}

TEST_CASE("progress is called as often where a triangle takes long") {
  using Compute = SolidAlphaComplex (*)(std::span<const rbpa::Point>, double, const rbpa::Options&);
  const auto calls = [](const Points& points, double alpha, Compute compute) {
    int called = 0;
    compute(points, alpha, {.threads = 1, .progress = [&](const rbpa::Progress&) {
                              ++called;
                              return true;
                            }});
    return called;
  };
  // In release builds both report progress every millisecond: the first run takes 0.8 seconds, the second 0.18. Here: a
  // ball that reaches most points, in cells as large.
  CHECK(calls(jittered_grid(70, 0.8, 1), 20, rbpa::paper::rbpa) > 400);
  // Exponents beyond double, and a density that rises by 170 powers of ten.
  Points points;
  for (int i = 0; i < 200000; ++i) {
    const double scale = std::exp(-0.002 * i), angle = 2.4 * i;
    points.push_back({scale * std::cos(angle), scale * std::sin(angle)});
  }
  CHECK(calls(points, infinity, rbpa::rbpa) > 100);
}

TEST_CASE("an exception of a progress callback reaches the caller") {
  CHECK_THROWS_AS(rbpa::rbpa(jittered_grid(120, 0.8, 1), 2,
                             {.progress = [](const rbpa::Progress&) -> bool { throw std::string("stop"); }}),
                  std::string);
}

TEST_SUITE_END();
