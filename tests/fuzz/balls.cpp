// Balls: any centers on a grid with any radii have a regular triangulation without a conflict, which does not depend on
//        their order; and the parts of their union, and of that of discs, add up, are within bounds, and scale exactly.
// An input is a byte with the bits of coordinates and radii, a byte for the unit, then four bytes a ball: x, y, z,
// radius. Few bits make nested, tangent, equal and cospherical balls.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "fuzz/target.h"
#include "rbpa/space/balls/measure_balls.h"
#include "rbpa/space/balls/measure_discs.h"
#include "rbpa/space/balls/union_of_balls.h"

namespace {

using rbpa::BallMeasures;
using rbpa::Point3;
using rbpa::RegularTriangulation;
using Whole = std::array<std::int64_t, 4>;  // center and radius, in units
using Row = std::array<std::uint32_t, 4>;

constexpr std::size_t most_balls = 40;

struct Balls {
  std::vector<Whole> wholes;
  std::vector<Point3> centers;
  std::vector<double> radii;

  Balls(std::vector<Whole> in_units, int exponent) : wholes(std::move(in_units)) {
    for (const Whole& ball : wholes) {
      const auto scaled = [&](std::size_t k) { return std::ldexp(static_cast<double>(ball[k]), exponent); };
      centers.push_back({scaled(0), scaled(1), scaled(2)});
      radii.push_back(scaled(3));
    }
  }
};

/// Returns the determinant of the vectors from `from` to three others.
std::int64_t six_volumes(const Whole& from, const Whole& p, const Whole& q, const Whole& r) {
  const auto to = [&](const Whole& b, std::size_t axis) { return b[axis] - from[axis]; };
  return to(p, 0) * (to(q, 1) * to(r, 2) - to(q, 2) * to(r, 1)) -
         to(p, 1) * (to(q, 0) * to(r, 2) - to(q, 2) * to(r, 0)) +
         to(p, 2) * (to(q, 0) * to(r, 1) - to(q, 1) * to(r, 0));
}

/// Returns whether q conflicts with positively oriented balls: whether its lift is below the plane of theirs. All
/// numbers are below 2^60.
bool is_conflict(const std::array<Whole, 4>& b, const Whole& q) {
  std::array<std::int64_t, 4> lift{};  // relative to q
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) lift[k] += (b[k][axis] - q[axis]) * (b[k][axis] - q[axis]);
    lift[k] += q[3] * q[3] - b[k][3] * b[k][3];
  }
  return lift[3] * six_volumes(q, b[0], b[1], b[2]) - lift[2] * six_volumes(q, b[0], b[1], b[3]) +
             lift[1] * six_volumes(q, b[0], b[2], b[3]) - lift[0] * six_volumes(q, b[1], b[2], b[3]) <
         0;
}

/// Returns the rows with balls as corners, in order, so that they do not depend on the numbers of the balls.
std::vector<std::array<Whole, 4>> by_balls(const Balls& balls, const std::vector<Row>& rows) {
  std::vector<std::array<Whole, 4>> result;
  for (const Row& row : rows) {
    std::array<Whole, 4>& own = result.emplace_back();
    for (std::size_t k = 0; k < 4; ++k)
      own[k] = row[k] == RegularTriangulation::none ? Whole{-1, -1, -1, -1} : balls.wholes[row[k]];
    std::sort(own.begin(), own.end());
  }
  std::sort(result.begin(), result.end());
  return result;
}

