#include "rbpa/space/simplify/distance/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace rbpa::space {
namespace {

using Vector = Vector3<double>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int most_cuts = 96;  // maximum number of cuts in a row; slack() relies on it

double squared(const Vector& v) { return dot(v, v); }
Point3 point(const Vector& v) { return {v.x, v.y, v.z}; }

/// Returns the greatest amount that rounding adds to a distance between points of local coordinates up to `size`.
double slack(double size) { return std::ldexp(std::max(size, 1.0), -43); }

/// Returns the greatest absolute coordinate; infinity if products of coordinates could overflow.
double size_of(const std::array<Vector, 3>& corners) {
  const double most = std::ldexp(1.0, 200);
  double size = 0;
  for (const Vector& v : corners)
    for (const double coordinate : {v.x, v.y, v.z})
      size = std::abs(coordinate) <= most ? std::max(size, std::abs(coordinate)) : infinity;
  return size;
}

}  // namespace

/// A convex polygon, with the number of cuts that led to it.
struct SurfaceDistance::Piece {
  static constexpr std::size_t most = 12;
  std::array<Vector, most> corners;
  std::size_t count = 0;
  int cuts = 0;

  void add(const Vector& v) { corners[count++] = v; }
  Vector middle() const {
    Vector sum = corners[0];
    for (std::size_t i = 1; i < count; ++i) sum = plus(sum, corners[i]);
    return times(1 / static_cast<double>(count), sum);
  }
  const Vector& operator[](std::size_t i) const { return corners[i % count]; }

  /// Returns part of a cut: the corners number i through j, between the corners `first` and `last`.
  Piece part(std::size_t i, std::size_t j, const Vector& first, const Vector& last) const {
    Piece part{.corners = {}, .count = 0, .cuts = cuts + 1};
    part.add(first);
    for (; i % count != (j + 1) % count; ++i) part.add((*this)[i]);
    part.add(last);
    return part;
  }

  /// Cuts off the part beyond the plane through `on`, on the side to which `out` points. Returns that part, and keeps
  /// the rest. Returns nothing, and keeps all, if no part is beyond the plane or rounding leaves no simple cut.
  std::optional<Piece> cut_off(const Vector& on, const Vector& out) {
    // A part that is thinner than rounding is not cut off: the remaining piece could be the same again and again.
    const double thin = std::ldexp(std::sqrt(squared(out)), -45);
    std::array<double, most> height{};
    std::size_t enters = most, leaves = most, changes = 0;
    double lowest = infinity, highest = -infinity;
    for (std::size_t i = 0; i < count; ++i) {
      height[i] = dot(minus(corners[i], on), out);
      lowest = std::min(lowest, height[i]);
      highest = std::max(highest, height[i]);
    }
    if (!(highest > thin) || count + 1 >= most) return std::nullopt;
    if (lowest >= -thin) {
      const Piece all = *this;
      count = 0;
      return all;
    }
    for (std::size_t i = 0; i < count; ++i) {
      const bool now = height[i] > 0, then = height[(i + 1) % count] > 0;
      changes += now != then;
      if (!now && then) enters = i;
      if (now && !then) leaves = i;
    }
    if (changes != 2) return std::nullopt;
    const auto crossing = [&](std::size_t i) {
      const double h = height[i], g = height[(i + 1) % count];
      const double t = std::clamp(h / (h - g), 0.0, 1.0);
      return plus(corners[i], times(t, minus((*this)[i + 1], corners[i])));
    };
    const Vector in = crossing(enters), back = crossing(leaves);
    const Piece off = part(enters + 1, leaves, in, back);
    *this = part(leaves + 1, enters, back, in);
    return off;
  }

  /// Cuts the piece in two, from the middle of its longest side to a corner across from it.
  std::array<Piece, 2> halves() const {
    std::size_t longest = 0;
    double most_squared = -1;
    for (std::size_t i = 0; i < count; ++i)
      if (const double length = squared(minus((*this)[i + 1], corners[i])); length > most_squared) {
        most_squared = length;
        longest = i;
      }
    const Vector middle = plus(corners[longest], times(0.5, minus((*this)[longest + 1], corners[longest])));
    const std::size_t across = longest + 1 + count / 2;
    std::array<Piece, 2> halves;
    for (Piece& half : halves) half.cuts = cuts + 1;
    halves[0].add(middle);
    for (std::size_t i = longest + 1; i <= across; ++i) halves[0].add((*this)[i]);
    halves[1].add(middle);
    for (std::size_t i = across; i <= longest + count; ++i) halves[1].add((*this)[i]);
    return halves;
  }
};

/// Bounds the distance of one triangle piece by piece.
class SurfaceDistance::Bounding {
 public:
  explicit Bounding(const SurfaceDistance& all, const std::array<Vector, 3>& corners) : all_(all) {
    Piece whole;
    for (const Vector& v : corners) whole.add(v);
    waiting_.push_back(whole);
  }

