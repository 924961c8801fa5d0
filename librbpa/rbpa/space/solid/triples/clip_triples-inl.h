// What: finds the sides of triangles (v, q, r) on which there may be a tetrahedron whose fourth corner comes after r,
//       for a register of triangles together.
// Law:  conservative: a side that is not found has no tetrahedron. Bounds: docs/explanation/space.md, sections 8 to 10.
// How:  in units of alpha, with v at the origin: centers of balls through the triangle are x/2 + t n, with n = q × r
//       and x = (|q|² r − |r|² q) × n / n². Such a ball contains p unless t b ≤ a, for a = p² − p · x and b = 2 p · n.
//       Where the center is within one alpha of v, |t| |n| ≤ 1, so that a − t b is off by at most E = 300 u κ, κ = |q|
//       |r| / |n|; the code uses 512 in place of 300. Quotients (a + E) / b give bounds L and U of the values of t that
//       no point excludes; an apex after r has no t before (a − E) / b.
//
//            L            A      U     T        t
//       -----|------------|------|-----|------->    A: least (a − E) / b of a point after r. Tried if A ≤ U and L ≤ U.
#if defined(RBPA_SPACE_TRIPLES_CLIP_TRIPLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_SPACE_TRIPLES_CLIP_TRIPLES_INL_H_
#undef RBPA_SPACE_TRIPLES_CLIP_TRIPLES_INL_H_
#else
#define RBPA_SPACE_TRIPLES_CLIP_TRIPLES_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rbpa/base/lanes/lanes-inl.h"
#include "rbpa/space/solid/triples/near_points-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::space::HWY_NAMESPACE {
namespace {

using rbpa::HWY_NAMESPACE::bits_of;
using rbpa::HWY_NAMESPACE::Vector3Lanes;

using Single = hn::Vec<Singles>;

using Vector = Vector3Lanes<Single>;

/// Pairs (q, r) of points after v, stored as q << 16 | r with positions among the points near v.
class Pairs {
 public:
  /// Lists the pairs (q, r) with q before r for which the triangle (v, q, r) may have a circumradius of at most alpha.
  HWY_INLINE void list(const NearPoints& near) {
    const Singles d;
    const SingleNumbers di;
    const auto step = hn::Iota(di, 0);
    const std::size_t after = near.after();
    if (const std::size_t most = after * after / 2 + 2 * single_lanes; pairs_.size() < most) pairs_.resize(2 * most);
    count_ = 0;
    for (std::size_t q = 0; q + 1 < after; ++q) {
      const Vector at_q = {hn::Set(d, near.x[q]), hn::Set(d, near.y[q]), hn::Set(d, near.z[q])};
      const Single qq = hn::Set(d, near.square[q]);
      for (std::size_t r = q + 1; r < after; r += single_lanes) {
        const Vector at_r = {hn::LoadU(d, &near.x[r]), hn::LoadU(d, &near.y[r]), hn::LoadU(d, &near.z[r])};
        const Single rr = hn::LoadU(d, &near.square[r]);
        const Vector n = cross(at_q, at_r),
                     side = {hn::Sub(at_r.x, at_q.x), hn::Sub(at_r.y, at_q.y), hn::Sub(at_r.z, at_q.z)};
        // q² r² (q − r)² ≤ 4 n². The error of n is at most 6u |q| |r|; that of n² is less than 2⁻⁷ n² + 2⁻³⁴ q² r².
        const Single squares = hn::Mul(qq, rr);
        const Single underflow = hn::Set(d, 0x1p-120f);
        const Single most =
            hn::MulAdd(hn::Set(d, 4.0625f), dot(n, n), hn::MulAdd(hn::Set(d, 0x1p-31f), squares, underflow));
        auto keep = hn::Le(hn::Mul(squares, dot(side, side)), most);
        if (after - r < single_lanes) keep = hn::And(keep, hn::FirstN(d, after - r));
        const auto number = hn::Add(step, hn::Set(di, static_cast<std::int32_t>(q << 16 | r)));
        hn::StoreU(hn::Compress(number, hn::RebindMask(di, keep)), di, &pairs_[count_]);
        count_ += hn::CountTrue(d, keep);
      }
    }
    for (std::size_t i = count_; i < count_ + single_lanes; ++i) pairs_[i] = 1;  // any valid pair
  }
  std::size_t size() const { return count_; }
  const std::int32_t* operator[](std::size_t i) const { return &pairs_[i]; }

 private:
  std::vector<std::int32_t> pairs_;
  std::size_t count_ = 0;
};

/// Bits of the lanes to be tried on the side of positive t, and on the side of negative t.
struct Sides {
  std::uint64_t positive, negative;
};

/// A lookup of values in a table: by permutations if the table fits one or two registers, else by loads.
template <int kRegisters>
class Lookup {
 public:
  HWY_INLINE explicit Lookup(hn::Vec<SingleNumbers> positions) : positions_(positions) {}

