#include "rbpa/plane/tile/circumradius_filter.h"

#include <doctest/doctest.h>
#include <hwy/targets.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "rbpa/plane/predicate/predicates.h"
#include "support/one_target.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::CircumradiusFilter;
using rbpa::LocalFront;
using rbpa::Point;
using rbpa::Tile;
using rbpa::TileCoordinates;

TEST_SUITE_BEGIN("tile");

namespace {

using P = rbpa::Predicates<double>;
using Corners = std::array<std::size_t, 3>;

struct Sample {
  Tile tile;
  std::vector<Corners> triangles;
};

/// Returns triangles in the square of side `size` at (corner, corner). Each corner of a triangle is at most reach *
/// size from a random center, in x and in y. Coordinates are multiples of `pitch` unless it is 0.
Sample sample(Random& random, std::size_t points, double corner, double size, double reach, double pitch) {
  Sample made;
  made.tile.columns = made.tile.rows = 4;
  made.tile.cell = size / 4;
  made.tile.x0 = made.tile.y0 = corner;
  made.tile.start.assign(17, 0);
  const auto place = [&](double share) {
    const double at = corner + size * share;
    return pitch == 0 ? at : std::round(at / pitch) * pitch;
  };
  while (made.tile.points.size() + 3 <= points) {
    const double x = random.between(reach, 1 - reach), y = random.between(reach, 1 - reach);
    Corners corners;
    for (std::size_t& c : corners) {
      c = made.tile.points.size();
      made.tile.points.push_back({place(x + random.between(-reach, reach)), place(y + random.between(-reach, reach))});
    }
    const Point &a = made.tile.points[corners[0]], &b = made.tile.points[corners[1]], &c = made.tile.points[corners[2]];
    if (P::orientation(a, b, c) != 0) made.triangles.push_back(corners);
  }
  return made;
}

double circumradius(const Tile& tile, const Corners& t) {
  const Point &a = tile.points[t[0]], &b = tile.points[t[1]], &c = tile.points[t[2]];
  const double ab = std::hypot(b.x - a.x, b.y - a.y), bc = std::hypot(c.x - b.x, c.y - b.y),
               ca = std::hypot(a.x - c.x, a.y - c.y);
  return ab * bc * ca / (2 * std::abs(P::cross(P::from(a, b), P::from(a, c))));
}

struct Counts {
  std::size_t inside = 0, outside = 0, uncertain = 0;
};

/// Checks the filter's result for all triangles. The front and the coordinates are reused, as from tile to tile.
class Checked {
 public:
  Counts operator()(const Sample& sample, double alpha) {
    at_.assign(sample.tile);
    front_.begin(sample.tile.points.size());
    for (const Corners& t : sample.triangles)
      front_.create(static_cast<LocalFront::Index>(t[0]), static_cast<LocalFront::Index>(t[1]),
                    static_cast<LocalFront::Index>(t[2]), [](LocalFront::Index, bool) {});
    filter_circumradii(at_, front_, alpha, filtered_);
    Counts counts;
    for (std::size_t i = 0; i < sample.triangles.size(); ++i) {
      const Corners& t = sample.triangles[i];
      const CircumradiusFilter decided = filtered_[i + 1];
      (decided == CircumradiusFilter::inside    ? counts.inside
       : decided == CircumradiusFilter::outside ? counts.outside
                                                : counts.uncertain) += 1;
      if (decided == CircumradiusFilter::uncertain) continue;
      const bool is_within = P::compare_circumradius(sample.tile.points[t[0]], sample.tile.points[t[1]],
                                                     sample.tile.points[t[2]], alpha) <= 0;
      if ((decided == CircumradiusFilter::inside) == is_within) continue;
      CAPTURE(circumradius(sample.tile, t));
      CAPTURE(alpha);
      FAIL_CHECK("triangle " << i << " is said to be within alpha: " << (decided == CircumradiusFilter::inside));
    }
    return counts;
  }

 private:
  TileCoordinates at_;
  LocalFront front_;
  std::vector<CircumradiusFilter> filtered_;
};

}  // namespace

TEST_CASE("radius decisions in single precision are true, on every kind of vector unit") {
  struct Kind {
    double corner, size, reach, pitch;
  };
  const std::vector<Kind> kinds = {{0, 1, 0.02, 0},          {-3, 7, 0.4, 0},    {5e5, 300, 0.02, 0.01},
                                   {0, 4096, 0.01, 1},       {0, 1, 1e-5, 0},    {0.3, 1, 3e-8, 0},
                                   {1e-40, 1e-40, 0.02, 0},  {0, 1e40, 0.02, 0}, {0, 0x1p20, 0.001, 0x1p-10},
                                   {1e9, 1e3, 0.02, 0x1p-20}};
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    const OneTarget only(target);
    CAPTURE(hwy::TargetName(target));
    Random random(1);
    Checked check;
    for (const Kind& kind : kinds) {
      CAPTURE(kind.size);
      CAPTURE(kind.reach);
      for (const std::size_t points : {3000u, 30u, 300u}) {
        const Sample made = sample(random, points, kind.corner, kind.size, kind.reach, kind.pitch);
        const double scale = kind.size * kind.reach;
        for (const double alpha : {1e-9, 1e-3, 0.3, 0.7, 1.0, 2.0, 30.0, 1e5, 1e12, 1e30}) check(made, alpha * scale);
        // Near the circumradius of one of them, where rounding matters most.
        for (std::size_t i = 0; i < 40 && i < made.triangles.size(); ++i) {
          const double radius = circumradius(made.tile, made.triangles[i]);
          if (!std::isfinite(radius) || radius == 0) continue;
          for (const double relative : {0.0, 1e-15, 1e-9, 1e-7, 1e-6, 1e-5, 1e-4})
            for (const double sign : {-1.0, 1.0}) check(made, radius * (1 + sign * relative));
        }
      }
    }
  }
}

TEST_CASE("few decisions are left to exact arithmetic") {
  Random random(2);
  Checked check;
  const Sample made = sample(random, 6000, 0, 1, 0.02, 0);
  for (const double alpha : {0.01, 0.02, 0.03}) {
    const Counts counts = check(made, alpha);
    CHECK(counts.inside > 100);
    CHECK(counts.outside > 100);
    CHECK(counts.uncertain < 10);
  }
  // No triangle is outside a radius beyond all distinguishable ones.
  CHECK(check(made, 1e12).outside == 0);
}

TEST_SUITE_END();
