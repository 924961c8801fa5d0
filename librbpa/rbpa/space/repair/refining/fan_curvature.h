// What:   computes the mean curvature of triangles around a vertex.
// How:    weights edges by cotangents of the angles across from them; each triangle counts by the part of its area that
//         is nearest to the vertex.
// Source: Meyer, Desbrun, Schröder, Barr, Discrete differential-geometry operators for triangulated 2-manifolds (2003).
#pragma once

#include <cmath>

#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {

using Vector = Vector3<double>;

inline double length(const Vector& v) { return std::sqrt(dot(v, v)); }

/// The weights of a triangle v a b at its corner v.
struct CornerWeights {
  double to_a = 0, to_b = 0;  ///< half cotangents of the angles at b and at a
  double area = 0;            ///< area of the part of the triangle that is nearest to v
  Vector normal{};            ///< normal of the triangle; its length is twice the area

  CornerWeights(const Vector& v, const Vector& a, const Vector& b) : normal(cross(minus(a, v), minus(b, v))) {
    const double twice = length(normal);
    if (!(twice > 0)) return;
    const Vector va = minus(a, v), vb = minus(b, v), ab = minus(b, a);
    const double at_v = dot(va, vb), at_a = -dot(va, ab), at_b = dot(vb, ab);  // cosines, each times two sides
    to_a = at_b / twice / 2;
    to_b = at_a / twice / 2;
    if (at_v < 0)
      area = twice / 4;
    else if (at_a < 0 || at_b < 0)
      area = twice / 8;
    else
      area = (dot(va, va) * to_a + dot(vb, vb) * to_b) / 4;
  }
};

/// Sums of area and curvature over the triangles around a vertex.
struct FanCurvature {
  Vector sum{};     ///< sum of weights times edges: the area times the curvature, along the normal
  Vector normal{};  ///< sum of the triangles' normals, of any length
  double area = 0;

  void add(const Vector& v, const Vector& a, const Vector& b) {
    const CornerWeights of(v, a, b);
    sum = plus(sum, plus(times(of.to_a, minus(a, v)), times(of.to_b, minus(b, v))));
    normal = plus(normal, of.normal);
    area += of.area;
  }
  /// Returns twice the mean curvature times the area. The result is below 0 if the surface bends away from its normal,
  /// as the surface of a ball does.
  double bend() const {
    const double size = length(normal);
    return size > 0 ? dot(sum, normal) / size : 0;
  }
};

}  // namespace rbpa::space
