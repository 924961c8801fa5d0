#include "rbpa/space/balls/full/slices.h"

#include <algorithm>
#include <cmath>

#include "rbpa/base/arrays/sort_unique.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {
namespace {

constexpr std::uint32_t none = 0xffffffff;
using Vector = Vector3<double>;

/// Returns p + t v.
Vector moved(const Vector& p, double t, const Vector& v) { return {p.x + t * v.x, p.y + t * v.y, p.z + t * v.z}; }

/// A corner of a convex polygon, and the cell beyond the side that begins at it.
struct Corner {
  Vector at;
  std::uint32_t beyond;
};
using Polygon = std::vector<Corner>;

/// Cuts off the part of a polygon where height(point) is above 0. The cell `beyond` is beyond the new side.
template <typename Height>
void cut(Polygon& polygon, const Height& height, std::uint32_t beyond, Polygon& copy) {
  copy.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double h = height(from.at), next = height(to.at);
    if (h <= 0) copy.push_back(from);
    if ((h <= 0) == (next <= 0)) continue;
    copy.push_back({moved(from.at, h / (h - next), minus(to.at, from.at)), h <= 0 ? beyond : from.beyond});
  }
  polygon.swap(copy);
}

/// The part of a disc around the origin that is in a polygon, in the plane perpendicular to the normal.
struct Covered {
  Vector normal;
  double square;               // square of the disc's radius
  double area = 0, angle = 0;  // angle: sum over the arcs within the polygon

  void add_side(const Vector& from, const Vector& to) {
    const Vector along = minus(to, from);
    const double a = dot(along, along), b = dot(from, along), discriminant = b * b - a * (dot(from, from) - square);
    const double root = std::sqrt(std::max(discriminant, 0.0)), enter = (-b - root) / a, leave = (-b + root) / a;
    if (!(discriminant > 0 && enter < 1 && leave > 0)) return add_sector(from, to);
    const Vector first = enter > 0 ? moved(from, enter, along) : from,
                 last = leave < 1 ? moved(from, leave, along) : to;
    if (enter > 0) add_sector(from, first);
    area += dot(cross(first, last), normal) / 2;
    if (leave < 1) add_sector(last, to);
  }

 private:
  void add_sector(const Vector& from, const Vector& to) {
    const double turn = std::atan2(dot(cross(from, to), normal), dot(from, to));
    angle += turn;
    area += turn * square / 2;
  }
};

}  // namespace

double PowerCells::power(const Point3& x, std::uint32_t i) const {
  const double d = distance(x, balls[i].center);
  return (d - balls[i].radius) * (d + balls[i].radius);
}

std::uint32_t PowerCells::ball_at(const Point3& x, std::uint32_t start) const {
  double least = power(x, start);
  for (std::uint32_t found = start;; start = found) {
    for (const std::uint32_t t : stars[start])
      for (const std::uint32_t i : simplices[t])
        if (const double other = power(x, i); other < least) {
          least = other;
          found = i;
        }
    if (found == start) return found;
  }
}

Slice PowerCells::slice(const Triangle& corners) const {
  const Point3& origin = balls[corners[0]].center;
  const Vector u = from<double>(origin, balls[corners[1]].center), v = from<double>(origin, balls[corners[2]].center);
  const Vector up = cross(u, v);
  const double twice_area = std::sqrt(dot(up, up));
  if (!(twice_area > 0x1p-400)) return {};
  const Polygon whole = {{{0, 0, 0}, none}, {u, none}, {v, none}};
  Slice slice{twice_area / 2, twice_area / 2, 0};
  const Point3 middle = {origin.x + (u.x + v.x) / 3, origin.y + (u.y + v.y) / 3, origin.z + (u.z + v.z) / 3};
  // The search starts from several cells, as rounding may choose one that only touches the triangle.
  std::vector<std::uint32_t> found = {corners[0], corners[1], corners[2], ball_at(middle, corners[0])}, neighbors;
  sort_unique(found);
  Polygon polygon, copy;
  for (std::size_t next = 0; next < found.size(); ++next) {
    const auto& [own, radius] = balls[found[next]];
    const Vector center = from<double>(origin, own);
    neighbors.clear();
    for (const std::uint32_t t : stars[found[next]])
      neighbors.insert(neighbors.end(), simplices[t].begin(), simplices[t].end());
    sort_unique(neighbors);
    polygon = whole;
    for (const std::uint32_t j : neighbors) {
      if (j == found[next]) continue;
      const Vector to = from<double>(own, balls[j].center);
      const double weights = (radius - balls[j].radius) * (radius + balls[j].radius);
      const double lift = dot(to, center) + (dot(to, to) + weights) / 2;
      cut(
          polygon, [&](const Vector& p) { return dot(p, to) - lift; }, j, copy);
    }
    const double height = dot(center, up) / twice_area;
    const Vector foot = moved(center, -height / twice_area, up);
    Covered covered{moved({0, 0, 0}, 1 / twice_area, up), (radius - height) * (radius + height)};
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const auto& [at, beyond] = polygon[k];
      if (covered.square > 0) covered.add_side(minus(at, foot), minus(polygon[(k + 1) % polygon.size()].at, foot));
      if (beyond != none && std::find(found.begin(), found.end(), beyond) == found.end()) found.push_back(beyond);
    }
    slice.outside -= covered.area;
    slice.perimeter += std::sqrt(std::max(covered.square, 0.0)) * covered.angle;
  }
  return {slice.area, std::max(slice.outside, 0.0), std::max(slice.perimeter, 0.0)};
}

}  // namespace rbpa::space