  /// Returns whether all pieces are certified to be within `limit`.
  bool is_within(double limit) {
    while (!waiting_.empty()) {
      Piece piece = waiting_.back();
      waiting_.pop_back();
      const auto near = all_.nearest(piece.middle(), limit * limit);
      if (!near || piece.cuts > most_cuts - 4) return false;
      if (!(greatest(piece, near->number) <= limit)) divide(piece, near->number, limit);
    }
    return true;
  }

  /// Returns a bound for all pieces. Unless the work reaches its limit, the bound exceeds the greatest distance, or
  /// `least` if that is more, by at most a twentieth.
  double bound(double least) {
    double bound = 0;
    for (std::size_t work = 0; !waiting_.empty(); ++work) {
      Piece piece = waiting_.back();
      waiting_.pop_back();
      const auto near = all_.nearest(piece.middle(), infinity);
      if (!near) return infinity;
      least = std::max(least, std::sqrt(near->squared));
      const double greatest_of_piece = greatest(piece, near->number), allowed = std::max(1.05 * least, slack(1));
      if (greatest_of_piece <= allowed || piece.cuts > most_cuts - 4 || work > most_work)
        bound = std::max(bound, greatest_of_piece);
      else
        bound = std::max(bound, divide(piece, near->number, allowed));
    }
    return bound;
  }

 private:
  static constexpr std::size_t most_work = 100'000;

  /// Returns the greatest distance of the piece's corners from a given triangle.
  double greatest(const Piece& piece, std::uint32_t number) const {
    double greatest = 0;
    for (std::size_t i = 0; i < piece.count; ++i)
      greatest = std::max(greatest, all_.squared_distance(piece.corners[i], number));
    return std::sqrt(greatest);
  }

  /// Cuts the piece along the prism on a given triangle. Pieces that are not within `allowed` of the triangle wait.
  /// Returns the bound of the piece that is within, or 0.
  double divide(Piece& piece, std::uint32_t number, double allowed) {
    const Given& given = all_.given_[number];
    const Vector normal = cross(given.ab, given.ac);
    const Vector b = plus(given.a, given.ab), c = plus(given.a, given.ac);
    const std::array<std::array<Vector, 2>, 3> sides = {
        {{given.a, given.ab}, {b, minus(given.ac, given.ab)}, {c, times(-1, given.ac)}}};
    bool is_cut = false;
    for (const auto& [from, along] : sides) {
      if (piece.count == 0) break;
      if (const auto off = piece.cut_off(from, cross(along, normal))) {
        is_cut = is_cut || piece.count > 0;
        waiting_.push_back(*off);
      }
    }
    if (piece.count > 0) {
      const double bound = greatest(piece, number);
      if (bound <= allowed) return bound;
      waiting_.push_back(piece);
    }
    if (!is_cut) halve();
    return 0;
  }

  /// Replaces the piece that waits last by its halves.
  void halve() {
    const std::array<Piece, 2> halves = waiting_.back().halves();
    waiting_.back() = halves[0];
    waiting_.push_back(halves[1]);
  }

  const SurfaceDistance& all_;
  std::vector<Piece> waiting_;
};

SurfaceDistance::SurfaceDistance(std::span<const Point3> points,
                                 std::span<const std::array<std::uint32_t, 3>> triangles, const meshops::GoOn& go_on) {
  meshops::Steps step(go_on);
  const auto places_of = [&](const std::array<std::uint32_t, 3>& t) {
    return Corners{points[t[0]], points[t[1]], points[t[2]]};
  };
  Box box;
  for (const auto& triangle : triangles) {
    step();
    auto& corners = corners_.emplace_back(triangle);
    const auto before = [&](std::uint32_t a, std::uint32_t b) { return points[a] < points[b]; };
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), before), corners.end());
    box.include(box_of(places_of(corners)));
  }
  std::sort(corners_.begin(), corners_.end(), [&](const auto& s, const auto& t) {
    step();
    return places_of(s) < places_of(t);
  });
  if (!corners_.empty()) {
    const auto middle = [](double low, double high) { return low / 2 + high / 2; };
    center_ = {middle(box.low.x, box.high.x), middle(box.low.y, box.high.y), middle(box.low.z, box.high.z)};
    const double size =
        std::max({box.high.x / 2 - box.low.x / 2, box.high.y / 2 - box.low.y / 2, box.high.z / 2 - box.low.z / 2});
    if (size > 0) scale_ = std::ldexp(1.0, std::clamp(-std::ilogb(size) - 1, -1020, 1020));
  }
  std::vector<Box> boxes;
  for (const auto& corners : corners_) {
    step();
    const std::array<Vector, 3> at = local(places_of(corners));
    given_.push_back({at[0], minus(at[1], at[0]), minus(at[2], at[0])});
    boxes.push_back(box_of(std::array{point(at[0]), point(at[1]), point(at[2])}));
  }
  tree_ = BoxTree(boxes, step);
}

