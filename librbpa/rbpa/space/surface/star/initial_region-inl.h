// What: finds the corners and arcs of the free region that is left by the caps of a few points, subtracted together.
// Law:  every sign is certain; otherwise find() returns false. docs/explanation/surfaces.md, section 13.
// How:  1. cross the circles of each pair of points (ball_pair-inl.h), in vector lanes;
//       2. drop the crossings that some other cap covers: the rest are the corners;
//       3. from each corner follow its circle to the next corner on it: these are the arcs.
//       Compiled once for each kind of vector unit: Highway's toggle is the include guard.
// Cost: about a thousand vector operations for eight points.
#if defined(RBPA_SPACE_STAR_INITIAL_REGION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_SPACE_STAR_INITIAL_REGION_INL_H_
#undef RBPA_SPACE_STAR_INITIAL_REGION_INL_H_
#else
#define RBPA_SPACE_STAR_INITIAL_REGION_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "rbpa/base/lanes/lanes-inl.h"
#include "rbpa/space/surface/star/ball_pair-inl.h"
#include "rbpa/space/surface/star/limits.h"
#include "rbpa/space/surface/star/neighbor.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::space::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

class InitialRegion {
 public:
  static constexpr std::size_t most = 8;                          // number of points: as many as AVX-512 has lanes
  static constexpr std::size_t most_corners = most * (most - 1);  // two for each pair of points
  /// A corner: the ball rests on (v, about, left) with its center at `at`. From there the boundary follows the circle
  /// of `about` to the corner `next`. `about` and `left` are positions in the list of points.
  struct Corner {
    Vector3<double> at;
    double error;
    std::size_t about, left, next;
  };

  /// Finds the corners of the region's boundary and the arcs between them. Returns false if a sign is not certain, or
  /// there are fewer than 3 or more than `most` points.
  bool find(std::span<const Neighbor> points, double radius) {
    count_ = points.size();
    corner_count_ = 0;
    if (count_ < 3 || count_ > most) return false;
    load(points);
    covered_ = 0;
    for (std::size_t step = 1; 2 * step <= count_; ++step)
      if (!find_corners(step, radius)) return false;
    return find_arcs(points, radius);
  }

  std::span<const Corner> corners() const { return {corners_.data(), corner_count_}; }

 private:
  static constexpr hn::CappedTag<double, most> d{};
  using D = hn::CappedTag<double, most>;
  using V = hn::Vec<D>;
  using Pair = BallPair<D>;

  // The points P0 … P4, repeated. The pairs (i, i + step) are then in the same lanes of two loads, the second one
  // unaligned:
  //
  //   x_                P0  P1  P2  P3  P4  P0  P1  P2  P3  P4  P0 …
  //   p, at i = 0      │P0  P1  P2  P3  P4   ·   ·   · │
  //   q, at i + 2      │P2  P3  P4  P0  P1   ·   ·   · │        step 2
  //   others, at i + k │Pk  …                         │        k = 1, 3, 4: all that are in neither
  //
  // Steps up to half of the count give all pairs, each once; for a step of exactly half, only the first half of the
  // lanes is used.
  static constexpr std::size_t twice = 2 * most;