void check_triangulation(const Balls& balls, const RegularTriangulation& regular) {
  std::vector<int> count(balls.radii.size(), 0);
  std::int64_t volume = 0, whole_volume = 0;
  for (const Row& row : regular.simplices) {
    std::array<Whole, 4> corners{};
    for (std::size_t k = 0; k < 4; ++k) corners[k] = balls.wholes[row[k]];
    const std::int64_t own = six_volumes(corners[0], corners[1], corners[2], corners[3]);
    fuzz::require(own > 0, "tetrahedra are positively oriented");
    volume += own;
    for (const Whole& ball : balls.wholes) fuzz::require(!is_conflict(corners, ball), "no ball conflicts");
  }
  for (const Row& row : rbpa::solid(balls.centers, std::numeric_limits<double>::infinity()).simplices)
    whole_volume += six_volumes(balls.wholes[row[0]], balls.wholes[row[1]], balls.wholes[row[2]], balls.wholes[row[3]]);
  fuzz::require(volume == whole_volume, "tetrahedra fill the hull");
  for (const auto* rows : {&regular.simplices, &regular.flat})
    for (const Row& row : *rows)
      for (const std::uint32_t corner : row)
        if (corner != RegularTriangulation::none) count[corner] = 1;
  for (const std::uint32_t i : regular.hidden) count[i] += 4;
  for (const rbpa::Duplicate& duplicate : regular.duplicates) {
    count[duplicate.index] += 8;
    fuzz::require(balls.wholes[duplicate.index] == balls.wholes[duplicate.stands_for], "duplicates are equal");
  }
  fuzz::require(std::all_of(count.begin(), count.end(), [](int of) { return of == 1 || of == 4 || of == 8; }),
                "each ball is a corner, hidden or a duplicate");
}

void check_measures(const Balls& balls, const BallMeasures& found, double unit) {
  double volume = 0, area = 0, all = 0, largest = 0;
  for (std::size_t i = 0; i < balls.radii.size(); ++i) {
    const double r = balls.radii[i] / unit, whole = 4 * std::numbers::pi / 3 * r * r * r;
    const double v = found.volumes[i] / unit / unit / unit, a = found.areas[i] / unit / unit;
    fuzz::require(v >= 0 && v <= whole * (1 + 1e-12), "a part is not larger than its ball");
    fuzz::require(a >= 0 && a <= 4 * std::numbers::pi * r * r, "an area is not larger than its sphere");
    fuzz::require(a == 0 || found.arcs[i] > 0 || a == 4 * std::numbers::pi * r * r,
                  "arcs bound what is no whole sphere");
    volume += v;
    area += a;
    all += whole;
    largest = std::max(largest, whole);
  }
  for (const std::uint32_t i : found.hidden)
    fuzz::require(found.volumes[i] == 0 && found.areas[i] == 0 && found.arcs[i] == 0, "hidden balls have no part");
  const double total = found.volume / unit / unit / unit;
  fuzz::require(std::abs(volume - total) <= 1e-12 * total, "volumes add up");
  fuzz::require(std::abs(area - found.area / unit / unit) <= 1e-12 * area, "areas add up");
  fuzz::require(total >= largest * (1 - 1e-11) && total <= all * (1 + 1e-11), "a union is within its bounds");
  for (const auto* gradient : {&found.volume_gradient, &found.area_gradient}) {
    double sum = 0, size = 0;
    for (const Point3& g : *gradient) {
      sum += g.x + g.y + g.z;
      size += std::abs(g.x) + std::abs(g.y) + std::abs(g.z);
    }
    fuzz::require(std::abs(sum) <= 1e-12 * size, "gradients vanish for translations");
  }
}

