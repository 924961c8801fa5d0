#include "support/generate_polygons.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rbpa_test {
namespace {

using rbpa::Point;
using rbpa::Ring;

constexpr double pi = 3.14159265358979323846;

Ring add_ring(PolygonCase& to, const Points& places) {
  Ring ring;
  for (const Point& p : places) {
    ring.points.push_back(static_cast<std::uint32_t>(to.points.size()));
    to.points.push_back(p);
  }
  return ring;
}

Points circle(const Point& center, double radius, int n, double turn = 0) {
  Points places;
  for (int i = 0; i < n; ++i) {
    const double angle = turn + 2 * pi * i / n;
    places.push_back({center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)});
  }
  return places;
}

Points star(Random& random, const Point& center, double least, double most, int n) {
  Points places = circle(center, 1, n);
  for (Point& p : places) {
    const double radius = random.between(least, most);
    p = {center.x + radius * (p.x - center.x), center.y + radius * (p.y - center.y)};
  }
  return places;
}

Points rectangle(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

PolygonCase star_with_holes(Random& random) {
  PolygonCase made{.name = "star with holes", .size = 0.06};
  made.polygons.push_back({.shell = add_ring(made, star(random, {0, 0}, 0.6, 1.2, random.integer(5, 24)))});
  const int holes = random.integer(0, 4);
  for (int h = 0; h < holes; ++h) {
    const double angle = 2 * pi * h / holes;
    const Point center{0.28 * std::cos(angle), 0.28 * std::sin(angle)};
    made.polygons[0].holes.push_back(add_ring(made, star(random, center, 0.08, 0.12, random.integer(3, 6))));
  }
  return made;
}

PolygonCase comb(Random& random) {
  PolygonCase made{.name = "comb", .size = 0.1};
  Points places{{-1, -0.5}};
  const int teeth = random.integer(2, 6);
  for (int i = teeth - 1; i >= 0; --i) {
    const double x = 0.8 * i, height = random.between(0.5, 2);
    for (const Point& p : Points{{x + 0.4, 0}, {x + 0.35, height}, {x, height}, {x - 0.05, 0}}) places.push_back(p);
  }
  places.push_back({-1, 0});
  // The order is clockwise, because nothing depends on it; the first place is beyond the last tooth.
  places.insert(places.begin() + 1, {0.8 * teeth, -0.5});
  made.polygons.push_back({.shell = add_ring(made, places)});
  return made;
}

PolygonCase spiral(Random& random) {
  PolygonCase made{.name = "spiral", .size = 0.045};
  const int n = random.integer(20, 60);
  const double turns = random.between(1, 3);
  Points places;
  const auto at = [&](int i, double width) {
    const double angle = 2 * pi * turns * i / n, radius = 0.25 + 0.25 * angle / (2 * pi) + width;
    return Point{radius * std::cos(angle), radius * std::sin(angle)};
  };
  for (int i = 0; i <= n; ++i) places.push_back(at(i, 0.13));
  for (int i = n; i >= 0; --i) places.push_back(at(i, 0));
  made.polygons.push_back({.shell = add_ring(made, places)});
  return made;
}

PolygonCase nearly_touching(Random& random) {
  PolygonCase made{.name = "nearly touching holes", .size = 0.08, .is_roomy = false};
  made.polygons.push_back({.shell = add_ring(made, rectangle(0, 0, 1, 1))});
  const double gap = std::ldexp(1, -random.integer(4, 50));
  made.polygons[0].holes.push_back(add_ring(made, rectangle(gap, 0.25, 0.5 - gap, 0.75)));
  made.polygons[0].holes.push_back(add_ring(made, {{0.5, 0.5}, {0.75, 0.25}, {1 - gap, 0.5}, {0.75, 0.75}}));
  return made;
}

PolygonCase slivers(Random& random) {
  PolygonCase made{.name = "slivers", .size = 0.1, .is_roomy = false};
  // Saw teeth that get thinner and thinner.
  Points places{{0, 0}};
  double x = 0;
  const int teeth = random.integer(2, 12);
  for (int i = 0; i < teeth; ++i) {
    const double width = std::ldexp(1, -3 * i) * random.between(0.2, 1);
    places.push_back({x + 0.9 * width, random.between(-1, 1)});
    x += width;
    places.push_back({x, 0});
  }
  places.push_back({x, 1.5});
  places.push_back({0, 1.5});
  made.polygons.push_back({.shell = add_ring(made, places)});
  return made;
}

PolygonCase collinear(Random& random) {
  PolygonCase made{.name = "collinear vertices", .size = 1};
  const int side = random.integer(4, 14);
  Points places;
  for (int i = 0; i < side; ++i) places.push_back({double(i), 0});
  for (int i = 0; i < side; ++i) places.push_back({double(side), double(i)});
  for (int i = side; i > 0; --i) places.push_back({double(i), double(side)});
  for (int i = side; i > 0; --i) places.push_back({0, double(i)});
  made.polygons.push_back({.shell = add_ring(made, places)});
  if (side > 6) made.polygons[0].holes.push_back(add_ring(made, rectangle(2, 2, 4, 4)));
  return made;
}

PolygonCase far_away(Random& random) {
  PolygonCase made{.name = "far from the origin", .size = 0.08};
  const double far = std::ldexp(1, random.integer(10, 40));
  made.polygons.push_back({.shell = add_ring(made, star(random, {far, -far}, 0.7, 1.2, random.integer(5, 16)))});
  made.polygons[0].holes.push_back(add_ring(made, circle({far, -far}, 0.25, 6)));
  return made;
}

PolygonCase polygons_in_holes(Random& random) {
  PolygonCase made{.name = "polygons in holes", .size = 0.2};
  double radius = 3;
  const int depth = random.integer(1, 3);
  for (int i = 0; i < depth; ++i, radius -= 1) {
    made.polygons.push_back({.shell = add_ring(made, circle({0, 0}, radius, 12, random.unit()))});
    made.polygons.back().holes.push_back(add_ring(made, circle({0, 0}, radius - 0.55, 8, random.unit())));
  }
  made.polygons.push_back({.shell = add_ring(made, rectangle(4, -1, 6, 1))});
  return made;
}

bool crosses(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto side = [](const Point& p, const Point& q, const Point& r) {
    const double area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    return (area > 0) - (area < 0);
  };
  return side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
}

/// Returns a closed path through points in general position, untangled.
PolygonCase untangled(Random& random) {
  PolygonCase made{.name = "untangled", .size = 0.12, .is_roomy = false};
  Points places(static_cast<std::size_t>(random.integer(6, 30)));
  for (Point& p : places) p = {random.unit(), random.unit()};
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i + 2 < places.size(); ++i)
      for (std::size_t j = i + 2; j < places.size(); ++j) {
        const std::size_t next = (j + 1) % places.size();
        if (next == i || !crosses(places[i], places[i + 1], places[j], places[next])) continue;
        std::reverse(places.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                     places.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        changed = true;
      }
  }
  made.polygons.push_back({.shell = add_ring(made, places)});
  return made;
}