  void load(std::span<const Neighbor> points) {
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

  HWY_INLINE Pair::Point points_at(std::size_t i) const {
    return {{hn::LoadU(d, &x_[i]), hn::LoadU(d, &y_[i]), hn::LoadU(d, &z_[i])}, hn::LoadU(d, &power_[i])};
  }

  /// Finds the corners at which the circles of points i and i + step cross. Returns whether every sign is certain.
  bool find_corners(std::size_t step, double radius) {
    const std::size_t pairs = 2 * step == count_ ? step : count_;
    for (std::size_t i = 0; i < pairs; i += hn::Lanes(d)) {
      const Pair pair(d, points_at(i), points_at(i + step), radius);
      const V error = pair.error();
      const std::uint64_t wanted = (std::uint64_t{1} << std::min(pairs - i, hn::Lanes(d))) - 1;
      const std::uint64_t cross = bits(hn::And(pair.exist(), pair.is_accurate(error))) & wanted;
      const std::uint64_t apart = bits(pair.are_apart()) & wanted;
      if ((cross | apart) != wanted) return false;
      if (cross == 0) continue;
      const Pair::Centers centers = pair.centers();
      const Depths depths = deepest_in_others(i, step, centers);
      const V bound = hn::Mul(error, hn::Set(d, size_));
      const Sides left = sides_of(depths.left, bound, cross), right = sides_of(depths.right, bound, cross);
      if ((left.free | left.covered) != cross || (right.free | right.covered) != cross) return false;
      for (std::uint64_t covered = left.covered | right.covered; covered != 0; covered &= covered - 1) {
        const std::size_t a = i + static_cast<std::size_t>(std::countr_zero(covered));
        covered_ |= std::uint64_t{1} << a | std::uint64_t{1} << (a + step) % count_;
      }
      if ((left.free | right.free) == 0) continue;
      alignas(64) double errors[most];
      hn::Store(error, d, errors);
      add_corners(left.free, i, step, centers.left, errors, true);
      add_corners(right.free, i, step, centers.right, errors, false);
    }
    return true;
  }

  /// The greatest c · x − x²/2 at each crossing c, over the points x that are not of the crossing's own pair. If it is
  /// above 0, the crossing is in a cap.
  struct Depths {
    V left, right;
  };
  HWY_INLINE Depths deepest_in_others(std::size_t i, std::size_t step, const Pair::Centers& centers) const {
    const V nothing = hn::Set(d, -std::numeric_limits<double>::infinity());
    Depths deepest = {nothing, nothing};
    for (std::size_t other = 1; other < count_; ++other) {
      if (other == step) continue;
      const Pair::Point x = points_at(i + other);
      const auto depth = [&](const Pair::Vector& c) {
        return hn::MulAdd(c.x, x.at.x, hn::MulAdd(c.y, x.at.y, hn::MulSub(c.z, x.at.z, x.power)));
      };
      deepest.left = hn::Max(deepest.left, depth(centers.left));
      deepest.right = hn::Max(deepest.right, depth(centers.right));
    }
    return deepest;
  }

  /// The wanted lanes whose crossings are certainly in no cap, and those whose crossings are certainly in one.
  struct Sides {
    std::uint64_t free, covered;
  };
  HWY_INLINE static Sides sides_of(V depth, V bound, std::uint64_t wanted) {
    return {bits(depth < hn::Neg(bound)) & wanted, bits(depth > bound) & wanted};
  }

  HWY_INLINE void add_corners(std::uint64_t free, std::size_t i, std::size_t step, const Pair::Vector& centers,
                              const double* errors, bool is_left) {
    if (free == 0) return;
    alignas(64) std::array<double, most> x, y, z;
    hn::Store(centers.x, d, x.data());
    hn::Store(centers.y, d, y.data());
    hn::Store(centers.z, d, z.data());
    for (; free != 0; free &= free - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(free));
      const std::size_t a = i + lane, b = a + step < count_ ? a + step : a + step - count_;
      corners_[corner_count_++] = {{x[lane], y[lane], z[lane]}, errors[lane], is_left ? a : b, is_left ? b : a, 0};
    }
  }

  static std::uint64_t bits(hn::Mask<D> mask) { return rbpa::HWY_NAMESPACE::bits_of(d, mask); }

  /// For one circle: the corners at which an arc of it begins, and those at which one ends.
  struct Ends {
    std::array<std::uint8_t, 2> from, to;
    std::size_t from_count = 0, to_count = 0;
  };

  /// Links each corner to the next one on its circle. Returns false if a circle is free as a whole or has more than two
  /// arcs, or if the order of its corners is not certain.
  bool find_arcs(std::span<const Neighbor> points, double radius) {
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
        // A circle without corners is covered as a whole if any crossing on it is covered; otherwise it may be free.
        if ((covered_ >> i & 1) == 0) return false;
        continue;
      }
      std::size_t first = 0;  // the end that follows ends.from[0]
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
  std::uint64_t covered_ = 0;  // the points with a crossing on their circle that another cap covers
  double size_ = 0;            // the greatest Neighbor::size()
  alignas(64) std::array<double, twice> x_, y_, z_, power_;
  std::array<Corner, most_corners> corners_;
};

}  // namespace
}  // namespace rbpa::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