/// Checks the discs whose centers are those of the balls without z.
void check_discs(const Balls& balls, const Balls& reversed) {
  const auto measured = [](const Balls& of) {
    std::vector<rbpa::Point> centers;
    for (const Point3& p : of.centers) centers.push_back({p.x, p.y});
    return rbpa::measure_discs(centers, of.radii);
  };
  const rbpa::DiscMeasures found = measured(balls), other = measured(reversed);
  double squares = 0, radii = 0, area = 0, length = 0, largest = 0;
  for (const double r : balls.radii) {
    squares += r * r;
    radii += r;
    largest = std::max(largest, std::numbers::pi * r * r);
  }
  for (const rbpa::DiscCurve& curve : found.boundary) {
    area += curve.area;
    length += curve.length;
    fuzz::require(curve.is_hole ? curve.area <= 1e-11 * squares : curve.area >= -1e-11 * squares,
                  "outer curves are counter-clockwise, those of holes clockwise");
  }
  fuzz::require(std::abs(area - found.area) <= 1e-11 * squares && std::abs(length - found.length) <= 1e-11 * radii,
                "curves add up");
  fuzz::require(found.area >= largest * (1 - 1e-12) && found.area <= std::numbers::pi * squares * (1 + 1e-12),
                "a union of discs is within its bounds");
  fuzz::require(found.boundary.size() == other.boundary.size() && std::abs(found.area - other.area) <= 1e-11 * squares,
                "the order of discs does not matter");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const auto mask = [](unsigned bits) { return (1U << (1 + bits % 8)) - 1; };
  const unsigned coordinate = mask(data[0]), radius = mask(data[0] / 8U);
  std::vector<Whole> wholes;
  for (std::size_t at = 2; at + 4 <= size && wholes.size() < most_balls; at += 4)
    wholes.push_back(
        {data[at] & coordinate, data[at + 1] & coordinate, data[at + 2] & coordinate, data[at + 3] & radius});
  const int exponent = 2 * (static_cast<int>(data[1]) - 128);
  const double unit = std::ldexp(1, exponent);
  const Balls balls(wholes, 0), scaled(wholes, exponent);
  std::reverse(wholes.begin(), wholes.end());
  const Balls reversed(wholes, 0);

  const RegularTriangulation regular = rbpa::regular_triangulation(balls.centers, balls.radii);
  check_triangulation(balls, regular);
  check_discs(balls, reversed);
  const RegularTriangulation other = rbpa::regular_triangulation(reversed.centers, reversed.radii);
  fuzz::require(by_balls(balls, regular.simplices) == by_balls(reversed, other.simplices) &&
                    by_balls(balls, regular.flat) == by_balls(reversed, other.flat),
                "the order does not matter");

  // Tangent balls meet or part, cospherical ones as well, and no size may jump.
  std::vector<double> grown = balls.radii;
  for (double& r : grown) r *= 1 + 0x1p-30;
  const rbpa::MeasureBallsOptions options = {.derivatives = true};
  const BallMeasures found = rbpa::measure_balls(balls.centers, balls.radii, options),
                     large = rbpa::measure_balls(scaled.centers, scaled.radii, options),
                     turned = rbpa::measure_balls(reversed.centers, reversed.radii),
                     near = rbpa::measure_balls(balls.centers, grown);
  check_measures(balls, found, 1);
  check_measures(scaled, large, unit);
  const auto sum_of_powers = [&](double power) {
    double sum = 0;
    for (const double r : balls.radii) sum += std::pow(r, power);
    return sum;
  };
  const double squares = sum_of_powers(2), cubes = sum_of_powers(3);
  for (std::size_t i = 0; i < balls.radii.size(); ++i) {
    fuzz::require(found.areas[i] == large.areas[i] / unit / unit, "areas scale by powers of two");
    fuzz::require(found.volumes[i] == large.volumes[i] / unit / unit / unit, "volumes scale by powers of two");
    fuzz::require(std::abs(found.areas[i] - near.areas[i]) <= 1e-7 * squares, "areas are continuous");
    fuzz::require(std::abs(found.volumes[i] - near.volumes[i]) <= 1e-7 * cubes, "volumes are continuous");
  }
  fuzz::require(
      std::abs(found.volume - turned.volume) <= 1e-11 * cubes && std::abs(found.area - turned.area) <= 1e-11 * squares,
      "the order changes only the rounding");
  const auto differs = [&](double r) { return r != balls.radii[0]; };
  if (!balls.radii.empty() && balls.radii[0] > 0 && std::none_of(balls.radii.begin(), balls.radii.end(), differs)) {
    const rbpa::BallUnion equal = rbpa::union_of_balls(balls.centers, balls.radii[0]);
    fuzz::require(std::abs(equal.volume - found.volume) <= 1e-11 * found.volume, "one radius is a case of many");
  }
  return 0;
}
