#include "rbpa/space/balls/measure_discs.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/base/exact/double_double.h"
#include "rbpa/base/exact/exact_sum.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/run/input.h"
#include "rbpa/space/balls/full/ball_parts.h"
#include "rbpa/space/balls/full/ball_wedges.h"
#include "rbpa/space/balls/full/disc_complex.h"
#include "rbpa/space/predicate/orientation.h"

namespace rbpa {
namespace {

using space::Ball;
using space::DiscComplex;
using std::numbers::pi;
using Real = DoubleDouble;

/// Sizes at a halfedge i → j of the complex: the common chord of discs i and j, seen from i.
struct Chord {
  Chord() = default;
  Chord(const Ball& i, const Ball& j) {
    const space::BallEdge<Real> edge(i, j);
    const Real square = Real{i.radius, 0} * Real{i.radius, 0} - edge.lift * edge.lift / edge.square;
    height = edge.lift.high / std::sqrt(edge.square.high);
    half = std::sqrt(std::max(square.high, 0.0));
    x = edge.to.x.high;
    y = edge.to.y.high;
  }

  double height = 0;    // signed distance of the chord's line from center i, toward j
  double half = 0;      // half the length of the whole chord
  double x = 0, y = 0;  // direction from i to j, of any length
  double left = 0;      // signed length of the chord within both power cells, to the left of the line of centers
  /// Returns half the angle of the chord, seen from i.
  double half_angle() const { return std::atan2(half, height); }
};

std::vector<Ball> scaled(std::span<const Point3> centers, std::span<const double> radii, int exponent) {
  const auto scaled = [&](double value) { return exponent == 0 ? value : std::ldexp(value, exponent); };
  std::vector<Ball> discs;
  for (std::size_t i = 0; i < radii.size(); ++i)
    discs.push_back({{scaled(centers[i].x), scaled(centers[i].y), 0}, scaled(radii[i])});
  return discs;
}

std::vector<Point3> in_space(std::span<const Point> centers) {
  std::vector<Point3> result;
  for (const Point& p : centers) result.push_back({p.x, p.y, 0});
  return result;
}

/// ArcCorners of polygons where an arc ends and the next one begins: the same point for both sides of a touch.
class ArcCorners {
 public:
  ArcCorners(std::span<const Point> centers, std::span<const double> radii) : ArcCorners(in_space(centers), radii) {}
  /// Returns the point in which an arc of disc i ends and an arc of disc j begins. Requires: i ≠ j.
  Point between(std::uint32_t i, std::uint32_t j) const {
    const bool is_turned = i > j;
    const Ball &a = discs_[std::min(i, j)], &b = discs_[std::max(i, j)];
    const Chord chord(a, b);
    // The union is on the left of the boundary, so that the point is on the right of the line from i to j.
    const double length = std::hypot(chord.x, chord.y), left = is_turned ? chord.half : -chord.half;
    return {std::ldexp(a.center.x + (chord.height * chord.x - left * chord.y) / length, -scale_),
            std::ldexp(a.center.y + (chord.height * chord.y + left * chord.x) / length, -scale_)};
  }

 private:
  ArcCorners(const std::vector<Point3>& centers, std::span<const double> radii)
      : scale_(centers.empty() ? 0 : space::scale_exponent(centers, radii)), discs_(scaled(centers, radii, scale_)) {}
  int scale_;
  std::vector<Ball> discs_;
};

class DiscParts {
 public:
  DiscParts(std::span<const Point3> centers, std::span<const double> radii, const DiscComplex& complex, Steps& step)
      : centers_(centers),
        complex_(complex),
        step_(step),
        scale_(space::scale_exponent(centers, radii)),
        discs_(scaled(centers, radii, scale_)),
        chords_(complex.halfedges()) {}

  DiscMeasures measure() && {
    measure_chords();
    result_.areas.assign(discs_.size(), 0);
    result_.lengths.assign(discs_.size(), 0);
    for (const space::ArcCurve& curve : complex_.curves(result_.components, step_)) add(curve);
    for (std::uint32_t h = 0; h < chords_.size(); ++h)
      if (complex_.has_edge(h))
        result_.areas[complex_.from(h)] += chords_[h].height * (chords_[h].left + chords_[h ^ 1U].left) / 2;
    ExactSum area, length;
    for (std::uint32_t i = 0; i < discs_.size(); ++i) {
      step_();
      if (!complex_.has_disc(i)) result_.hidden.push_back(i);
      const double r = discs_[i].radius, angle = std::min(result_.lengths[i], 2 * pi);
      result_.areas[i] = unscaled(std::clamp(result_.areas[i] + r * r * angle / 2, 0.0, pi * r * r), 2);
      result_.lengths[i] = unscaled(r * angle, 1);
      area.add(result_.areas[i]);
      length.add(result_.lengths[i]);
    }
    result_.area = area.rounded();
    result_.length = length.rounded();
    return std::move(result_);
  }