Vector SurfaceDistance::local(const Point3& p) const {
  return {(p.x - center_.x) * scale_, (p.y - center_.y) * scale_, (p.z - center_.z) * scale_};
}

std::array<Vector, 3> SurfaceDistance::local(const Corners& triangle) const {
  return {local(triangle[0]), local(triangle[1]), local(triangle[2])};
}

/// Returns the vector to p from a point of the given triangle: from the nearest point, up to rounding (Ericson,
/// Real-time collision detection, 5.1.5).
SurfaceDistance::FromNearest SurfaceDistance::from_nearest(const Vector& p, std::uint32_t number) const {
  const Given& given = given_[number];
  const Vector ap = minus(p, given.a), ab = given.ab, ac = given.ac;
  const auto at = [&](double s, double t) { return FromNearest{minus(ap, plus(times(s, ab), times(t, ac))), s, t}; };
  const auto share = [](double part, double whole) { return whole > 0 ? std::clamp(part / whole, 0.0, 1.0) : 0.0; };
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return {ap, 0, 0};
  const double bb = dot(ab, ab), cc = dot(ac, ac), bc = dot(ab, ac);
  const double d3 = d1 - bb, d4 = d2 - bc, d5 = d1 - bc, d6 = d2 - cc;
  if (d3 >= 0 && d4 <= d3) return at(1, 0);
  if (d6 >= 0 && d5 <= d6) return at(0, 1);
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return at(share(d1, bb), 0);
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return at(0, share(d2, cc));
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double w = share(d4 - d3, (d4 - d3) + (d5 - d6));
    return at(1 - w, w);
  }
  // Finds the foot on the plane, and corrects it once for rounding, as triangles may be thin.
  double s = share(vb, va + vb + vc), t = share(vc, va + vb + vc);
  const Vector rest = minus(ap, plus(times(s, ab), times(t, ac)));
  const double r1 = dot(ab, rest), r2 = dot(ac, rest), whole = bb * cc - bc * bc;
  if (whole > 0) {
    s = std::clamp(s + (cc * r1 - bc * r2) / whole, 0.0, 1.0);
    t = std::max(t + (bb * r2 - bc * r1) / whole, 0.0);
  }
  return at(s, std::min(t, 1 - s));
}

double SurfaceDistance::squared_distance(const Vector& p, std::uint32_t number) const {
  return squared(from_nearest(p, number).away);
}

std::optional<SurfaceDistance::Nearest> SurfaceDistance::nearest(const Vector& p, double most_squared) const {
  const auto found = tree_.nearest(point(p), most_squared, [&](std::uint32_t i) { return squared_distance(p, i); });
  return found ? std::optional(Nearest{found->first, found->second}) : std::nullopt;
}

std::optional<SurfaceDistance::Foot> SurfaceDistance::nearest_point(const Point3& p, double limit,
                                                                    const std::optional<Vector>& facing) const {
  const Vector at = local(p);
  const double most = limit * scale_;
  const auto found = tree_.nearest(point(at), most * most, [&](std::uint32_t i) {
    const bool faces = !facing || dot(cross(given_[i].ab, given_[i].ac), *facing) > 0;
    return faces ? squared_distance(at, i) : std::numeric_limits<double>::quiet_NaN();
  });
  if (!found) return std::nullopt;
  const auto [away, s, t] = from_nearest(at, found->first);
  const Point3 foot = {p.x - away.x / scale_, p.y - away.y / scale_, p.z - away.z / scale_};
  return Foot{foot, corners_[found->first], {1 - s - t, s, t}};
}

bool SurfaceDistance::is_within(const Corners& triangle, double limit) const {
  const std::array<Vector, 3> corners = local(triangle);
  const double allowed = limit * scale_ - slack(size_of(corners));
  if (!(allowed > 0)) return false;
  for (const Vector& corner : corners)
    if (!nearest(corner, allowed * allowed)) return false;
  return Bounding(*this, corners).is_within(allowed);
}

double SurfaceDistance::least(const Corners& triangle) const {
  const std::array<Vector, 3> corners = local(triangle);
  if (size_of(corners) == infinity) return infinity;
  const Vector middle = times(1.0 / 3, plus(plus(corners[0], corners[1]), corners[2]));
  double most = 0;
  for (const Vector& p : {corners[0], corners[1], corners[2], middle}) {
    const auto near = nearest(p, infinity);
    most = std::max(most, near ? near->squared : infinity);
  }
  return std::sqrt(most) / scale_;
}

double SurfaceDistance::greatest(const Corners& triangle, double least) const {
  const std::array<Vector, 3> corners = local(triangle);
  if (size_of(corners) == infinity) return infinity;
  return (Bounding(*this, corners).bound(least * scale_) + slack(size_of(corners))) / scale_;
}

}  // namespace rbpa::space