/// Returns a large polygon with short edges, which a constant size ignores.
PolygonCase notched(Random& random) {
  PolygonCase made{.name = "notched", .size = 0.15, .is_roomy = false};
  Points places;
  for (int i = 0; i < 40; ++i) places.push_back({i * 0.01, random.between(0, 0.01)});
  for (const Point& p : Points{{2, 0}, {2, 1}, {0, 1}}) places.push_back(p);
  made.polygons.push_back({.shell = add_ring(made, places)});
  made.polygons[0].holes.push_back(add_ring(made, circle({1, 0.5}, 0.1, 50)));
  return made;
}

}  // namespace

PolygonCase polygon_case(std::size_t number) {
  Random random(number);
  constexpr PolygonCase (*kinds[])(Random&) = {star_with_holes, comb,     spiral,  nearly_touching,   slivers,
                                               collinear,       far_away, notched, polygons_in_holes, untangled};
  PolygonCase made = kinds[number % std::size(kinds)](random);
  made.name += ", number " + std::to_string(number);
  return made;
}

PolygonCase random_rings(Random& random, int rings, int points, int side) {
  PolygonCase made{.name = "random rings"};
  for (int r = 0; r < rings; ++r) {
    Points places(static_cast<std::size_t>(random.integer(3, points)));
    for (Point& p : places) p = {double(random.integer(0, side)), double(random.integer(0, side))};
    made.polygons.push_back({.shell = add_ring(made, places)});
  }
  return made;
}

}  // namespace rbpa_test