 private:
  double unscaled(double value, int power) const { return std::ldexp(value, -power * scale_); }

  void measure_chords() {
    for (std::uint32_t h = 0; h < chords_.size(); ++h) {
      step_();
      if (!complex_.has_edge(h)) continue;
      Chord& chord = chords_[h];
      chord = {discs_[complex_.from(h)], discs_[complex_.to(h)]};
      if (h % 2 == 1) chord.half = chords_[h - 1].half;
      chord.left = complex_.has_face(h) ? std::clamp(toward_orthocenter(h), -chord.half, chord.half) : chord.half;
    }
  }

  /// Returns how far the orthocenter of the triangle on the left of h is to the left of the line of centers.
  double toward_orthocenter(std::uint32_t h) const {
    using space::BallEdge;
    const Ball &a = discs_[complex_.from(h)], &b = discs_[complex_.to(h)], &c = discs_[complex_.apex(h)];
    // Relative to a, the orthocenter x has x · to = lift for both edges from a. Both ends of h give equal results; from
    // the end nearer to c, short differences are exact.
    const auto from = [](const Ball& p, const Ball& q, const Ball& r, double side) {
      const BallEdge<Real> base(p, q), spoke(p, r);
      const Real cross = base.to.x * spoke.to.y - base.to.y * spoke.to.x;
      const Real offset = spoke.lift * base.square - dot(base.to, spoke.to) * base.lift;
      return side * (offset / cross).high / std::sqrt(base.square.high);
    };
    const auto square = [](const Ball& p, const Ball& q) {
      const double x = p.center.x - q.center.x, y = p.center.y - q.center.y;
      return x * x + y * y;
    };
    return square(b, c) < square(a, c) ? from(b, a, c, -1) : from(a, b, c, 1);
  }

  /// Returns the angle counter-clockwise from halfedge g to halfedge h, which begin at one disc.
  double turn(std::uint32_t g, std::uint32_t h) const {
    if (g == h) return 2 * pi;
    const Chord &from = chords_[g], &to = chords_[h];
    const int side =
        space::orientation_along(centers_[complex_.from(g)], centers_[complex_.to(g)], centers_[complex_.to(h)], 2);
    if (side == 0) return pi;
    const double angle = std::atan2(std::abs(from.x * to.y - from.y * to.x), from.x * to.x + from.y * to.y);
    return side > 0 ? angle : 2 * pi - angle;
  }

  /// Adds a curve to the boundary, and the angles of its arcs to the discs.
  void add(const space::ArcCurve& of) {
    DiscCurve& curve = result_.boundary.emplace_back();
    curve.component = of.component;
    curve.is_hole = of.is_hole;
    if (of.halfedges.empty()) curve.arcs.push_back({of.disc, 0, 2 * pi});
    for (const std::uint32_t h : of.halfedges) {
      step_();
      const std::uint32_t next = complex_.next_around(h);
      const double half = chords_[h].half_angle(), begin = std::atan2(chords_[h].y, chords_[h].x) + half;
      const double angle =
          complex_.is_point_after(h) ? 0 : std::clamp(turn(h, next) - half - chords_[next].half_angle(), 0.0, 2 * pi);
      curve.arcs.push_back({complex_.from(h), begin > pi ? begin - 2 * pi : begin, angle});
    }
    // By Green's theorem, with coordinates relative to the first disc.
    const Point3& origin = discs_[of.disc].center;
    for (const auto& [i, begin, angle] : curve.arcs) {
      const auto& [center, r] = discs_[i];
      const double end = begin + angle;
      result_.lengths[i] += angle;  // an angle until measure() multiplies it by the radius
      curve.length += r * angle;
      curve.area += r *
                    ((center.x - origin.x) * (std::sin(end) - std::sin(begin)) -
                     (center.y - origin.y) * (std::cos(end) - std::cos(begin)) + r * angle) /
                    2;
    }
    curve.length = unscaled(curve.length, 1);
    curve.area = unscaled(curve.is_hole ? std::min(curve.area, 0.0) : std::max(curve.area, 0.0), 2);
  }

