#include "rbpa/space/predicate/exact.h"

#include <initializer_list>

#include "rbpa/base/exact/integer_scale.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space::exact {
namespace {

using Vector = Vector3<Integer>;

Vector operator-(const Vector& u, const Vector& v) { return {u.x - v.x, u.y - v.y, u.z - v.z}; }

/// A scale that makes integers of the coordinates of points and of lengths.
class Scale {
 public:
  Scale(std::initializer_list<Point3> points, double length = 0) {
    for (const Point3& p : points) {
      scale_.include(p.x);
      scale_.include(p.y);
      scale_.include(p.z);
    }
    scale_.include(length);
  }

  void include(double length) { scale_.include(length); }
  Integer operator()(double value) const { return scale_(value); }
  Vector operator()(const Point3& p) const { return {scale_(p.x), scale_(p.y), scale_(p.z)}; }

 private:
  IntegerScale scale_;
};

/// A triangle with its corner a at the origin.
struct Corners {
  Corners(const Scale& scale, const Point3& a, const Point3& b, const Point3& c)
      : origin(scale(a)), u(scale(b) - origin), v(scale(c) - origin), n(cross(u, v)) {}

  Vector origin, u, v;
  Vector n;  ///< normal u × v, whose length is twice the area
};

/// Returns 4 radius² n² − u² v² (u − v)², which is not negative if the circumradius is at most the radius.
Integer clearance(const Corners& t, const Integer& radius) {
  const Vector w = t.u - t.v;
  return 4 * radius * radius * dot(t.n, t.n) - dot(t.u, t.u) * dot(t.v, t.v) * dot(w, w);
}

}  // namespace

int orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Scale scale{a, b, c, d};
  const Corners t(scale, a, b, c);
  return dot(t.n, scale(d) - t.origin).sign();
}

int compare_distances(const Point3& o, const Point3& a, const Point3& b) {
  const Scale scale{o, a, b};
  const Vector u = scale(a) - scale(o), v = scale(b) - scale(o);
  const Integer squares = dot(u, u) - dot(v, v);
  return squares.sign();
}

int compare_circumradius(const Point3& a, const Point3& b, double radius) {
  const Scale scale({a, b}, radius);
  const Vector u = scale(b) - scale(a);
  const Integer diameter = 2 * scale(radius), squares = dot(u, u) - diameter * diameter;
  return squares.sign();
}

int compare_circumradius(const Point3& a, const Point3& b, const Point3& c, double radius) {
  const Scale scale({a, b, c}, radius);
  return -clearance(Corners(scale, a, b, c), scale(radius)).sign();
}

int compare_circumradius(const Point3& a, const Point3& b, const Point3& c, const Point3& d, double radius) {
  const Scale scale({a, b, c, d}, radius);
  const Corners t(scale, a, b, c);
  const Vector w = scale(d) - t.origin, vw = cross(t.v, w), wu = cross(w, t.u);
  const Integer uu = dot(t.u, t.u), vv = dot(t.v, t.v), ww = dot(w, w);
  // Relative to a, the center is (uu v × w + vv w × u + ww u × v) / 2 volume.
  const Vector center = {uu * vw.x + vv * wu.x + ww * t.n.x, uu * vw.y + vv * wu.y + ww * t.n.y,
                         uu * vw.z + vv * wu.z + ww * t.n.z};
  const Integer diameter = 2 * scale(radius) * dot(t.n, w), squares = dot(center, center) - diameter * diameter;
  return dot(t.n, w) == 0 ? 1 : squares.sign();
}

int side_of_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& q,
                   const std::array<double, 5>* radii) {
  Scale scale{a, b, c, d, q};
  if (radii)
    for (const double radius : *radii) scale.include(radius);
  const Corners t(scale, a, b, c);
  const Vector w = scale(d) - t.origin, p = scale(q) - t.origin;
  const auto lift = [&](const Vector& to, std::size_t i) -> Integer {
    if (!radii) return dot(to, to);
    const Integer own = scale((*radii)[i]), first = scale((*radii)[0]);
    return dot(to, to) - own * own + first * first;
  };
  // The power of q is p² − 2 p · center relative to a, here times the volume; compare_circumradius() has the center.
  const Integer power = lift(p, 4) * dot(t.n, w) - lift(t.u, 1) * dot(cross(t.v, w), p) -
                        lift(t.v, 2) * dot(cross(w, t.u), p) - lift(w, 3) * dot(t.n, p);
  return -power.sign();
}

int side_of_least_sphere(const Point3& a, const Point3& b, const Point3& q) {
  const Scale scale{a, b, q};
  const Integer product = dot(scale(a) - scale(q), scale(b) - scale(q));
  return -product.sign();
}

int side_of_least_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& q) {
  const Scale scale{a, b, c, q};
  const Corners t(scale, a, b, c);
  const Vector d = scale(q) - t.origin;
  // `power` is n² times the power of q. Relative to a, the center is (uu v × n + vv n × u) / (2 n²).
  const Integer power =
      dot(t.n, t.n) * dot(d, d) - dot(t.u, t.u) * dot(cross(t.v, t.n), d) - dot(t.v, t.v) * dot(cross(t.n, t.u), d);
  return -power.sign();
}

int side_of_ball(const Point3& a, const Point3& b, const Point3& c, double radius, const Point3& q) {
  const Scale scale({a, b, c, q}, radius);
  const Corners t(scale, a, b, c);
  const Vector d = scale(q) - t.origin;
  // The power of q is (A − B √D) / n²: docs/explanation/surfaces.md, section 14.
  const Vector vn = cross(t.v, t.n), nu = cross(t.n, t.u);
  const Integer uu = dot(t.u, t.u), vv = dot(t.v, t.v);
  const Integer A = dot(t.n, t.n) * dot(d, d) - uu * dot(vn, d) - vv * dot(nu, d), B = dot(t.n, d);
  const int sign_a = A.sign(), sign_b = B.sign();
  if (sign_b == 0) return -sign_a;
  const Integer D = clearance(t, scale(radius));
  if (D == 0) return -sign_a;
  if (sign_a != sign_b) return sign_a == 0 ? sign_b : -sign_a;
  const Integer squares = A * A - B * B * D;
  return -sign_a * squares.sign();
}

int normal_sign(const Point3& a, const Point3& b, const Point3& c, const Point3& normal) {
  const Scale scale{a, b, c}, own{normal};  // a scale of its own: the length of the normal does not matter
  return dot(Corners(scale, a, b, c).n, own(normal)).sign();
}

int compare_normals(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e,
                    const Point3& f) {
  const Scale scale{a, b, c, d, e, f};
  return dot(Corners(scale, a, b, c).n, Corners(scale, d, e, f).n).sign();
}

}  // namespace rbpa::space::exact
