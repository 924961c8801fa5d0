#include "rbpa/plane/predicate/window.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "support/arguments.h"
#include "support/exact.h"
#include "support/generate.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::Radius;
using rbpa::Window;
using rbpa::window_of;

TEST_SUITE_BEGIN("predicates");

namespace {

Points scaled_inside(const Points& points, const Window& window) {
  Points inside;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (!std::binary_search(window.beyond.begin(), window.beyond.end(), i))
      inside.push_back({std::ldexp(points[i].x, window.exponent), std::ldexp(points[i].y, window.exponent)});
  return inside;
}

/// Checks that scaling loses nothing, and that points inside fit.
void check_window(const Points& points) {
  const Window window = window_of(points);
  CHECK(std::is_sorted(window.beyond.begin(), window.beyond.end()));
  const Points inside = scaled_inside(points, window);
  CHECK(inside.size() + window.beyond.size() == points.size());
  CHECK(rbpa::fits_double(rbpa::magnitude(inside)));
  std::size_t i = 0;
  for (std::uint32_t k = 0; k < points.size(); ++k) {
    if (std::binary_search(window.beyond.begin(), window.beyond.end(), k)) continue;
    CHECK(std::ldexp(inside[i].x, -window.exponent) == points[k].x);
    CHECK(std::ldexp(inside[i].y, -window.exponent) == points[k].y);
    ++i;
  }
}

}  // namespace

TEST_CASE("ordinary points are not scaled") {
  for (const Points& points : {uniform(100, 1), moved(uniform(50, 2), 1e6, -1e6), Points{}, Points{{0, 0}}}) {
    const Window window = window_of(points);
    CHECK(window.exponent == 0);
    CHECK(window.beyond.empty());
  }
}

TEST_CASE("a set far from 1 is scaled, and none of it lies beyond") {
  for (const int exponent : {-1000, -600, -300, -200, 200, 300, 600, 900})
    for (const Points& points : {uniform(200, 3), perfect_grid(12, 1), clusters(8, 4)}) {
      CAPTURE(exponent);
      const Points far = scaled(points, exponent);
      const Window window = window_of(far);
      CHECK(window.exponent != 0);
      CHECK(window.beyond.empty());
      check_window(far);
    }
  check_window(denormals(20, 100, 5));
}

TEST_CASE("the window of a set that is too wide has most of the points, and the few others lie beyond") {
  Points points = uniform(100, 6);
  points.push_back({1e200, 0});
  points.push_back({0.5, 1e-200});
  points.push_back({0, 0});
  const Window window = window_of(points);
  CHECK(window.beyond == std::vector<std::uint32_t>{100, 101});
  check_window(points);
  // All points are beyond where no window has half of them: a window would not help.
  const Points wide = mixed_exponents(40, 7);
  CHECK(window_of(wide).beyond.size() == wide.size());
  check_window(wide);
  check_window(corners_of_range());
  check_window(far_and_tiny(30, 8));
}

TEST_CASE("the window is a function of the set") {
  Random random(9);
  Points points = uniform(60, 10);
  for (int i = 0; i < 20; ++i) points.push_back({std::ldexp(random.unit(), random.integer(-900, 900)), random.unit()});
  const Window window = window_of(points);
  Points beyond;
  for (const std::uint32_t i : window.beyond) beyond.push_back(points[i]);
  std::sort(beyond.begin(), beyond.end());
  for (int turn = 0; turn < 10; ++turn) {
    random.shuffle(points);
    const Window other = window_of(points);
    CHECK(other.exponent == window.exponent);
    Points those;
    for (const std::uint32_t i : other.beyond) those.push_back(points[i]);
    std::sort(those.begin(), those.end());
    CHECK(those == beyond);
  }
}

TEST_CASE("a scaled radius admits the triangles that alpha admits for the given points") {
  Random random(11);
  for (const int exponent : {-1020, -700, -300, 0, 300, 700, 1000}) {
    CAPTURE(exponent);
    const Points points = scaled(random_grid(9, 40, false, 12), exponent);
    const Window window = window_of(points);
    const Points inside = scaled_inside(points, window);
    for (int trial = 0; trial < trials(300); ++trial) {
      const std::size_t a = random.below(inside.size()), b = random.below(inside.size()),
                        c = random.below(inside.size());
      if (exact::orientation(points[a], points[b], points[c]) == 0) continue;
      // Radii of right triangles are met exactly; other radii are far below or above all.
      const double r = std::ldexp(0.25 * static_cast<double>(1 + random.below(24)), exponent);
      for (const double alpha :
           {r, std::nextafter(r, 0.0), 5e-324, std::numeric_limits<double>::max(), std::ldexp(1.0, exponent - 40)}) {
        if (!(alpha > 0) || std::isinf(alpha)) continue;
        const Radius radius = window.scaled(Radius(alpha));
        CHECK(radius.admits<double>(inside[a], inside[b], inside[c]) ==
              (exact::compare_circumradius(points[a], points[b], points[c], alpha) <= 0));
      }
    }
    CHECK(window.scaled(Radius()).is_infinite());
  }
}

TEST_SUITE_END();
