#include "rbpa/space/predicate/fixed_width_vectors.h"

namespace rbpa::space {
namespace {

using Word = std::uint64_t;

Integer128 product(std::int64_t a, std::int64_t b) { return Integer128{a} * b; }

/// Returns u × v. Components are below 2^124 because those of u and v are below 2^61.
Vector3<Integer128> wide_cross(const FixedVector& u, const FixedVector& v) {
  return {product(u.y, v.z) - product(u.z, v.y), product(u.z, v.x) - product(u.x, v.z),
          product(u.x, v.y) - product(u.y, v.x)};
}
Integer128 square(const FixedVector& u) { return product(u.x, u.x) + product(u.y, u.y) + product(u.z, u.z); }

/// A volume: high · 2^64 + low.
struct Volume {
  Integer128 high = 0;
  Word low = 0;

  /// Adds a · b. Requires: |a| < 2^124 and |b| < 2^61; at most three calls for one volume.
  void add_product(Integer128 a, std::int64_t b) {
    const auto word = static_cast<Word>(a);
    const Unsigned128 all = Unsigned128{word} * static_cast<Word>(b);
    const Unsigned128 sum = Unsigned128{low} + static_cast<Word>(all);
    low = static_cast<Word>(sum);
    high += product(static_cast<std::int64_t>(a >> 64), b) + static_cast<Integer128>(all >> 64U) +
            static_cast<Integer128>(sum >> 64U);
    if (b < 0) high -= Integer128{word};  // b was read as b + 2^64
  }
};

/// Returns v · u, six times the volume of a tetrahedron if v is a cross product of two edges.
Volume wide_dot(const Vector3<Integer128>& v, const FixedVector& u) {
  Volume volume;
  volume.add_product(v.x, u.x);
  volume.add_product(v.y, u.y);
  volume.add_product(v.z, u.z);
  return volume;
}

/// A sum of a few products of numbers of 187 and 125 bits. Each word of the sum is stored with its carries.
class Sum {
 public:
  /// Adds sign · volume · lift. Requires: `sign` is 1 or −1.
  void add_product(const Volume& volume, Integer128 lift, int sign) {
    add_product(volume, static_cast<Unsigned128>(lift < 0 ? -lift : lift), lift < 0 ? -sign : sign);
  }
  void add_product(const Volume& volume, Unsigned128 square, int sign) {
    const auto s0 = static_cast<Word>(square), s1 = static_cast<Word>(square >> 64U);
    const auto v0 = volume.low, v1 = static_cast<Word>(volume.high);
    const auto v2 = static_cast<std::int64_t>(volume.high >> 64);
    add(0, Unsigned128{v0} * s0, sign);
    add(1, Unsigned128{v0} * s1, sign);
    add(1, Unsigned128{v1} * s0, sign);
    add(2, Unsigned128{v1} * s1, sign);
    // |v2| < 2^60, and words of the square are unsigned.
    const auto size = static_cast<Word>(v2 < 0 ? -v2 : v2);
    const int sign_of_last = v2 < 0 ? -sign : sign;
    add(2, Unsigned128{size} * s0, sign_of_last);
    add(3, Unsigned128{size} * s1, sign_of_last);
  }

  int sign() const {
    Integer128 carry = 0;
    bool is_zero = true;
    for (const Integer128 word : word_) {
      carry += word;
      is_zero &= static_cast<Word>(carry) == 0;
      carry >>= 64;
    }
    return carry < 0 ? -1 : is_zero ? 0 : 1;  // five words hold the sum: the carry beyond them is the sign
  }

 private:
  void add(std::size_t k, Unsigned128 value, int sign) {
    word_[k] += Integer128{static_cast<Word>(value)} * sign;
    word_[k + 1] += static_cast<Integer128>(value >> 64U) * sign;
  }

  std::array<Integer128, 5> word_{};
};

/// Returns power_sign() with lift(square, i) in place of the square of vector i; u, v, w, p are vectors 0 to 3.
template <typename Lift>
int power_sign_with(const FixedVector& u, const FixedVector& v, const FixedVector& w, const FixedVector& p, Lift lift) {
  const Vector3<Integer128> uv = wide_cross(u, v);
  Sum sum;
  sum.add_product(wide_dot(uv, w), lift(square(p), 3), 1);
  sum.add_product(wide_dot(wide_cross(v, w), p), lift(square(u), 0), -1);
  sum.add_product(wide_dot(wide_cross(w, u), p), lift(square(v), 1), -1);
  sum.add_product(wide_dot(uv, p), lift(square(w), 2), -1);
  return sum.sign();
}

}  // namespace

int volume_sign(const FixedVector& u, const FixedVector& v, const FixedVector& w) {
  const Volume volume = wide_dot(wide_cross(u, v), w);
  return volume.high < 0 ? -1 : volume.high > 0 || volume.low != 0 ? 1 : 0;
}

int power_sign(const FixedVector& u, const FixedVector& v, const FixedVector& w, const FixedVector& p) {
  return power_sign_with(u, v, w, p, [](Integer128 square, std::size_t) { return static_cast<Unsigned128>(square); });
}

int power_sign(const FixedVector& u, const FixedVector& v, const FixedVector& w, const FixedVector& p,
               const std::array<Integer128, 4>& weights) {
  return power_sign_with(u, v, w, p, [&](Integer128 square, std::size_t i) { return square - weights[i]; });
}

}  // namespace rbpa::space