  std::span<const Point3> centers_;
  const DiscComplex& complex_;
  Steps& step_;
  int scale_;
  std::vector<Ball> discs_;    // scaled
  std::vector<Chord> chords_;  // of each halfedge of the complex
  DiscMeasures result_ = {};
};

/// Returns whether the corners of a ring are as near to each other as rounding may move them, or fewer than three.
bool is_collapsed(std::span<const Point> corners) {
  if (corners.size() < 3) return true;
  Point low = corners[0], high = low;
  for (const Point& p : corners) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double farthest = std::max({std::abs(low.x), std::abs(low.y), std::abs(high.x), std::abs(high.y)});
  return std::max(high.x - low.x, high.y - low.y) <= 0x1p-44 * farthest;
}

}  // namespace

DiscMeasures measure_discs(std::span<const Point> centers, std::span<const double> radii,
                           const MeasureDiscsOptions& options) {
  for (std::size_t i = 0; i < centers.size(); ++i)
    if (const Point& p = centers[i]; !is_finite(p))
      throw InvalidInput("center " + std::to_string(i) + " is (" + text(p.x) + ", " + text(p.y) +
                         "), expected finite coordinates");
  const std::vector<Point3> all = in_space(centers);
  const RegularTriangulation regular =
      regular_triangulation(all, radii, {.neighbors = false, .threads = options.threads, .progress = options.progress});
  if (centers.empty()) return {};
  const GoOn go_on = go_on_of(options.progress, centers.size());
  Steps step(go_on);
  const DiscComplex complex(all, radii, regular, step);
  return DiscParts(all, radii, complex, step).measure();
}

DiscPolygons disc_polygons(const DiscMeasures& measures, std::span<const Point> centers, std::span<const double> radii,
                           unsigned corners, const GoOn& go_on) {
  meshops::require_one_each("disc_polygons", radii.size(), "radii", centers.size(), "centers");
  meshops::require(corners >= 3, "disc_polygons: fewer than three corners");
  Steps step(go_on);
  const ArcCorners common(centers, radii);
  DiscPolygons result;
  std::vector<Point>& points = result.points;
  ExactSum area, perimeter;  // of the current polygon
  bool is_dropped = false;   // the outer curve of the current component is
  const auto less = [&](const Ring& a, const Ring& b) {
    return std::pair(points[a.points[0]], points[a.points[1]]) < std::pair(points[b.points[0]], points[b.points[1]]);
  };
  const auto finish = [&] {
    if (result.polygons.empty()) return;
    Polygon& polygon = result.polygons.back();
    std::sort(polygon.holes.begin(), polygon.holes.end(), less);
    polygon.area = area.rounded(-1);
    polygon.perimeter = perimeter.rounded();
  };
  for (const DiscCurve& curve : measures.boundary) {
    if (curve.is_hole && is_dropped) continue;
    const std::size_t first = points.size();
    std::uint32_t before = curve.arcs.back().disc;
    for (const auto& [i, begin, angle] : curve.arcs) {
      meshops::require(std::max(i, before) < centers.size(), "disc_polygons: the measures are of more discs");
      const auto steps = static_cast<unsigned>(std::max(std::ceil(angle * corners / (2 * pi) - 1e-9), 1.0));
      for (unsigned k = 0; k < steps; ++k) {
        step(2);
        const double at = begin + angle * k / steps;
        Point p = {centers[i].x + radii[i] * std::cos(at), centers[i].y + radii[i] * std::sin(at)};
        if (k == 0 && before != i) p = common.between(before, i);
        if (points.size() == first || p != points.back()) points.push_back(p);
      }
      before = i;
    }
    if (points.size() > first + 1 && points.back() == points[first]) points.pop_back();
    meshops::require(points.size() < DiscMeasures::none, "disc_polygons: more than 2^32 corners");
    if (is_collapsed(std::span(points).subspan(first))) {
      points.resize(first);
      is_dropped = is_dropped || !curve.is_hole;
      continue;
    }
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(first);
    std::rotate(begin, std::min_element(begin, points.end()), points.end());
    Ring ring;
    if (!curve.is_hole) {
      is_dropped = false;
      finish();
      area = perimeter = {};
      result.polygons.emplace_back();
      result.components.push_back(curve.component);
    }
    for (std::size_t k = first; k < points.size(); ++k) {
      ring.points.push_back(static_cast<std::uint32_t>(k));
      const Point &p = points[k], &q = points[k + 1 < points.size() ? k + 1 : first];
      area.add_product(p.x, q.y);
      area.add_product(-p.y, q.x);
      perimeter.add(std::hypot(q.x - p.x, q.y - p.y));
    }
    if (curve.is_hole)
      result.polygons.back().holes.push_back(std::move(ring));
    else
      result.polygons.back().shell = std::move(ring);
  }
  finish();
  return result;
}

}  // namespace rbpa
