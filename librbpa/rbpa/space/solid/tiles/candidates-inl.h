// What: finds candidates for the fourth corner of a tetrahedron at v: points with unfinished stars within reach of v.
// How:  a block has the unfinished points in the cells around a cell, and serves all points v of the cell. The points
//       of the block in a ball around v are the candidates. Their offsets from v are stored in double precision for
//       decisions and in single precision for choices. The centers of balls through v, p and q are x/2 + t n; the
//       fourth corner is the point above the plane with the least t (quotients: docs/explanation/space.md, sections 8
//       to 10). The choice is certain if every other candidate is outside of the sphere by more than the error, and the
//       radius of the sphere is at most half of the reach: the sphere is then within the ball of candidates.
#if defined(RBPA_SPACE_TILES_CANDIDATES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_SPACE_TILES_CANDIDATES_INL_H_
#undef RBPA_SPACE_TILES_CANDIDATES_INL_H_
#else
#define RBPA_SPACE_TILES_CANDIDATES_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rbpa/base/lanes/lanes-inl.h"
#include "rbpa/space/predicate/sphere_minors.h"
#include "rbpa/space/predicate/vector3.h"
#include "rbpa/space/solid/tiles/leaf_points.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::space::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using rbpa::HWY_NAMESPACE::bits_of;
using rbpa::HWY_NAMESPACE::LanesToFront;
using rbpa::HWY_NAMESPACE::Vector3Lanes;

using Singles = hn::CappedTag<float, 16>;
using SingleNumbers = hn::RebindToSigned<Singles>;
using Doubles = hn::CappedTag<double, 8>;
inline constexpr std::size_t single_lanes = hn::MaxLanes(Singles()), double_lanes = hn::MaxLanes(Doubles());

using Local = Tile::Local;

/// The sphere through (p, q, r, v). The error of V at an offset p from v (predicate/sphere_minors.h) is at most
/// constant + slope · p².
struct Sphere {
  SphereMinors minor;
  double constant, slope;
};

/// The coefficients of a sphere, each repeated in all lanes.
class SphereLanes {
 public:
  HWY_INLINE explicit SphereLanes(const Sphere& sphere)
      : x_(hn::Set(Doubles(), sphere.minor[0])),
        y_(hn::Set(Doubles(), sphere.minor[1])),
        z_(hn::Set(Doubles(), sphere.minor[2])),
        square_(hn::Set(Doubles(), sphere.minor[3] + sphere.slope)),
        constant_(hn::Set(Doubles(), sphere.constant)) {}

  using Lanes = hn::Vec<Doubles>;
  /// Returns a bit for each lane, set if the point is certainly outside of the sphere. Lanes of x, y and z are offsets
  /// of points from v; `square` has the squared lengths.
  HWY_INLINE std::uint64_t outside(Lanes x, Lanes y, Lanes z, Lanes square) const {
    const auto most = hn::MulAdd(x, x_, hn::MulAdd(y, y_, hn::MulAdd(z, z_, hn::MulAdd(square, square_, constant_))));
    return bits_of(Doubles(), hn::Lt(most, hn::Zero(Doubles())));
  }

 private:
  Lanes x_, y_, z_, square_, constant_;
};

/// Returns the elements of the bit array `bits` from number `first` on, one for each lane of double precision.
HWY_INLINE std::uint64_t lane_bits(const std::uint8_t* bits, std::size_t first) {
  const std::uint32_t two = bits[first / 8] | static_cast<std::uint32_t>(bits[first / 8 + 1]) << 8U;
  return (two >> first % 8) & ((1U << double_lanes) - 1);
}

/// The unfinished points in the cells around a cell.
class Block {
 public:
  /// The number of cells gathered on each side of a cell.
  static constexpr int cells = 2;

