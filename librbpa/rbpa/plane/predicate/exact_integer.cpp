#include "rbpa/plane/predicate/exact_integer.h"

#include <initializer_list>

#include "rbpa/base/exact/integer_scale.h"

namespace rbpa::exact_integer {
namespace {

struct Vector {
  Integer x, y;
};

Integer dot(const Vector& u, const Vector& v) { return u.x * v.x + u.y * v.y; }
Integer cross(const Vector& u, const Vector& v) { return u.x * v.y - u.y * v.x; }

/// A converter of points, and a length, to integers.
class Scale {
 public:
  Scale(std::initializer_list<Point> points, double length = 0) {
    for (const Point& p : points) {
      scale_.include(p.x);
      scale_.include(p.y);
    }
    scale_.include(length);
  }

  Integer operator()(double value) const { return scale_(value); }

  Vector from(const Point& a, const Point& b) const { return {scale_(b.x) - scale_(a.x), scale_(b.y) - scale_(a.y)}; }

 private:
  IntegerScale scale_;
};

}  // namespace

int orientation(const Point& a, const Point& b, const Point& c) {
  const Scale scale{a, b, c};
  return cross(scale.from(a, b), scale.from(a, c)).sign();
}

int in_circle(const Point& a, const Point& b, const Point& p, const Point& q) {
  const Scale scale{a, b, p, q};
  const Vector ab = scale.from(a, b), ap = scale.from(a, p), bp = scale.from(b, p);
  const Vector aq = scale.from(a, q), bq = scale.from(b, q);
  const Integer difference = dot(ap, bp) * cross(ab, aq) - dot(aq, bq) * cross(ab, ap);
  return difference.sign();
}

int compare_circumradius(const Point& a, const Point& b, const Point& c, double alpha) {
  const Scale scale({a, b, c}, alpha);
  const Vector ab = scale.from(a, b), bc = scale.from(b, c), ca = scale.from(c, a);
  const Integer area = cross(ab, ca), radius = scale(alpha);
  const Integer difference = dot(ab, ab) * dot(bc, bc) * dot(ca, ca) - 4 * radius * radius * area * area;
  return difference.sign();
}

int compare_to_diameter(const Point& a, const Point& b, double alpha) {
  const Scale scale({a, b}, alpha);
  const Vector ab = scale.from(a, b);
  const Integer radius = scale(alpha);
  const Integer difference = dot(ab, ab) - 4 * radius * radius;
  return difference.sign();
}

int compare_distances(const Point& v, const Point& p, const Point& q) {
  const Scale scale{v, p, q};
  const Vector vp = scale.from(v, p), vq = scale.from(v, q);
  const Integer difference = dot(vp, vp) - dot(vq, vq);
  return difference.sign();
}

int dot(const Point& v, const Point& p, const Point& q) {
  const Scale scale{v, p, q};
  const Integer product = dot(scale.from(v, p), scale.from(v, q));
  return product.sign();
}

}  // namespace rbpa::exact_integer
