#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "drawings/canvas.h"
#include "drawings/figures.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/predicate/ball.h"
#include "rbpa/space/surface/star/free_region-inl.h"
#include "rbpa/space/surface/star/neighbor.h"

namespace figures {
namespace {

using rbpa::Point3;
using rbpa::space::minus;
using rbpa::space::Neighbor;
using rbpa::space::plus;
using rbpa::space::scaled;
using Vector = rbpa::space::Vector3<double>;
using rbpa::space::HWY_NAMESPACE::FreeRegion;

/// Returns a point in a direction from v, which is at the origin, whose cap reaches `degrees` from that direction, for
/// a ball of radius 1.
Point3 point_with_cap(Vector direction, double degrees) {
  const double length = 2 * std::cos(degrees * std::numbers::pi / 180) / std::sqrt(dot(direction, direction));
  return {direction.x * length, direction.y * length, direction.z * length};
}

Vector vector_of(const Point3& p) { return {p.x, p.y, p.z}; }

/// Returns the center of the ball on (v, x, y).
Vector center_on(const Vector& x, const Vector& y) {
  const Vector n = cross(x, y), w = minus(x, y);
  const double nn = dot(n, n), xx = dot(x, x), yy = dot(y, y), rise = std::sqrt(4 * nn - xx * yy * dot(w, w));
  const Vector sum = plus(plus(scaled(cross(y, n), xx), scaled(cross(n, x), yy)), scaled(n, rise));
  return scaled(sum, 0.5 / nn);
}

/// Returns places on the circle of x, counter-clockwise from one point to another; equal points stand for the whole
/// circle.
std::vector<Vector> circle_of(const Vector& x, const Vector& from, const Vector& to) {
  const Vector middle = scaled(x, 0.5), u = minus(from, middle), end = minus(to, middle),
               v = scaled(cross(x, u), 1 / std::sqrt(dot(x, x)));
  double angle = std::atan2(dot(end, v), dot(end, u));
  if (angle < 1e-9) angle += 2 * std::numbers::pi;
  std::vector<Vector> places;
  constexpr int steps = 60;
  for (int i = 0; i <= steps; ++i) {
    const double a = angle * i / steps;
    places.push_back(plus(middle, plus(scaled(u, std::cos(a)), scaled(v, std::sin(a)))));
  }
  return places;
}

std::vector<Vector> circle_of(const Vector& x) {
  const Vector across = cross(x, {0, 0, 1}), middle = scaled(x, 0.5);
  const Vector from = plus(middle, scaled(across, std::sqrt((1 - dot(x, x) / 4) / dot(across, across))));
  return circle_of(x, from, from);
}

/// The part of the sphere outside the caps of all points, as FreeRegion computes it.
struct Region {
  std::vector<Vector> corners;
  std::vector<std::vector<Vector>> arcs;
  std::size_t cycles = 0, caps = 0;
};

Region region_without(std::span<const Point3> points) {
  const Point3 v = {0, 0, 0};
  FreeRegion region;
  region.reset(1);
  const auto is_in_ball = [&](std::size_t x, std::size_t y, std::size_t p) {
    return rbpa::space::Ball<double>(v, points[x], points[y], 1).contains(points[p]);
  };
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!region.subtract(Neighbor::seen_from(v, points[i], i), is_in_ball))
      throw std::logic_error("the free region that is drawn is lost");
  Region drawn;
  drawn.caps = region.caps();
  std::vector<Vector> cycle;
  region.for_each_cycle([&](std::uint32_t site) { cycle.push_back(vector_of(points[site])); },
                        [&] {
                          const std::size_t size = cycle.size();
                          for (std::size_t k = 0; k < size; ++k) {
                            const Vector &y = cycle[(k + size - 1) % size], &x = cycle[k], &z = cycle[(k + 1) % size];
                            drawn.corners.push_back(center_on(x, y));
                            drawn.arcs.push_back(circle_of(x, center_on(x, y), center_on(z, x)));
                          }
                          ++drawn.cycles;
                          cycle.clear();
                        });
  return drawn;
}

/// View of the sphere of centers, from above.
class View {
 public:
  View(Canvas& canvas, Place middle) : canvas_(canvas), middle_(middle) {
    canvas_.region({seen(rim())}, color::face);
    canvas_.circle(middle_, radius, {color::inner, 1});
  }