  /// Gathers the unfinished points in the cells around `cell` and around the next `more` cells in the row of `cell`.
  /// `open` has one bit for each point, set if the point is unfinished, and one more readable byte at the end.
  HWY_INLINE void gather(const Tile& tile, const std::array<int, 3>& cell, int more, const std::uint8_t* open) {
    const Doubles d;
    const hn::RebindToSigned<Doubles> numbers;
    const auto step = hn::Iota(numbers, 0);
    cells_ = {{{cell[0] - cells, cell[0] + cells},
               {cell[1] - cells, cell[1] + cells},
               {cell[2] - cells, cell[2] + cells + more}}};
    std::size_t count = 0;
    const double *const x = tile.x(), *const y = tile.y(), *const z = tile.z();
    for (int i = cells_[0].low; i <= cells_[0].high; ++i)
      for (int j = cells_[1].low; j <= cells_[1].high; ++j) {
        const std::size_t row = tile.cell(i, j, cells_[2].low);
        const Local first = tile.first_in(row),
                    end = tile.first_in(row + static_cast<std::size_t>(2 * cells + more + 1));
        if (count + (end - first) + 2 * double_lanes > x_.size()) grow(count + (end - first));
        double *const to_x = x_.data(), *const to_y = y_.data(), *const to_z = z_.data();
        std::int64_t* const to_id = id_.data();
        for (Local k = first; k < end; k += double_lanes) {
          std::uint64_t bits = lane_bits(open, k);
          if (end - k < double_lanes) bits &= (1U << (end - k)) - 1;
          if (bits == 0) continue;
          const LanesToFront<Doubles> to_front(d, bits);
          hn::StoreU(to_front(hn::LoadU(d, x + k)), d, to_x + count);
          hn::StoreU(to_front(hn::LoadU(d, y + k)), d, to_y + count);
          hn::StoreU(to_front(hn::LoadU(d, z + k)), d, to_z + count);
          const auto number = hn::Add(step, hn::Set(numbers, static_cast<std::int64_t>(k)));
          hn::StoreU(hn::BitCast(numbers, to_front(hn::BitCast(d, number))), numbers, to_id + count);
          count += static_cast<std::size_t>(std::popcount(bits));
        }
      }
    count_ = count;
  }
  /// Returns the ranges of cells whose unfinished points are all in the block.
  const std::array<Tile::Range, 3>& ranges() const { return cells_; }

  void remove(Local i) {
    for (std::size_t at = 0; at < count_; ++at) {
      if (id_[at] != static_cast<std::int64_t>(i)) continue;
      --count_;
      x_[at] = x_[count_], y_[at] = y_[count_], z_[at] = z_[count_];
      id_[at] = id_[count_];
      return;
    }
  }

  /// Calls visit(i) for each point i of the block that is not certainly outside of `sphere`. `sphere` is relative to v.
  template <typename Visit>
  HWY_INLINE void for_each_not_outside(const Sphere& sphere, const Point3& v, Visit visit) const {
    const Doubles d;
    const SphereLanes of(sphere);
    const auto vx = hn::Set(d, v.x), vy = hn::Set(d, v.y), vz = hn::Set(d, v.z);
    for (std::size_t i = 0; i < count_; i += double_lanes) {
      const auto px = hn::Sub(hn::LoadU(d, &x_[i]), vx), py = hn::Sub(hn::LoadU(d, &y_[i]), vy),
                 pz = hn::Sub(hn::LoadU(d, &z_[i]), vz);
      const auto square = hn::MulAdd(px, px, hn::MulAdd(py, py, hn::Mul(pz, pz)));
      std::uint64_t left = ~of.outside(px, py, pz, square) & ((std::uint64_t{1} << double_lanes) - 1);
      if (count_ - i < double_lanes) left &= (std::uint64_t{1} << (count_ - i)) - 1;
      for (; left != 0; left &= left - 1)
        visit(static_cast<Local>(id_[i + static_cast<std::size_t>(std::countr_zero(left))]));
    }
  }

 private:
  friend class Candidates;
  void grow(std::size_t count) {
    const std::size_t room = 2 * count + 8 * double_lanes;
    for (auto* const values : {&x_, &y_, &z_}) values->resize(room);
    id_.resize(room);
  }

  std::array<Tile::Range, 3> cells_{};
  std::size_t count_ = 0;
  std::vector<double> x_, y_, z_;
  std::vector<std::int64_t> id_;
};

class Candidates {
 public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  void start_tile(std::size_t points) {
    if (lane_.size() < points) lane_.resize(2 * points);
  }

