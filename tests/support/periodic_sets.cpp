#include "support/periodic_sets.h"

#include <cmath>

namespace rbpa_test {
namespace {

using rbpa::Point3;

Point3 uniform(const Point3& box, Random& random) {
  return {box.x * random.unit(), box.y * random.unit(), box.z * random.unit()};
}

/// Returns a point whose coordinates are multiples of a part of the sides.
Point3 on_lattice(const Point3& box, int along, Random& random) {
  const auto at = [&](double side) { return side / along * random.integer(0, along - 1); };
  return {at(box.x), at(box.y), at(box.z)};
}

double modulo(double x, double side, double rounded_side) {
  double result = std::fmod(x, side);
  if (result < 0) result += side;
  const double step = std::ldexp(1.0, std::ilogb(side) + 1 - 51);
  result = std::nearbyint(result / step) * step;
  return result < rounded_side ? result + 0.0 : result - rounded_side;
}

}  // namespace

PeriodicSet periodic_set(std::uint64_t kind, std::size_t count, Random& random) {
  PeriodicSet set;
  // Sides with few bits are not rounded.
  const auto side = [&] { return static_cast<double>(random.integer(8, 16)); };
  set.box = {side(), side(), side()};
  const auto fill = [&](auto make) {
    for (std::size_t i = 0; i < count; ++i) set.points.push_back(make());
  };
  switch (kind % periodic_kinds) {
    case 0:
      set.name = "uniform";
      fill([&] { return uniform(set.box, random); });
      break;
    case 1:
      set.name = "lattice with vacancies";
      set.box = {4, 4, 4};
      fill([&] { return on_lattice(set.box, 4, random); });
      break;
    case 2:
      set.name = "lattice in a box of three lengths";
      set.box = {4, 8, 6};
      fill([&] {
        return Point3{double(random.integer(0, 3)), double(random.integer(0, 7)), double(random.integer(0, 5))};
      });
      break;
    case 3: {
      set.name = "body-centered";
      set.box = {4, 4, 4};
      fill([&] {
        const Point3 p = on_lattice(set.box, 4, random);
        return random.chance(0.5) ? p : Point3{p.x + 0.5, p.y + 0.5, p.z + 0.5};
      });
      break;
    }
    case 4:
      set.name = "layer";
      fill([&] {
        Point3 p = uniform(set.box, random);
        p.z /= 4;
        return p;
      });
      break;
    case 5:
      set.name = "rod";
      fill([&] {
        Point3 p = uniform(set.box, random);
        p.y = set.box.y - 1 + p.y / 8;
        p.z /= 4;
        return p;
      });
      break;
    case 6:
      set.name = "near the sides";
      fill([&] {
        Point3 p = uniform(set.box, random);
        double& x = random.chance(0.5) ? p.x : p.y;
        x = random.chance(0.5) ? 0 : std::ldexp(random.unit(), -random.integer(1, 60));
        if (random.chance(0.5)) p.z = set.box.z - std::ldexp(random.unit(), -random.integer(1, 49));
        return p;
      });
      break;
    case 7:
      set.name = "outside, with duplicates";
      fill([&] {
        Point3 p = random.chance(0.3) && !set.points.empty() ? set.points[random.below(set.points.size())]
                                                             : on_lattice(set.box, 32, random);
        p.x += set.box.x * random.integer(-3, 3);
        p.y += set.box.y * random.integer(-3, 3);
        return p;
      });
      break;
    default:
      set.name = "sides of all bits";
      set.box = {set.box.x / 3, set.box.y / 3, set.box.z / 3};
      fill([&] { return uniform(set.box, random); });
  }
  return set;
}

std::vector<PeriodicCorners> rows_of(const rbpa::PeriodicSolid& solid) {
  std::vector<PeriodicCorners> rows;
  for (const auto& row : solid.simplices)
    rows.push_back({solid.vertices[row[0]], solid.vertices[row[1]], solid.vertices[row[2]], solid.vertices[row[3]]});
  return rows;
}

AllImages all_images(const Points3& in_box, const Point3& box) {
  AllImages all;
  for (std::uint32_t i = 0; i < in_box.size(); ++i)
    for (std::int8_t x = -1; x <= 1; ++x)
      for (std::int8_t y = -1; y <= 1; ++y)
        for (std::int8_t z = -1; z <= 1; ++z) {
          all.vertices.push_back({i, {x, y, z}});
          all.positions.push_back({in_box[i].x + x * box.x, in_box[i].y + y * box.y, in_box[i].z + z * box.z});
        }
  return all;
}

Points3 wrapped(const PeriodicSet& set, const Point3& box) {
  Points3 result;
  for (const Point3& p : set.points)
    result.push_back({modulo(p.x, set.box.x, box.x), modulo(p.y, set.box.y, box.y), modulo(p.z, set.box.z, box.z)});
  return result;
}

}  // namespace rbpa_test