  void heading(const std::string& words, const std::string& caption) {
    canvas_.text(middle_ + Place{0, -radius - 16}, words, Lettering::plain, Align::middle);
    canvas_.text(middle_ + Place{0, radius + 24}, caption, Lettering::small, Align::middle);
  }
  void cap(const Point3& p, std::string_view fill) { canvas_.region({seen(circle_of(vector_of(p)))}, fill); }
  void circle(const Point3& p, const Stroke& stroke) { canvas_.closed_lines({seen(circle_of(vector_of(p)))}, stroke); }
  void name(const Point3& p, const std::string& name) {
    const Vector at = vector_of(p);
    canvas_.text(place(scaled(at, 1 / std::sqrt(dot(at, at)))) + Place{0, 4}, name, Lettering::italic, Align::middle);
  }
  void boundary(const Region& region) {
    for (const auto& arc : region.arcs) {
      const std::vector<Place> places = seen(arc);
      std::vector<Segment> segments;
      for (std::size_t i = 1; i < places.size(); ++i) segments.push_back({places[i - 1], places[i], {}});
      canvas_.segments(segments, {color::curve, 2.4});
    }
  }
  void corners(const std::vector<Vector>& corners, std::string_view fill) {
    for (const Vector& corner : corners) canvas_.dot(place(corner), 3.6, fill);
  }

  static constexpr double radius = 112;

 private:
  static std::vector<Vector> rim() {
    std::vector<Vector> places;
    for (int degrees = 0; degrees < 360; degrees += 3) {
      const Place at = polar(degrees, 1);
      places.push_back({at.x, at.y, 0});
    }
    return places;
  }
  Place place(const Vector& c) const { return middle_ + Place{radius * c.x, -radius * c.y}; }
  std::vector<Place> seen(const std::vector<Vector>& all) const {
    std::vector<Place> places;
    for (const Vector& c : all) places.push_back(place(c));
    return places;
  }

  Canvas& canvas_;
  Place middle_;
};

void require(bool holds) {
  if (!holds) throw std::logic_error("the free region that is drawn is not the one that is meant");
}

std::string free_region() {
  const Point3 p = point_with_cap({-0.36, 0.2, 0.9}, 33), q = point_with_cap({0.34, 0.3, 0.9}, 31),
               x = point_with_cap({-0.42, -0.42, 0.8}, 22), w = point_with_cap({0.5, -0.55, 0.67}, 17);
  const std::vector<Point3> two = {p, q}, three = {p, q, x}, four = {p, q, x, w};
  const Region crossed = region_without(two), bitten = region_without(three), waiting = region_without(four);
  require(crossed.corners.size() == 2 && crossed.cycles == 1);
  require(bitten.corners.size() == 4 && bitten.cycles == 1);
  require(waiting.corners.size() == 4 && waiting.caps == bitten.caps);

  Canvas canvas;
  constexpr double width = 270, y = 142;
  View first(canvas, {width / 2, y});
  first.heading("(a) two caps", "two corners, two arcs");
  first.cap(p, color::pale);
  first.cap(q, color::pale);
  for (const Point3& of : two) first.circle(of, {color::inner, 0.8, true});
  first.boundary(crossed);
  first.corners(crossed.corners, color::text);
  first.name(p, "p");
  first.name(q, "q");

  View second(canvas, {1.5 * width, y});
  second.heading("(b) x bites the arc about p", "two corners more, and an arc about x");
  second.cap(p, color::pale);
  second.cap(q, color::pale);
  second.cap(x, color::touched_face);
  for (const Point3& of : three) second.circle(of, {color::inner, 0.8, true});
  second.boundary(bitten);
  second.corners(bitten.corners, color::touched);
  second.corners(crossed.corners, color::text);
  second.name(p, "p");
  second.name(q, "q");
  second.name(x, "x");

  View third(canvas, {2.5 * width, y});
  third.heading("(c) the circle of w waits", "it crosses no arc, and no cap covers it");
  for (const Point3& of : three) third.cap(of, color::pale);
  for (const Point3& of : three) third.circle(of, {color::inner, 0.8, true});
  third.boundary(waiting);
  third.corners(waiting.corners, color::text);
  third.circle(w, {color::touched, 1.8, true});
  third.name(p, "p");
  third.name(q, "q");
  third.name(x, "x");
  third.name(w, "w");
  return canvas.svg("The free region of a point, without the caps of two, three and four others",
                    static_cast<int>(3 * width), 292);
}

}  // namespace

std::span<const Figure> free_region_figures() {
  static constexpr std::array figures = {Figure{"free_region", free_region}};
  return figures;
}

}  // namespace figures