  /// Replaces the candidates by the points of `block`, except v, within `reach` of v. Single-precision offsets are
  /// multiplied by `inverse`.
  HWY_INLINE void see(const Block& block, const Point3& v, double reach, double inverse) {
    if (block.count_ + 2 * single_lanes > dx_.size()) grow(block.count_);
    const Doubles d;
    const hn::Rebind<float, Doubles> few;
    const hn::RebindToSigned<Doubles> numbers;
    const auto vx = hn::Set(d, v.x), vy = hn::Set(d, v.y), vz = hn::Set(d, v.z), farthest = hn::Set(d, reach * reach);
    const std::size_t in_block = block.count_;
    const double *const x = block.x_.data(), *const y = block.y_.data(), *const z = block.z_.data();
    const std::int64_t* const ids = block.id_.data();
    double *const to_x = dx_.data(), *const to_y = dy_.data(), *const to_z = dz_.data(),
                  *const to_square = square_.data();
    std::int64_t* const to_id = id_.data();
    std::size_t count = 0;
    for (std::size_t i = 0; i < in_block; i += double_lanes) {
      const auto px = hn::Sub(hn::LoadU(d, x + i), vx), py = hn::Sub(hn::LoadU(d, y + i), vy),
                 pz = hn::Sub(hn::LoadU(d, z + i), vz);
      const auto square = hn::MulAdd(px, px, hn::MulAdd(py, py, hn::Mul(pz, pz)));
      std::uint64_t bits = bits_of(d, hn::And(hn::Le(square, farthest), hn::Gt(square, hn::Zero(d))));
      if (in_block - i < double_lanes) bits &= (std::uint64_t{1} << (in_block - i)) - 1;
      const LanesToFront<Doubles> to_front(d, bits);
      hn::StoreU(to_front(px), d, to_x + count);
      hn::StoreU(to_front(py), d, to_y + count);
      hn::StoreU(to_front(pz), d, to_z + count);
      hn::StoreU(to_front(square), d, to_square + count);
      hn::StoreU(hn::BitCast(numbers, to_front(hn::BitCast(d, hn::LoadU(numbers, ids + i)))), numbers, to_id + count);
      count += static_cast<std::size_t>(std::popcount(bits));
    }
    count_ = count;
    const auto scale = hn::Set(d, inverse);
    for (std::size_t i = 0; i < count; i += double_lanes) {
      const auto sx = hn::DemoteTo(few, hn::Mul(hn::LoadU(d, &dx_[i]), scale)),
                 sy = hn::DemoteTo(few, hn::Mul(hn::LoadU(d, &dy_[i]), scale)),
                 sz = hn::DemoteTo(few, hn::Mul(hn::LoadU(d, &dz_[i]), scale));
      hn::StoreU(sx, few, &single_x_[i]);
      hn::StoreU(sy, few, &single_y_[i]);
      hn::StoreU(sz, few, &single_z_[i]);
      hn::StoreU(hn::MulAdd(sx, sx, hn::MulAdd(sy, sy, hn::Mul(sz, sz))), few, &single_square_[i]);
    }
    for (std::size_t i = 0; i < count; ++i) lane_[static_cast<std::size_t>(id_[i])] = static_cast<std::uint16_t>(i);
  }
  Local id(std::size_t at) const { return static_cast<Local>(id_[at]); }

