// What: vectors of space in the lanes of registers, with dot and cross product. Compiled once for each kind of
//       vector unit; HWY_TARGET_TOGGLE is the include guard.
#if defined(RBPA_BASE_LANES_VECTOR3_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_BASE_LANES_VECTOR3_INL_H_
#undef RBPA_BASE_LANES_VECTOR3_INL_H_
#else
#define RBPA_BASE_LANES_VECTOR3_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace rbpa::HWY_NAMESPACE {
namespace {

template <typename V>
struct Vector3Lanes {
  V x, y, z;
};

template <typename V>
HWY_INLINE V dot(const Vector3Lanes<V>& u, const Vector3Lanes<V>& v) {
  namespace hn = hwy::HWY_NAMESPACE;
  return hn::MulAdd(u.x, v.x, hn::MulAdd(u.y, v.y, hn::Mul(u.z, v.z)));
}
template <typename V>
HWY_INLINE Vector3Lanes<V> cross(const Vector3Lanes<V>& u, const Vector3Lanes<V>& v) {
  namespace hn = hwy::HWY_NAMESPACE;
  const auto minor = [](V a, V b, V c, V e) HWY_ATTR { return hn::NegMulAdd(c, e, hn::Mul(a, b)); };
  return {minor(u.y, v.z, u.z, v.y), minor(u.z, v.x, u.x, v.z), minor(u.x, v.y, u.y, v.x)};
}

}  // namespace
}  // namespace rbpa::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
