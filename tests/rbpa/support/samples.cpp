#include "support/samples.h"

#include <array>
#include <cmath>
#include <limits>

namespace rbpa_test {
namespace {

using rbpa::Point;

/// Integer points at distance 65 from the origin: a quarter of them.
constexpr std::array<Point, 9> quarter_circle = {Point{65, 0}, {63, 16}, {60, 25}, {56, 33}, {52, 39},
                                                 {39, 52},     {33, 56}, {25, 60}, {16, 63}};

Point on_circle_65(Random& random) {
  Point p = quarter_circle[random.below(quarter_circle.size())];
  for (std::uint64_t turns = random.below(4); turns > 0; --turns) p = {-p.y, p.x};
  return p;
}

double sign(Random& random) { return random.chance(0.5) ? 1 : -1; }

/// Returns a double with up to 53 random bits, a multiple of 2^lowest below 2^highest.
double between_powers(int lowest, int highest, Random& random) {
  const int bits = random.integer(1, 53);
  const double digits = std::ldexp(static_cast<double>((random.bits() >> (64 - bits)) | 1), 0);
  const int top = highest - bits;
  return top < lowest ? sign(random) * std::ldexp(1.0, lowest)
                      : sign(random) * std::ldexp(digits, random.integer(lowest, top));
}

void fill_line(std::span<Point> points, int jiggle, Random& random) {
  const double dx = random.integer(-20, 20), dy = random.integer(-20, 20);
  const double x = random.integer(-1000, 1000), y = random.integer(-1000, 1000);
  const double scale = jiggle == 0 ? std::ldexp(1.0, random.integer(-40, 40)) : random.between(0.001, 1000);
  for (Point& p : points) {
    const double t = random.integer(-50, 50);
    p = {jiggled((x + t * dx) * scale, jiggle, random), jiggled((y + t * dy) * scale, jiggle, random)};
  }
}

void fill_circle(std::span<Point> points, int jiggle, Random& random) {
  const double x = random.integer(-300, 300), y = random.integer(-300, 300);
  const double scale = jiggle == 0 ? std::ldexp(1.0, random.integer(-40, 40)) : random.between(0.001, 1000);
  for (Point& p : points) {
    const Point c = on_circle_65(random);
    p = {jiggled((x + c.x) * scale, jiggle, random), jiggled((y + c.y) * scale, jiggle, random)};
  }
}

/// Fills in a near tie of another kind, scaled to the limit of what fits.
void fill_limits(std::span<Point> points, Random& random) {
  switch (random.below(5)) {
    case 0:
      for (Point& p : points) p = {between_powers(-150, 150, random), between_powers(-150, 150, random)};
      return;
    case 1:  // a few of the smallest steps apart
      for (Point& p : points) p = {std::ldexp(random.integer(-4, 4), -150), std::ldexp(random.integer(-4, 4), -150)};
      return;
    case 2:  // corners of the largest box, with steps of one last place
      for (Point& p : points) {
        const double largest = 0x1.fffffffffffffp+149;
        p = {sign(random) * (largest - std::ldexp(random.integer(0, 3), 97)),
             sign(random) * (largest - std::ldexp(random.integer(0, 3), 97))};
      }
      return;
    case 3:  // tiny and huge: slivers with the largest circumradii
      for (Point& p : points) {
        const bool far = random.chance(0.5);
        p = {far ? sign(random) * std::ldexp(random.integer(1, 3), 147) : std::ldexp(random.integer(-2, 2), -150),
             std::ldexp(random.integer(-2, 2), random.chance(0.5) ? -150 : 140)};
      }
      return;
    default:
      if (random.chance(0.5))
        fill_line(points, 1, random);
      else
        fill_circle(points, 1, random);
      const int exponent = random.chance(0.5) ? 120 : -85;
      for (Point& p : points) {
        const auto fit = [&](double c) {
          const double scaled = std::ldexp(c, exponent);
          return std::round(std::ldexp(scaled, 150)) == std::ldexp(scaled, 150) ? scaled : 0;
        };
        p = {fit(p.x), fit(p.y)};
      }
  }
}

void fill_extreme(std::span<Point> points, Random& random) {
  switch (random.below(6)) {
    case 0:
      for (Point& p : points)
        p = {sign(random) * std::ldexp(1 + random.unit(), random.integer(-1074, 1023)),
             sign(random) * std::ldexp(1 + random.unit(), random.integer(-1074, 1023))};
      return;
    case 1:  // denormals
      for (Point& p : points)
        p = {random.integer(-4, 4) * std::numeric_limits<double>::denorm_min(),
             random.integer(-4, 4) * std::numeric_limits<double>::denorm_min()};
      return;
    case 2:  // the corners of the range
      for (Point& p : points)
        p = {random.integer(-1, 1) * std::numeric_limits<double>::max(),
             random.integer(-1, 1) * std::numeric_limits<double>::max()};
      return;
    case 3:
      for (Point& p : points) {
        const double scale[3] = {1e-300, 1, 1e300};
        p = {random.integer(-3, 3) * scale[random.below(3)], random.integer(-3, 3) * scale[random.below(3)]};
      }
      return;
    default: {
      if (random.chance(0.5))
        fill_line(points, random.integer(0, 1), random);
      else
        fill_circle(points, random.integer(0, 1), random);
      const int exponent = random.chance(0.5) ? 960 : -1080;
      for (Point& p : points) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
    }
  }
}

}  // namespace

double jiggled(double value, int most, Random& random) {
  for (int steps = random.integer(-most, most); steps != 0; steps += steps < 0 ? 1 : -1)
    value = std::nextafter(
        value, steps < 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity());
  // Near zero the next doubles are denormals, which are not a small change.
  return std::abs(value) < 1e-300 && most > 0 ? 0 : value;
}

const char* name(Kind kind) {
  static constexpr std::array names = {"uniform",          "small grid",  "near a line", "on a line",
                                       "near a circle",    "on a circle", "offset grid", "mixed scales",
                                       "limits of double", "extreme"};
  static_assert(names.size() == static_cast<std::size_t>(Kind::extreme) + 1);
  return names[static_cast<std::size_t>(kind)];
}

void fill(std::span<Point> points, Kind kind, Random& random) {
  switch (kind) {
    case Kind::uniform:
      for (Point& p : points) p = {random.between(-1, 1), random.between(-1, 1)};
      return;
    case Kind::small_grid:
      for (Point& p : points) p = {double(random.integer(-3, 3)), double(random.integer(-3, 3))};
      return;
    case Kind::near_line:
      return fill_line(points, 2, random);
    case Kind::on_line:
      return fill_line(points, 0, random);
    case Kind::near_circle:
      return fill_circle(points, 2, random);
    case Kind::on_circle:
      return fill_circle(points, 0, random);
    case Kind::offset_grid:
      for (Point& p : points) p = {1e6 + 1e-3 * random.integer(-3, 3), -1e6 + 1e-3 * random.integer(-3, 3)};
      return;
    case Kind::mixed_scales:
      for (Point& p : points)
        p = {random.between(-1, 1) * std::ldexp(1.0, random.integer(-40, 40)),
             random.between(-1, 1) * std::ldexp(1.0, random.integer(-40, 40))};
      return;
    case Kind::limits_of_double:
      return fill_limits(points, random);
    case Kind::extreme:
      return fill_extreme(points, random);
  }
}

}  // namespace rbpa_test
