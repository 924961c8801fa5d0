// What: the corners and arcs of the free region when the caps of a few points are away, all at once.
// Law:  every sign is certain, or it is said that nothing can be told. docs/surface.md, section 5.
// How:  each two circles cross at two places, if at all; those in no other cap are the corners, and from each the boundary
//       follows a circle to the next one on it. The pairs are in vector lanes. Compiled once for each kind of vector unit; no
//       include guard but the compiler's own per kind.
// Cost: for eight points, about a thousand vector operations.
#if defined(RBPA_SPACE_STAR_FEW_CAPS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_SPACE_STAR_FEW_CAPS_INL_H_
#undef RBPA_SPACE_STAR_FEW_CAPS_INL_H_
#else
#define RBPA_SPACE_STAR_FEW_CAPS_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "rbpa/base/lanes/mask_bits-inl.h"
#include "rbpa/space/star/limits.h"
#include "rbpa/space/star/neighbor.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::space {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

class FewCaps {
 public:
  static constexpr std::size_t most = 8;
  /// The ball rests on (v, about, left) with its centre at `at`; from there the boundary goes about the first of them to `next`.
  struct Corner {
    Vector3<double> at;
    double error;
    std::size_t about, left, next;
  };
  /// Returns: whether all is certain.
  bool find(std::span<const Neighbor> points, double radius) {
    count_ = points.size();
    corner_count_ = 0;
    if (count_ < 3 || count_ > most) return false;
    spread(points);
    covered_ = 0;
    for (std::size_t step = 1; 2 * step <= count_; ++step)
      if (!find_pairs(step, radius)) return false;
    return link(points, radius);
  }

  std::span<const Corner> corners() const { return {corners_.data(), corner_count_}; }

 private:
  // Each point once, and again, so that the lanes of those a step further on are together as well.
  static constexpr std::size_t twice = 2 * most;
  struct alignas(64) Lanes {
    std::array<double, most> x, y, z;
  };

  void spread(std::span<const Neighbor> points) {
    size_ = 0;
    for (std::size_t i = 0, k = 0; i < twice; ++i, k = k + 1 == count_ ? 0 : k + 1) {
      const Neighbor& p = points[k];
      x_[i] = p.at.x;
      y_[i] = p.at.y;
      z_[i] = p.at.z;
      power_[i] = p.power;
      size_ = std::max(size_, p.size());
    }
  }

  /// The corners of points i and i + step.
  bool find_pairs(std::size_t step, double radius) {
    const hn::CappedTag<double, most> d;
    using V = hn::Vec<decltype(d)>;
    const std::size_t pairs = 2 * step == count_ ? step : count_;
    for (std::size_t i = 0; i < pairs; i += hn::Lanes(d)) {
      const V px = hn::Load(d, &x_[i]), py = hn::Load(d, &y_[i]), pz = hn::Load(d, &z_[i]),
              pp = hn::Load(d, &power_[i]);
      const std::size_t j = i + step;
      const V qx = hn::LoadU(d, &x_[j]), qy = hn::LoadU(d, &y_[j]), qz = hn::LoadU(d, &z_[j]),
              qq = hn::LoadU(d, &power_[j]);
      // As FreeRegion::rests() does it, whose bounds hold for it.
      const auto minor = [](V a, V b, V c, V e) { return hn::NegMulAdd(c, e, hn::Mul(a, b)); };
      const auto dot = [](V ax, V ay, V az, V bx, V by, V bz) {
        return hn::MulAdd(ax, bx, hn::MulAdd(ay, by, hn::Mul(az, bz)));
      };
      const V nx = minor(py, qz, pz, qy), ny = minor(pz, qx, px, qz), nz = minor(px, qy, py, qx);
      const V wx = hn::Sub(px, qx), wy = hn::Sub(py, qy), wz = hn::Sub(pz, qz);
      const V nn = dot(nx, ny, nz, nx, ny, nz), ww = dot(wx, wy, wz, wx, wy, wz);
      const V product = hn::Mul(hn::Set(d, 4), hn::Mul(pp, qq)), whole = hn::Mul(hn::Set(d, 4 * radius * radius), nn);
      const V clearance = hn::NegMulAdd(product, ww, whole);
      const V inverse = hn::Div(hn::Set(d, 0.5), nn), rise = hn::Mul(hn::Sqrt(clearance), inverse);
      const V error = hn::Mul(hn::Set(d, 0x1p-53 * radius),
                              hn::MulAdd(hn::Mul(hn::Set(d, 384), product), inverse,
                                         hn::MulAdd(hn::Set(d, 32), hn::Div(whole, clearance), hn::Set(d, 32))));
      const std::uint64_t wanted = (std::uint64_t{1} << std::min(pairs - i, hn::Lanes(d))) - 1;
      const std::uint64_t cross = bits(d, hn::And(clearance > hn::Mul(hn::Set(d, limits::flatness), whole),
                                                  error < hn::Set(d, limits::error * radius))) &
                                  wanted;
      const std::uint64_t apart =
          bits(d, clearance < hn::Mul(hn::Set(d, -limits::flatness * radius * radius), product)) & wanted;
      if ((cross | apart) != wanted) return false;
      if (cross == 0) continue;
      const V pscale = hn::Mul(hn::Add(pp, pp), inverse), qscale = hn::Mul(hn::Add(qq, qq), inverse);
      const V middle_x = hn::MulAdd(pscale, minor(qy, nz, qz, ny), hn::Mul(qscale, minor(ny, pz, nz, py))),
              middle_y = hn::MulAdd(pscale, minor(qz, nx, qx, nz), hn::Mul(qscale, minor(nz, px, nx, pz))),
              middle_z = hn::MulAdd(pscale, minor(qx, ny, qy, nx), hn::Mul(qscale, minor(nx, py, ny, px)));
      const V lx = hn::MulAdd(nx, rise, middle_x), ly = hn::MulAdd(ny, rise, middle_y),
              lz = hn::MulAdd(nz, rise, middle_z);
      const V rx = hn::NegMulAdd(nx, rise, middle_x), ry = hn::NegMulAdd(ny, rise, middle_y),
              rz = hn::NegMulAdd(nz, rise, middle_z);

      // The deepest that each is in any other cap.
      V left = hn::Set(d, -std::numeric_limits<double>::infinity()), right = left;
      for (std::size_t other = 1; other < count_; ++other) {
        if (other == step) continue;
        const std::size_t k = i + other;
        const V x = hn::LoadU(d, &x_[k]), y = hn::LoadU(d, &y_[k]), z = hn::LoadU(d, &z_[k]),
                power = hn::LoadU(d, &power_[k]);
        left = hn::Max(left, hn::MulAdd(lx, x, hn::MulAdd(ly, y, hn::MulSub(lz, z, power))));
        right = hn::Max(right, hn::MulAdd(rx, x, hn::MulAdd(ry, y, hn::MulSub(rz, z, power))));
      }
      const V bound = hn::Mul(error, hn::Set(d, size_));
      const std::uint64_t left_free = bits(d, left < hn::Neg(bound)) & cross,
                          right_free = bits(d, right < hn::Neg(bound)) & cross,
                          left_dead = bits(d, left > bound) & cross, right_dead = bits(d, right > bound) & cross;
      if ((left_free | left_dead) != cross || (right_free | right_dead) != cross) return false;
      for (std::uint64_t dead = left_dead | right_dead; dead != 0; dead &= dead - 1) {
        const std::size_t a = i + static_cast<std::size_t>(std::countr_zero(dead));
        covered_ |= std::uint64_t{1} << a | std::uint64_t{1} << (a + step) % count_;
      }
      if ((left_free | right_free) == 0) continue;
      alignas(64) double errors[most];
      hn::Store(error, d, errors);
      const auto add = [&](std::uint64_t free, V x, V y, V z, bool is_left) {
        if (free == 0) return;
        Lanes at;
        hn::Store(x, d, at.x.data());
        hn::Store(y, d, at.y.data());
        hn::Store(z, d, at.z.data());
        for (; free != 0; free &= free - 1) {
          const auto lane = static_cast<std::size_t>(std::countr_zero(free));
          const std::size_t a = i + lane, b = a + step < count_ ? a + step : a + step - count_;
          corners_[corner_count_++] = {
              {at.x[lane], at.y[lane], at.z[lane]}, errors[lane], is_left ? a : b, is_left ? b : a, 0};
        }
      };
      add(left_free, lx, ly, lz, true);
      add(right_free, rx, ry, rz, false);
    }
    return true;
  }