  HWY_INLINE Single operator()(const std::vector<float>& table) const {
    const Singles d;
    if constexpr (kRegisters > 2) {
      return hn::GatherIndex(d, table.data(), positions_);
    } else {
      const SingleNumbers di;
      const auto in_register = hn::And(positions_, hn::Set(di, static_cast<std::int32_t>(single_lanes - 1)));
      const auto indices = hn::IndicesFromVec(d, in_register);
      const Single low = hn::TableLookupLanes(hn::LoadU(d, table.data()), indices);
      if constexpr (kRegisters == 1) return low;
      const Single high = hn::TableLookupLanes(hn::LoadU(d, table.data() + single_lanes), indices);
      const auto is_low = hn::Lt(positions_, hn::Set(di, static_cast<std::int32_t>(single_lanes)));
      return hn::IfThenElse(hn::RebindMask(d, is_low), low, high);
    }
  }

 private:
  hn::Vec<SingleNumbers> positions_;
};

/// The triangles (v, q, r) of a register of pairs (q, r), with their planes, lines of centers and bounds of errors.
template <int kRegisters>
class Triangles {
 public:
  HWY_INLINE Triangles(const NearPoints& near, const std::int32_t* pairs) : near_(near) {
    const Singles d;
    const SingleNumbers di;
    constexpr float roundoff = 0x1p-24f;
    const auto pair = hn::LoadU(di, pairs);
    r_number = hn::And(pair, hn::Set(di, 0xffff));
    const Lookup<kRegisters> of_q(hn::ShiftRight<16>(pair)), of_r(r_number);
    const Vector q = {of_q(near.x), of_q(near.y), of_q(near.z)}, r = {of_r(near.x), of_r(near.y), of_r(near.z)};
    const Single qq = of_q(near.square), rr = of_r(near.square), one = hn::Set(d, 1.0f);
    const Vector n = cross(q, r);
    const Single inverse = hn::Div(one, dot(n, n)), squares = hn::Mul(qq, rr);
    const Vector m = {hn::MulSub(qq, r.x, hn::Mul(rr, q.x)), hn::MulSub(qq, r.y, hn::Mul(rr, q.y)),
                      hn::MulSub(qq, r.z, hn::Mul(rr, q.z))};
    const Vector along = cross(m, n);
    x_ = {hn::Mul(along.x, inverse), hn::Mul(along.y, inverse), hn::Mul(along.z, inverse)};
    twice_n_ = {hn::Add(n.x, n.x), hn::Add(n.y, n.y), hn::Add(n.z, n.z)};
    const Single kappa = hn::Sqrt(hn::Mul(squares, inverse));
    error_ = hn::Mul(hn::Set(d, 512 * roundoff), kappa);
    const Single left =
        hn::Sub(hn::Add(one, error_), hn::Mul(hn::Set(d, 0.25f), dot(x_, x_)));  // alpha² − x²/4, at most
    farthest = hn::Mul(hn::Sqrt(hn::Mul(hn::Max(left, hn::Zero(d)), inverse)), hn::Set(d, 1.001f));
    least_b = hn::Mul(hn::Set(d, 64 * roundoff), hn::Sqrt(squares));
    is_small = hn::Ge(left, hn::Zero(d));
    is_bounded = hn::And(hn::Lt(kappa, hn::Set(d, 0x1p13f)), hn::Ge(squares, hn::Set(d, 0x1p-60f)));
  }

  /// The rounded values of a near point: b, t = a / b, and error = E / b.
  struct Cut {
    Single b, t, error;
  };
  HWY_INLINE Cut cut(std::size_t p) const {
    const Singles d;
    const Vector at = {hn::Set(d, near_.x[p]), hn::Set(d, near_.y[p]), hn::Set(d, near_.z[p])};
    const Single square = hn::Set(d, near_.square[p]);
    const Single a = hn::NegMulAdd(at.x, x_.x, hn::NegMulAdd(at.y, x_.y, hn::NegMulAdd(at.z, x_.z, square)));
    const Single b = dot(at, twice_n_), over = hn::ApproximateReciprocal(b);
    return {b, hn::Mul(a, over), hn::Mul(error_, over)};
  }

  hn::Vec<SingleNumbers> r_number;  ///< position of r among the near points
  Single farthest, least_b;         ///< T, the greatest |t| for radius alpha; bound of the error of b
  hn::Mask<Singles> is_small;       ///< the circumradius of the triangle may be at most alpha
  hn::Mask<Singles> is_bounded;     ///< the error bounds hold; false for nearly degenerate triangles and NaN

