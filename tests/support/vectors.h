// What: sums, products and lengths of points in space, and of vectors of other numbers.
#pragma once

#include <cmath>

namespace rbpa_test {

/// A vector of numbers other than double, such as rational ones.
template <typename Number>
struct Vector3 {
  Number x, y, z;
};

template <typename V>
concept HasThreeCoordinates = requires(const V& v) {
  v.x;
  v.y;
  v.z;
};

template <HasThreeCoordinates V>
V operator+(const V& u, const V& v) {
  return {u.x + v.x, u.y + v.y, u.z + v.z};
}
template <HasThreeCoordinates V>
V operator-(const V& u, const V& v) {
  return {u.x - v.x, u.y - v.y, u.z - v.z};
}
template <HasThreeCoordinates V>
V operator*(const decltype(V::x)& s, const V& v) {
  return {s * v.x, s * v.y, s * v.z};
}
template <HasThreeCoordinates V>
V operator/(const V& v, const decltype(V::x)& s) {
  return {v.x / s, v.y / s, v.z / s};
}
template <HasThreeCoordinates V>
decltype(V::x) dot(const V& u, const V& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}
template <HasThreeCoordinates V>
V cross(const V& u, const V& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}
template <HasThreeCoordinates V>
decltype(V::x) length(const V& v) {
  return std::sqrt(dot(v, v));
}
template <HasThreeCoordinates V>
V unit(const V& v) {
  return v / length(v);
}

}  // namespace rbpa_test
