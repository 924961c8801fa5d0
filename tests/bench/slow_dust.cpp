#include <array>

#include "bench/slow_generate.h"
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

}  // namespace

void add_slow_dust(std::vector<SlowPath>& all) {
  const char* kind = "dust";
  const auto add = [&](const char* name, Points (*make)(std::size_t)) { all.push_back({kind, {name, make}}); };
  add("Cantor dust", [](std::size_t n) {
    return scattered(n, 31, [](Random& random) {
      const double x = cantor(random);
      return Point{x, cantor(random)};
    });
  });
  add("Cantor set of lines", [](std::size_t n) {
    return scattered(n, 32, [](Random& random) {
      const double x = cantor(random);
      return Point{x, random.unit()};
    });
  });
  add("Sierpinski triangle", sierpinski_triangle);
  add("Sierpinski carpet", sierpinski_carpet);
  add("fern", fern);
  add("Hénon's attractor", henon);
  add("Lévy flight", levy_flight);
  add("cascade", cascade);

  kind = "crowd";
  add("half within 1e-6", [](std::size_t n) { return crowds(n, 1, 1e-6, 0.5, 50); });
  add("half within 1e-12", [](std::size_t n) { return crowds(n, 1, 1e-12, 0.5, 52); });
  add("all but 1 % within 1e-6", [](std::size_t n) { return crowds(n, 1, 1e-6, 0.99, 54); });
  add("100 crowds of 1e-6", [](std::size_t n) { return crowds(n, 100, 1e-6, 0.5, 56); });
  add("100 crowds of 1e-6 alone", [](std::size_t n) { return crowds(n, 100, 1e-6, 1, 58); });
  add("1000 crowds of 1e-4", [](std::size_t n) { return crowds(n, 1000, 1e-4, 0.9, 60); });
  add("clusters, three decades", [](std::size_t n) { return gaussian_clusters(n, 3); });
  add("clusters, six decades", [](std::size_t n) { return gaussian_clusters(n, 6); });
  add("clusters, ten scales", [](std::size_t n) { return rbpa_test::clusters(n / 10, 62); });
  add("Kuzmin", [](std::size_t n) { return kuzmin.make(n); });
  add("three decades", [](std::size_t n) { return decades.make(n); });
  add("normal", [](std::size_t n) {
    return scattered(n, 63, [](Random& random) {
      const double x = normal(random);
      return Point{x, normal(random)};
    });
  });
  add("Cauchy", [](std::size_t n) {
    return scattered(n, 64, [](Random& random) {
      const double x = std::tan(std::numbers::pi * (random.unit() - 0.5));
      return Point{x, std::tan(std::numbers::pi * (random.unit() - 0.5))};
    });
  });
  add("two densities", two_level_sampling);
  add("ring", [](std::size_t n) {
    return scattered(n, 65, [](Random& random) {
      const double radius = random.between(0.99, 1);
      return polar(radius, random.unit());
    });
  });

  kind = "duplicates";
  add("every point twice", [](std::size_t n) {
    Points points = rbpa_test::uniform(n / 2, 66);
    points.insert(points.end(), points.begin(), points.begin() + static_cast<std::ptrdiff_t>(n / 2));
    return shuffled(points, 67);
  });
  add("up to ten times", [](std::size_t n) { return rbpa_test::duplicates(n * 2 / 11, 10, 68); });
  add("half of them one point", [](std::size_t n) {
    Points points = rbpa_test::uniform(n / 2, 69);
    points.resize(n, points[7]);
    return shuffled(points, 70);
  });
  add("a hundred distinct", [](std::size_t n) { return rbpa_test::random_grid(10, n, true, 71); });
  add("on a coarse lattice", [](std::size_t n) {
    return scattered(n, 72, [side = columns_for(n)](Random& random) {
      const double x = random.integer(0, side);
      return Point{x, static_cast<double>(random.integer(0, side))};
    });
  });
  add("pairs 1e-9 apart", [](std::size_t n) {
    Points points = rbpa_test::uniform(n / 2, 73);
    for (std::size_t i = 0; i < n / 2; ++i) {
      const Point by = polar(1e-9, static_cast<double>(i) / static_cast<double>(n));
      points.push_back({points[i].x + by.x, points[i].y + by.y});
    }
    return shuffled(points, 74);
  });
  add("triples 1e-9 apart", [](std::size_t n) {
    Points points = rbpa_test::uniform(n / 3, 75);
    for (std::size_t i = 0; i < 2 * (n / 3); ++i) {
      const Point by = polar(1e-9, static_cast<double>(i) / static_cast<double>(n));
      points.push_back({points[i % (n / 3)].x + by.x, points[i % (n / 3)].y + by.y});
    }
    return shuffled(points, 76);
  });
  add("pairs a bit apart", [](std::size_t n) { return rbpa_test::nearest_doubles(n / 2, 77); });
}

}  // namespace rbpa_bench
