#include "rbpa/plane/plateaus.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "meshops/core/contract.h"
#include "plane/filtration/small_sets.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/filtration/shape_curve.h"
#include "rbpa/plane/topology.h"
#include "rbpa/rbpa.h"
#include "support/delaunay_arrays.h"
#include "support/generate.h"
#include "support/infinity.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::Filtration;
using rbpa::Plateau;
using rbpa::PlateauKind;

TEST_SUITE_BEGIN("filtration");

namespace {

struct Found {
  Filtration filtration;
  std::vector<rbpa::ShapeState> curve;
  std::vector<Plateau> plateaus;
};

Found find(const Points& points) {
  const rbpa::Delaunay delaunay(points);
  Found found{.filtration = rbpa::filtration(delaunay), .curve = {}, .plateaus = {}};
  const std::function<bool()> on;
  rbpa::Steps pulse(on);
  found.curve = rbpa::shape_curve(delaunay, found.filtration, pulse);
  found.plateaus = rbpa::plateaus(delaunay, found.filtration);
  return found;
}

std::vector<Plateau> plateaus_of(const Points& points) { return find(points).plateaus; }

/// The steps of a plateau: from `first` up to `last`, exclusive.
struct Steps {
  std::size_t first, last;
};

Steps steps_of(const Plateau& plateau, const Filtration& filtration) {
  const auto at = [&](double alpha) {
    const auto step = std::find_if(filtration.steps.begin(), filtration.steps.end(),
                                   [&](const rbpa::FiltrationStep& s) { return s.alpha == alpha; });
    return static_cast<std::size_t>(step - filtration.steps.begin());
  };
  return {at(plateau.from), plateau.to ? at(*plateau.to) : filtration.steps.size()};
}

double half_diagonal(const Points& points) {
  Points xs = points, ys = points;
  const auto [left, right] = std::minmax_element(xs.begin(), xs.end(), [](auto& p, auto& q) { return p.x < q.x; });
  const auto [low, high] = std::minmax_element(ys.begin(), ys.end(), [](auto& p, auto& q) { return p.y < q.y; });
  return std::hypot(right->x - left->x, high->y - low->y) / 2;
}

// Shapes by a given number of points in a given square or disc.

Points in_disc(std::size_t count, rbpa::Point middle, double inside, double radius, Random& random) {
  Points points;
  while (points.size() < count) {
    const double x = random.between(-radius, radius), y = random.between(-radius, radius);
    const double out = x * x + y * y;
    if (out <= radius * radius && out >= inside * inside) points.push_back({middle.x + x, middle.y + y});
  }
  return points;
}

Points both(Points a, const Points& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Points two_discs(Random& random) {
  return both(in_disc(500, {0, 0}, 0, 1, random), in_disc(500, {3, 0}, 0, 1, random));
}

/// Returns a ring with a mouth that closes long before its middle fills up.
Points closing_ring(Random& random) {
  Points points = in_disc(6000, {0, 0}, 3, 4, random);
  std::erase_if(points, [](const rbpa::Point& p) { return p.x > 0 && std::abs(p.y) < p.x / 2; });
  return points;
}

/// Returns a band bent so far that its bay is larger than the band.
Points bay(Random& random) {
  Points points = in_disc(5000, {0, 0}, 4, 5, random);
  std::erase_if(points, [](const rbpa::Point& p) { return p.x > -1; });
  return points;
}

/// Checks that the recommended shape has this many effective parts and this share of holes, and that alpha is between
/// spacing and gap.
void recommends(const Points& points, double parts, double hole_share, double at_least, double below) {
  const std::vector<Plateau> plateaus = plateaus_of(points);
  REQUIRE(!plateaus.empty());
  const Plateau& best = plateaus.front();
  CHECK(best.is_long);
  CHECK(best.effective_parts == doctest::Approx(parts).epsilon(0.02));
  CHECK(std::abs(best.hole_share - hole_share) < 0.06);
  CHECK(best.alpha > at_least);
  CHECK(best.alpha < below);
}

}  // namespace

TEST_CASE("within a plateau the change grows by at most a tenth, and the plateau ends where it would grow by more") {
  std::size_t ends = 0;
  on_small_sets([&](const Points& points) {
    const Found found = find(points);
    CHECK(found.plateaus.empty() == found.filtration.steps.empty());
    std::vector<bool> taken(found.curve.size());
    std::vector<Steps> all;
    for (const Plateau& plateau : found.plateaus) {
      const Steps steps = steps_of(plateau, found.filtration);
      REQUIRE(steps.first < steps.last);
      CHECK(2 * found.filtration.steps[steps.first].covered >= found.filtration.distinct);
      CHECK(found.curve[steps.last - 1].change <= 1.1L * found.curve[steps.first].change);
      for (std::size_t i = steps.first; i < steps.last; ++i) {
        CHECK_FALSE(taken[i]);
        taken[i] = true;
      }
      all.push_back(steps);
    }
    for (const Steps& steps : all) {
      if (steps.last == taken.size() || taken[steps.last]) continue;
      ++ends;
      CHECK(found.curve[steps.last].change > 1.1L * found.curve[steps.first].change);
    }
  });
  CHECK(ends > 20);
}

TEST_CASE("no range outside the plateaus is longer than the shortest of them, of all pairs of steps") {
  on_small_sets([&](const Points& points) {
    const Found found = find(points);
    const auto& steps = found.filtration.steps;
    const double reach = points.empty() ? 0 : half_diagonal(points);
    if (found.plateaus.empty() || std::isinf(reach)) return;
    const auto ratio = [&](std::size_t first, std::size_t last) {
      const double to = last == steps.size() ? reach : std::min(reach, steps[last].alpha);
      return std::max(1.0, to / steps[first].alpha);
    };
    double shortest = infinity;
    std::vector<bool> taken(steps.size());
    for (const Plateau& plateau : found.plateaus) {
      const Steps of = steps_of(plateau, found.filtration);
      CHECK(plateau.ratio == doctest::Approx(ratio(of.first, of.last)).epsilon(1e-14));
      shortest = std::min(shortest, plateau.ratio);
      std::fill(taken.begin() + static_cast<std::ptrdiff_t>(of.first),
                taken.begin() + static_cast<std::ptrdiff_t>(of.last), true);
    }
    const double bound = found.plateaus.size() == 8 ? shortest : 1.25;
    for (std::size_t first = 0; first < steps.size(); ++first) {
      if (2 * steps[first].covered < found.filtration.distinct) continue;
      for (std::size_t last = first + 1; last <= steps.size() && !taken[last - 1]; ++last)
        if (found.curve[last - 1].change <= 1.1L * found.curve[first].change)
          CHECK(ratio(first, last) <= bound * (1 + 1e-14));
    }
  });
}

TEST_CASE("alpha is in its plateau, near its beginning, and the counts are those of the complex there") {
  on_small_sets([&](const Points& points) {
    for (const Plateau& plateau : plateaus_of(points)) {
      CHECK(plateau.alpha >= plateau.from);
      CHECK((!plateau.to || plateau.alpha < *plateau.to));
      CHECK(plateau.alpha <= 2 * plateau.from);
      CHECK(plateau.ratio >= 1);
      const auto complex = rbpa::rbpa(points, plateau.alpha);
      const rbpa::ComplexCounts counts = rbpa::count(complex);
      CHECK(plateau.step.triangles == counts.triangles);
      CHECK(plateau.step.solid_components == counts.solid_components);
      CHECK(plateau.step.holes == counts.holes);
      CHECK(plateau.step.covered == counts.points_covered);
    }
  });
}

TEST_CASE("order and duplicates change no plateau, and a power of two scales its alphas") {
  Random random(61);
  on_small_sets([&](const Points& points) {
    Points shuffled = points;
    if (!shuffled.empty()) shuffled.push_back(shuffled.front());
    random.shuffle(shuffled);
    CHECK(plateaus_of(points) == plateaus_of(shuffled));
  });
  for (const Points& points : {two_discs(random), uniform(200, 62), clusters(20, 63)}) {
    const std::vector<Plateau> one = plateaus_of(points);
    for (const int exponent : {-700, 3, 700}) {
      std::vector<Plateau> other = plateaus_of(scaled(points, exponent));
      REQUIRE(other.size() == one.size());
      for (std::size_t i = 0; i < one.size(); ++i) {
        Plateau& plateau = other[i];
        for (double* alpha : {&plateau.from, &plateau.alpha, &plateau.step.alpha})
          *alpha = std::ldexp(*alpha, -exponent);
        if (plateau.to) *plateau.to = std::ldexp(*plateau.to, -exponent);
        plateau.step.area = one[i].step.area;
        CHECK(plateau == one[i]);
      }
    }
  }
}

TEST_CASE("the recommended plateau recovers shapes") {
  Random random(64);
  SUBCASE("two discs have two parts") { recommends(two_discs(random), 2, 0, 0.1, 0.5); }
  SUBCASE("two discs, one ten times as dense, have two parts") {
    const Points points = both(in_disc(2000, {0, 0}, 0, 1, random), in_disc(200, {5, 0}, 0, 1, random));
    recommends(points, 1.0 / (1.0 / 121 + 100.0 / 121), 0, 0.1, 1.6);
  }
  SUBCASE("three clusters that thin out have three parts") {
    Points points;
    for (const rbpa::Point& middle : Points{{0, 0}, {5, 1}, {1, 5}})
      for (int i = 0; i < 500; ++i) {
        const auto bell = [&] { return 0.3 * (random.unit() + random.unit() + random.unit() + random.unit() - 2); };
        const double x = bell();
        points.push_back({middle.x + x, middle.y + bell()});
      }
    recommends(points, 3, 0, 0.05, 2);
  }
  SUBCASE("a ring keeps its hole") { recommends(in_disc(600, {0, 0}, 0.7, 1, random), 1, 0.5, 0.05, 0.7); }
  SUBCASE("a ring around a disc keeps its hole") {
    recommends(both(in_disc(1000, {0, 0}, 0.8, 1, random), in_disc(300, {0, 0}, 0, 0.4, random)),
               1.0 / (100.0 / 169 + 9.0 / 169), 0.48, 0.03, 0.2);
  }
  SUBCASE("a square keeps four holes of different size") {
    Points points = uniform(9000, 65);
    const double side = std::sqrt(9000.0);
    const auto is_hole = [&](const rbpa::Point& p) {
      for (const auto& [x, y, r] : {std::array{0.2, 0.2, 0.1}, {0.7, 0.3, 0.15}, {0.4, 0.7, 0.06}, {0.8, 0.8, 0.05}})
        if (std::hypot(p.x - x * side, p.y - y * side) < r * side) return true;
      return false;
    };
    std::erase_if(points, is_hole);
    const Plateau best = plateaus_of(points).front();
    CHECK(best.kind == PlateauKind::structured);
    CHECK(best.step.holes == 4);
    CHECK(best.step.solid_components == 1);
  }
  SUBCASE("two interlocking half moons have two parts") {
    Points points;
    for (const rbpa::Point& p : in_disc(3000, {0, 0}, 0.85, 1.15, random))
      points.push_back(p.y > 0 ? p : rbpa::Point{p.x + 1, p.y + 0.4});
    recommends(points, 2, 0, 0.02, 0.25);
  }
  SUBCASE("a ring with a mouth stays open") { recommends(closing_ring(random), 1, 0, 0.1, 1); }
  SUBCASE("a bay stays open, with an outlier too") {
    recommends(bay(random), 1, 0, 0.1, 2);
    recommends(both(bay(random), {{1000, 0}}), 1, 0, 0.1, 2);
  }
}

TEST_CASE("an outlier, however far, and dust do not move the plateau of a shape") {
  Random random(66);
  const Points points = two_discs(random);
  const Plateau alone = plateaus_of(points).front();
  for (const double far : {20.0, 1e3, 1e9}) {
    CAPTURE(far);
    const Points outlier{{far, far}};
    const Points dust{{far, far}, {far + 0.1, far}, {far, far + 0.1}, {far + 0.1, far + 0.1}};
    for (const Points& more : {outlier, dust}) {
      const Plateau best = plateaus_of(both(points, more)).front();
      CHECK(best.kind == PlateauKind::structured);
      CHECK(best.from == doctest::Approx(alone.from).epsilon(0.05));
      CHECK(best.to.value() == doctest::Approx(alone.to.value()).epsilon(0.05));
    }
  }
}

TEST_CASE("noise and grids are in one piece, and no plateau of them is long by chance") {
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    for (const std::size_t count : {30u, 100u, 1000u}) {
      CAPTURE(count);
      CAPTURE(seed);
      for (const Points& points : {uniform(count, seed), jittered_grid(static_cast<int>(std::sqrt(count)), 0.9, seed)})
        for (const Plateau& plateau : plateaus_of(points))
          CHECK_FALSE((plateau.kind == PlateauKind::structured && plateau.is_long));
    }
  for (const Points& points : {perfect_grid(30, 1), triangular_lattice(30), uniform(5000, 67)}) {
    const Plateau best = plateaus_of(points).front();
    CHECK(best.is_long);
    CHECK(best.kind == PlateauKind::one_piece);
    CHECK(best.step.solid_components == 1);
    CHECK(best.step.covered == points.size());
    CHECK(best.from < 2);
  }
}

TEST_CASE("how long structured plateaus are by chance, in a square and in a strip" * doctest::skip()) {
  for (const double height : {1.0, 0.1})
    for (const std::size_t count : {10u, 20u, 50u, 100u, 200u, 500u, 1000u, 5000u}) {
      constexpr std::size_t sets = 1000;
      std::vector<double> longest;
      for (std::size_t seed = 0; seed < sets; ++seed) {
        Points points = uniform(count, seed);
        for (rbpa::Point& p : points) p.y *= height;
        longest.push_back(1);
        for (const Plateau& plateau : plateaus_of(points))
          if (plateau.kind == PlateauKind::structured) longest.back() = std::max(longest.back(), plateau.ratio);
      }
      std::sort(longest.begin(), longest.end());
      const double bound = 1.4 + 10 / std::sqrt(static_cast<double>(count));
      MESSAGE(height, " high, ", count, " points: longest in half of ", sets, " sets <= ", longest[sets / 2],
              ", in 95 of 100 ", longest[sets * 95 / 100], ", in 99 of 100 ", longest[sets * 99 / 100], ", bound ",
              bound);
      CHECK(longest[sets * (height == 1 ? 99 : 95) / 100] < bound);
    }
}

TEST_CASE("a triangle has one plateau without an end; points without a triangle have none") {
  const std::vector<Plateau> one = plateaus_of({{0, 0}, {6, 0}, {0, 8}});
  REQUIRE(one.size() == 1);
  CHECK(one[0].from == 5);
  CHECK(one[0].alpha == 5);
  CHECK_FALSE(one[0].to);
  CHECK_FALSE(one[0].is_long);
  CHECK(one[0].step.covered == 3);
  for (const Points& points :
       {Points{}, Points{{1, 2}}, Points{{1, 2}, {3, 4}}, Points(5, {1, 2}), collinear_run(20, 3, 1, 68)})
    CHECK(plateaus_of(points).empty());
}

TEST_CASE("parts that become one piece come first, then that piece and what closes around it, then the rest") {
  Random random(71);
  std::vector<Points> sets;
  for (const SmallSet& set : small_sets()) sets.push_back(set.points);
  for (std::uint64_t seed = 0; seed < 30; ++seed) sets.push_back(uniform(10 + 4 * seed, seed));
  sets.push_back(two_discs(random));
  sets.push_back(closing_ring(random));
  sets.push_back(both(bay(random), {{1000, 0}}));
  sets.push_back(both(two_discs(random), {{1000, 0}}));
  std::size_t above = 0, second_piece = 0, by_chance = 0, left_out = 0;
  for (const Points& points : sets) {
    const std::vector<Plateau> plateaus = plateaus_of(points);
    double piece = infinity;
    for (const Plateau& p : plateaus)
      if (p.is_long && p.kind == PlateauKind::one_piece) piece = std::min(piece, p.from);
    const std::size_t distinct = rbpa::rbpa(points, 1).distinct;
    const auto place = [&](const Plateau& p) {
      if (p.is_long && p.kind == PlateauKind::structured && p.from < piece) return 0;
      if (p.is_long && (p.kind == PlateauKind::structured || p.from == piece)) return 1;
      return p.is_long || 10 * p.step.covered >= 9 * distinct ? 2 : 3;
    };
    for (std::size_t i = 0; i + 1 < plateaus.size(); ++i) {
      CHECK(place(plateaus[i]) <= place(plateaus[i + 1]));
      const auto weight = [&](const Plateau& p) {
        return (p.ratio - 1) * (static_cast<double>(p.step.covered) / static_cast<double>(distinct));
      };
      if (place(plateaus[i]) == place(plateaus[i + 1])) CHECK(weight(plateaus[i]) >= weight(plateaus[i + 1]));
      above += place(plateaus[i]) == 1 && place(plateaus[i + 1]) == 1;
      second_piece += place(plateaus[i]) == 1 && place(plateaus[i + 1]) == 2 && plateaus[i + 1].is_long &&
                      plateaus[i + 1].ratio > plateaus[i].ratio;
      by_chance += place(plateaus[i]) == 1 && plateaus[i + 1].from < plateaus[i].from;
      left_out += place(plateaus[i]) == 2 && place(plateaus[i + 1]) == 3 && plateaus[i + 1].ratio > plateaus[i].ratio;
    }
  }
  // Each of the cases occurs.
  CHECK(above > 0);
  CHECK(second_piece > 0);
  CHECK(by_chance > 0);
  CHECK(left_out > 0);
}

TEST_CASE("false from go_on cancels the search for plateaus in every phase") {
  const Points points = random_grid(200, 20000, false, 69);
  const auto delaunay = delaunay_arrays(points);
  const Filtration all = rbpa::filtration(delaunay, points);
  std::size_t calls = 0;
  const auto whole = rbpa::plateaus(delaunay, points, all, [&] { return ++calls > 0; });
  CHECK(whole == rbpa::plateaus(delaunay, points, all));
  REQUIRE(calls > 5);
  for (std::size_t last = 1; last <= calls; last += 1 + calls / 10) {
    std::size_t call = 0;
    CHECK_THROWS_AS(rbpa::plateaus(delaunay, points, all, [&] { return ++call < last; }), rbpa::Cancelled);
  }
}

TEST_CASE("plateaus of a filtration of other points are refused") {
  const Points points = uniform(30, 70), others = uniform(31, 70);
  const auto delaunay = delaunay_arrays(points);
  const Filtration all = rbpa::filtration(delaunay, points);
  CHECK_THROWS_AS(rbpa::plateaus(delaunay_arrays(others), others, all), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::plateaus(delaunay, others, all), meshops::ContractViolation);
}

TEST_SUITE_END();