  template <typename D>
  static std::uint64_t bits(D d, hn::Mask<D> mask) {
    return rbpa::HWY_NAMESPACE::bits_of(d, mask);
  }

  /// From each corner to the next one on the circle of the point that the boundary goes about.
  bool link(std::span<const Neighbor> points, double radius) {
    struct Ends {
      std::array<std::uint8_t, 2> from, to;
      std::size_t from_count = 0, to_count = 0;
    };
    std::array<Ends, most> circle{};
    for (std::size_t k = 0; k < corner_count_; ++k) {
      Ends &about = circle[corners_[k].about], &left = circle[corners_[k].left];
      if (about.from_count == 2 || left.to_count == 2) return false;
      about.from[about.from_count++] = static_cast<std::uint8_t>(k);
      left.to[left.to_count++] = static_cast<std::uint8_t>(k);
    }
    for (std::size_t i = 0; i < count_; ++i) {
      const Ends& ends = circle[i];
      if (ends.from_count != ends.to_count) return false;
      if (ends.from_count == 0) {
        // Its circle is free as a whole, or taken away as a whole.
        if ((covered_ >> i & 1) == 0) return false;
        continue;
      }
      std::size_t first = 0;  // of the two ends, that which comes first after the first beginning
      if (ends.from_count == 2) {
        const Vector3<double>&p = points[i].at, &a = corners_[ends.to[0]].at, &b = corners_[ends.to[1]].at;
        const Vector3<double> ahead = cross(p, corners_[ends.from[0]].at);
        const double to_a = dot(ahead, a), to_b = dot(ahead, b), a_to_b = dot(cross(p, a), b);
        if (!(std::min({std::abs(to_a), std::abs(to_b), std::abs(a_to_b)}) >
              limits::slack * points[i].length * radius * radius))
          return false;
        first = (to_a > 0) != (to_b > 0) ? (to_a > 0 ? 0 : 1) : (a_to_b > 0 ? 0 : 1);
        corners_[ends.from[1]].next = ends.to[1 - first];
      }
      corners_[ends.from[0]].next = ends.to[first];
    }
    return true;
  }

  std::size_t count_ = 0, corner_count_ = 0;
  std::uint64_t covered_ = 0;  // points of whose circle some place is in another cap
  double size_ = 0;            // of the point farthest away, in the sum of coordinates
  alignas(64) std::array<double, twice> x_, y_, z_, power_;
  std::array<Corner, 2 * most*(most - 1)> corners_;
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace rbpa::space
HWY_AFTER_NAMESPACE();

#endif