  /// Returns the position of a candidate with nearly the least t among the candidates clearly above the plane, or
  /// `none` if no candidate is. The arguments are in the unit of offsets in single precision: n is a normal of the
  /// plane, `square` is n², and `x` is n² times the x at the head of this file.
  HWY_INLINE std::size_t least(const Vector3<float>& x, const Vector3<float>& n, float square) const {
    const Singles d;
    const SingleNumbers di;
    const Vector3Lanes<hn::Vec<Singles>> to_x = {hn::Set(d, x.x), hn::Set(d, x.y), hn::Set(d, x.z)},
                                         normal = {hn::Set(d, n.x), hn::Set(d, n.y), hn::Set(d, n.z)};
    const auto above = hn::Set(d, 0x1p-17f * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z)));
    const auto nn = hn::Set(d, square), beyond = hn::Set(d, 1e30f);
    // The position replaces the low bits of t, as a value that is nearly the least suffices.
    constexpr std::int32_t position_bits = 1023;
    const auto rough = hn::Set(di, ~position_bits), step = hn::Set(di, static_cast<std::int32_t>(single_lanes)),
               count = hn::Set(di, static_cast<std::int32_t>(count_));
    auto best = beyond;
    auto here = hn::Iota(di, 0);
    for (std::size_t i = 0; i < count_; i += single_lanes) {
      const Vector3Lanes<hn::Vec<Singles>> p = {hn::LoadU(d, &single_x_[i]), hn::LoadU(d, &single_y_[i]),
                                                hn::LoadU(d, &single_z_[i])};
      const auto a = hn::NegMulAdd(
          p.x, to_x.x,
          hn::NegMulAdd(p.y, to_x.y, hn::NegMulAdd(p.z, to_x.z, hn::Mul(nn, hn::LoadU(d, &single_square_[i])))));
      const auto b = dot(p, normal);
      const auto t = hn::Mul(a, hn::ApproximateReciprocal(b));
      const auto marked = hn::BitCast(d, hn::Or(hn::And(hn::BitCast(di, t), rough), here));
      const auto counts = hn::And(hn::Gt(b, above), hn::RebindMask(d, hn::Lt(here, count)));
      best = hn::Min(best, hn::IfThenElse(counts, marked, beyond));
      here = hn::Add(here, step);
    }
    const float smallest = hn::GetLane(hn::MinOfLanes(d, best));
    const auto position = static_cast<std::size_t>(std::bit_cast<std::int32_t>(smallest) & position_bits);
    return smallest < 1e29f && position < count_ ? position : none;
  }

  /// Returns whether all candidates except those at the positions `excluded` are certainly outside of `sphere`.
  HWY_INLINE bool are_outside(const Sphere& sphere, const std::array<std::size_t, 3>& excluded) const {
    constexpr std::size_t word = 64;
    std::uint64_t left = 0;
    for (std::size_t first = 0; first < count_; first += word) left |= not_outside(sphere, excluded, first);
    return left == 0;
  }

  /// Calls visit(i) for each candidate i that is not certainly outside of `sphere`. visit() may change `sphere`.
  template <typename Visit>
  void for_each_not_outside(const Sphere& sphere, Visit visit) const {
    constexpr std::size_t word = 64;
    const Sphere of = sphere;  // a copy, as visit() may change `sphere`
    for (std::size_t first = 0; first < count_; first += word)
      for (std::uint64_t left = not_outside(of, {none, none, none}, first); left != 0; left &= left - 1)
        visit(id(first + static_cast<std::size_t>(std::countr_zero(left))));
  }

  /// Returns the offset from v of the candidate at a position. Spoke::length is not computed.
  HWY_INLINE Spoke spoke(std::size_t at) const { return {dx_[at], dy_[at], dz_[at], square_[at], 0}; }

  /// Returns the position of point i among the candidates, or `none`.
  std::size_t position(Local i) const {
    const std::size_t at = lane_[i];
    return at < count_ && id(at) == i ? at : none;
  }

 private:
  /// Returns a bit for each of the 64 candidates from `first` on, set if the candidate is neither certainly outside of
  /// `sphere` nor at a position in `excluded`.
  HWY_INLINE std::uint64_t not_outside(const Sphere& sphere, const std::array<std::size_t, 3>& excluded,
                                       std::size_t first) const {
    const Doubles d;
    const SphereLanes of(sphere);
    constexpr std::size_t word = 64;
    std::uint64_t outside = 0;
    const std::size_t last = std::min(first + word, count_);
    for (std::size_t i = first; i < last; i += double_lanes)
      outside |=
          of.outside(hn::LoadU(d, &dx_[i]), hn::LoadU(d, &dy_[i]), hn::LoadU(d, &dz_[i]), hn::LoadU(d, &square_[i]))
          << (i - first);
    std::uint64_t left = ~outside;
    if (last - first < word) left &= (std::uint64_t{1} << (last - first)) - 1;
    for (const std::size_t at : excluded)
      if (at - first < word) left &= ~(std::uint64_t{1} << (at - first));
    return left;
  }

  void grow(std::size_t count) {
    const std::size_t room = 2 * count + 4 * single_lanes;
    for (auto* const values : {&dx_, &dy_, &dz_, &square_}) values->resize(room);
    for (auto* const values : {&single_x_, &single_y_, &single_z_, &single_square_}) values->resize(room);
    id_.resize(room);
  }

  std::size_t count_ = 0;
  std::vector<double> dx_, dy_, dz_, square_;
  std::vector<float> single_x_, single_y_, single_z_, single_square_;
  std::vector<std::int64_t> id_;
  std::vector<std::uint16_t> lane_;  // for each point of the tile: its position among the candidates, if any
};

}  // namespace
}  // namespace rbpa::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
