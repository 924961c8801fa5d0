#include <array>

#include "bench/slow_paths.h"

namespace rbpa_bench {
namespace {

using rbpa::Point;

/// Returns a number whose ternary digits are 0 and 2.
double cantor(Random& random) {
  double x = 0, digit = 2.0 / 3;
  for (int i = 0; i < 30; ++i, digit /= 3) x += random.chance(0.5) ? digit : 0;
  return x;
}

/// Map x ↦ a x + b y + e, y ↦ c x + d y + f, chosen with a probability.
struct Affine {
  double a, b, c, d, e, f, probability;
};

template <std::size_t size>
Points chaos_game(std::size_t count, std::uint64_t seed, const std::array<Affine, size>& maps) {
  Point at{0, 0};
  return scattered(count, seed, [&](Random& random) {
    double chance = random.unit();
    std::size_t i = 0;
    while (i + 1 < size && chance >= maps[i].probability) chance -= maps[i++].probability;
    const Affine& m = maps[i];
    at = {m.a * at.x + m.b * at.y + m.e, m.c * at.x + m.d * at.y + m.f};
    return at;
  });
}

Points sierpinski_triangle(std::size_t count) {
  return chaos_game<3>(
      count, 40,
      {{{0.5, 0, 0, 0.5, 0, 0, 1 / 3.0}, {0.5, 0, 0, 0.5, 0.5, 0, 1 / 3.0}, {0.5, 0, 0, 0.5, 0.25, 0.43, 1 / 3.0}}});
}

Points fern(std::size_t count) {
  return chaos_game<4>(count, 41,
                       {{{0, 0, 0, 0.16, 0, 0, 0.01},
                         {0.85, 0.04, -0.04, 0.85, 0, 1.6, 0.85},
                         {0.2, -0.26, 0.23, 0.22, 0, 1.6, 0.07},
                         {-0.15, 0.28, 0.26, 0.24, 0, 0.44, 0.07}}});
}

Points sierpinski_carpet(std::size_t count) {
  return scattered(count, 42, [](Random& random) {
    Point p{0, 0};
    double digit = 1 / 3.0;
    for (int i = 0; i < 30; ++i, digit /= 3) {
      int x = 1, y = 1;
      while (x == 1 && y == 1) {
        x = random.integer(0, 2);
        y = random.integer(0, 2);
      }
      p = {p.x + x * digit, p.y + y * digit};
    }
    return p;
  });
}

/// Returns a walk with steps whose length has no mean.
Points levy_flight(std::size_t count) {
  Point at{0, 0};
  return scattered(count, 43, [&](Random& random) {
    const double length = 1 / (1 - random.unit());
    const Point step = polar(length, random.unit());
    at = {at.x + step.x, at.y + step.y};
    return at;
  });
}

Points henon(std::size_t count) {
  Point at{0.1, 0.1};
  return scattered(count, 44, [&](Random&) {
    at = {1 - 1.4 * at.x * at.x + at.y, 0.3 * at.x};
    return at;
  });
}

/// Returns nested quarters, one of which has most of the points.
Points cascade(std::size_t count) {
  return scattered(count, 45, [](Random& random) {
    Point p{0, 0};
    double half = 0.5;
    for (int i = 0; i < 40; ++i, half /= 2) {
      const double u = random.unit();
      const int quarter = u < 0.55 ? 0 : u < 0.75 ? 1 : u < 0.9 ? 2 : 3;
      p = {p.x + (quarter % 2) * half, p.y + (quarter / 2) * half};
    }
    return p;
  });
}

/// Returns `number` crowds of a width in a square of side 1, and the other points anywhere.
Points crowds(std::size_t count, int number, double width, double share, std::uint64_t seed) {
  const Points center = scattered(static_cast<std::size_t>(number), seed, [](Random& random) {
    const double x = random.unit();
    return Point{x, random.unit()};
  });
  return scattered(count, seed + 1, [&](Random& random) {
    const double x = random.unit(), y = random.unit();
    if (!random.chance(share)) return Point{x, y};
    const Point& at = center[random.below(center.size())];
    return Point{at.x + width * x, at.y + width * y};
  });
}

/// Returns groups of points 1e-9 apart.
Points close_together(std::size_t count, std::size_t each, std::uint64_t seed) {
  const std::size_t groups = count / each;
  Points points = rbpa_test::uniform(groups, seed);
  for (std::size_t i = 0; i < (each - 1) * groups; ++i) {
    const Point by = polar(1e-9, static_cast<double>(i) / static_cast<double>(count));
    points.push_back({points[i % groups].x + by.x, points[i % groups].y + by.y});
  }
  return shuffled(points, seed + 1);
}

}  // namespace

void add_slow_dust(SlowPaths& all) {
  all.kind = "dust";
  all.each("Cantor dust", 31, [](Random& random) {
    const double x = cantor(random);
    return Point{x, cantor(random)};
  });
  all.each("Cantor set of lines", 32, [](Random& random) {
    const double x = cantor(random);
    return Point{x, random.unit()};
  });
  all.add("Sierpinski triangle", sierpinski_triangle);
  all.add("Sierpinski carpet", sierpinski_carpet);
  all.add("fern", fern);
  all.add("Hénon's attractor", henon);
  all.add("Lévy flight", levy_flight);
  all.add("cascade", cascade);

  all.kind = "crowd";
  all.add("half within 1e-6", [](std::size_t n) { return crowds(n, 1, 1e-6, 0.5, 50); });
  all.add("half within 1e-12", [](std::size_t n) { return crowds(n, 1, 1e-12, 0.5, 52); });
  all.add("all but 1 % within 1e-6", [](std::size_t n) { return crowds(n, 1, 1e-6, 0.99, 54); });
  all.add("100 crowds of 1e-6", [](std::size_t n) { return crowds(n, 100, 1e-6, 0.5, 56); });
  all.add("100 crowds of 1e-6 alone", [](std::size_t n) { return crowds(n, 100, 1e-6, 1, 58); });
  all.add("1000 crowds of 1e-4", [](std::size_t n) { return crowds(n, 1000, 1e-4, 0.9, 60); });
  all.add("clusters, three decades", [](std::size_t n) { return gaussian_clusters(n, 3); });
  all.add("clusters, six decades", [](std::size_t n) { return gaussian_clusters(n, 6); });
  all.add("clusters, ten scales", [](std::size_t n) { return rbpa_test::clusters(n / 10, 62); });
  all.add("Kuzmin", [](std::size_t n) { return kuzmin.make(n); });
  all.add("three decades", [](std::size_t n) { return decades.make(n); });
  all.each("normal", 63, [](Random& random) {
    const double x = normal(random);
    return Point{x, normal(random)};
  });
  all.each("Cauchy", 64, [](Random& random) {
    const double x = std::tan(std::numbers::pi * (random.unit() - 0.5));
    return Point{x, std::tan(std::numbers::pi * (random.unit() - 0.5))};
  });
  all.add("two densities", two_level_sampling);
  all.each("ring", 65, [](Random& random) {
    const double radius = random.between(0.99, 1);
    return polar(radius, random.unit());
  });

  all.kind = "duplicates";
  all.add("every point twice", [](std::size_t n) {
    Points points = rbpa_test::uniform(n / 2, 66);
    points.insert(points.end(), points.begin(), points.begin() + static_cast<std::ptrdiff_t>(n / 2));
    return shuffled(points, 67);
  });
  all.add("up to ten times", [](std::size_t n) { return rbpa_test::duplicates(n * 2 / 11, 10, 68); });
  all.add("half of them one point", [](std::size_t n) {
    Points points = rbpa_test::uniform(n / 2, 69);
    points.resize(n, points[7]);
    return shuffled(points, 70);
  });
  all.add("a hundred distinct", [](std::size_t n) { return rbpa_test::random_grid(10, n, true, 71); });
  all.add("on a coarse lattice", [](std::size_t n) {
    return scattered(n, 72, [side = columns_for(n)](Random& random) {
      const double x = random.integer(0, side);
      return Point{x, static_cast<double>(random.integer(0, side))};
    });
  });
  all.add("pairs 1e-9 apart", [](std::size_t n) { return close_together(n, 2, 73); });
  all.add("triples 1e-9 apart", [](std::size_t n) { return close_together(n, 3, 75); });
  all.add("pairs a bit apart", [](std::size_t n) { return rbpa_test::nearest_doubles(n / 2, 77); });
}

}  // namespace rbpa_bench