 private:
  const NearPoints& near_;
  Vector x_, twice_n_;
  Single error_;
};

/// Returns t + 2⁻⁶ |t|, or t − 2⁻⁶ |t|: the change is more than the error of an approximate reciprocal.
HWY_INLINE Single raised(Single t) { return hn::MulAdd(hn::Set(Singles(), 0x1p-6f), hn::Abs(t), t); }
HWY_INLINE Single lowered(Single t) { return hn::NegMulAdd(hn::Set(Singles(), 0x1p-6f), hn::Abs(t), t); }

/// Pairs (q, r) whose line of centers has an interval from L to U that no near point excludes.
class OpenTriangles {
 public:
  void clear() { count_ = 0; }
  std::size_t size() const { return count_; }

  /// Appends the open pairs among the first `used` pairs of a register.
  template <int kRegisters>
  HWY_INLINE void append(const NearPoints& near, const std::int32_t* pairs, std::size_t used) {
    const Singles d;
    const SingleNumbers di;
    const Single zero = hn::Zero(d);
    const Triangles<kRegisters> triangles(near, pairs);
    Single upper = triangles.farthest, lower = hn::Neg(upper);
    const std::size_t size = near.size();
    for (std::size_t p = 0; p < size; ++p) {
      const auto cut = triangles.cut(p);
      const Single weak = hn::Add(cut.t, cut.error);
      upper = hn::IfThenElse(hn::Gt(cut.b, zero), hn::Min(weak, upper), upper);
      lower = hn::IfThenElse(hn::Lt(cut.b, zero), hn::Max(weak, lower), lower);
    }
    upper = raised(upper);
    lower = lowered(lower);
    auto is_open = hn::Or(hn::And(hn::Le(lower, upper), triangles.is_small), hn::Not(triangles.is_bounded));
    if (used < single_lanes) is_open = hn::And(is_open, hn::FirstN(d, used));
    if (pairs_.size() < count_ + 2 * single_lanes) {
      const std::size_t room = 2 * count_ + 4 * single_lanes;
      pairs_.resize(room);
      upper_.resize(room);
      lower_.resize(room);
    }
    hn::StoreU(hn::Compress(hn::LoadU(di, pairs), hn::RebindMask(di, is_open)), di, &pairs_[count_]);
    hn::StoreU(hn::Compress(upper, is_open), d, &upper_[count_]);
    hn::StoreU(hn::Compress(lower, is_open), d, &lower_[count_]);
    count_ += hn::CountTrue(d, is_open);
  }

  /// Returns the sides to be tried of the open triangles in a register, from triangle i on.
  template <int kRegisters>
  HWY_INLINE Sides sides(const NearPoints& near, std::size_t i) {
    const Singles d;
    const SingleNumbers di;
    const Single zero = hn::Zero(d), beyond = hn::Set(d, 1e30f);
    if (count_ - i < single_lanes) std::fill_n(&pairs_[count_], single_lanes, 1);  // any valid pair
    const Triangles<kRegisters> triangles(near, &pairs_[i]);
    Single first_above = beyond, first_below = hn::Neg(beyond), nearest_b = beyond;
    const std::size_t after = near.after();
    for (std::size_t p = static_cast<std::size_t>(pairs_[i] >> 16) + 2; p < after; ++p) {
      const auto cut = triangles.cut(p);
      const Single strong = hn::Sub(cut.t, cut.error);
      const auto is_later = hn::RebindMask(d, hn::Gt(hn::Set(di, static_cast<std::int32_t>(p)), triangles.r_number));
      const auto is_above = hn::And(hn::Gt(cut.b, zero), is_later), is_below = hn::And(hn::Lt(cut.b, zero), is_later);
      first_above = hn::IfThenElse(is_above, hn::Min(strong, first_above), first_above);
      first_below = hn::IfThenElse(is_below, hn::Max(strong, first_below), first_below);
      nearest_b = hn::IfThenElse(is_later, hn::Min(hn::Abs(cut.b), nearest_b), nearest_b);
    }
    const auto is_any = hn::Or(hn::Le(nearest_b, triangles.least_b), hn::Not(triangles.is_bounded));
    const auto is_above = hn::Le(lowered(first_above), hn::LoadU(d, &upper_[i]));
    const auto is_below = hn::Ge(raised(first_below), hn::LoadU(d, &lower_[i]));
    const std::uint64_t used = count_ - i < single_lanes ? (std::uint64_t{1} << (count_ - i)) - 1 : ~std::uint64_t{0};
    return {bits_of(d, hn::Or(is_above, is_any)) & used, bits_of(d, hn::Or(is_below, is_any)) & used};
  }

  /// Returns the position of q, or r, of open triangle i among the near points.
  std::size_t q(std::size_t i) const { return static_cast<std::size_t>(pairs_[i] >> 16); }
  std::size_t r(std::size_t i) const { return static_cast<std::size_t>(pairs_[i] & 0xffff); }

 private:
  std::vector<std::int32_t> pairs_;
  std::vector<float> upper_, lower_;
  std::size_t count_ = 0;
};

}  // namespace
}  // namespace rbpa::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
