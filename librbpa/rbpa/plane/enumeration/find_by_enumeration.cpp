#include "rbpa/plane/enumeration/find_by_enumeration.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

#include "rbpa/plane/predicate/predicates.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rbpa/plane/enumeration/find_by_enumeration.cpp"
#include <hwy/foreach_target.h>
// Included last: the code below is compiled once for each kind of vector unit.
#include <hwy/highway.h>

#include "rbpa/base/lanes/lanes-inl.h"
#include "rbpa/plane/enumeration/owned_points-inl.h"
#include "rbpa/plane/tile/circumradius_filter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// An enumeration of triangles for a few points at a time, in steps: find the points near each point, then pairs of the
/// point and a near one, then triples of circumradius ≤ alpha, then the triples that have no point in their circle. The
/// result of a step is a list that is written without a branch: the next entry is always written, and counted only if
/// it belongs to the list.
class Enumeration {
 public:
  Enumeration(const Tile& tile, double alpha, TileWorkspace& workspace, EnumerationWorkspace& own)
      : tile_(tile),
        alpha_(alpha),
        at_(workspace.coordinates),
        front_(workspace.front),
        owned_points_(own),
        near_rim_(own.near_rim),
        scaled_(std::min(alpha * at_.scale, 1.0)),
        reach_(static_cast<float>(2 * scaled_) * (1 + 0x1p-16f) + 0x1p-21f),
        factor_(static_cast<float>(4 * scaled_ * scaled_)) {}

  bool run() {
    constexpr float max_cells = 0.99f;  // so that points within reach of a point lie in the 3 × 3 cells around it
    if (!(reach_ <= max_cells * at_.cell) || !at_.unknown.empty()) return false;
    owned_points_.find(tile_, at_);
    const OwnedPoints::Box& owned = owned_points_.box();
    const OwnedPoints::Box around{owned.x_low - reach_, owned.x_high + reach_, owned.y_low - reach_,
                                  owned.y_high + reach_};
    if (around.x_low < at_.x_low || around.x_high > at_.x_high || around.y_low < at_.y_low ||
        around.y_high > at_.y_high)
      return false;
    front_.begin(tile_.points.size());
    near_rim_.clear();
    const std::size_t columns = static_cast<std::size_t>(at_.columns);
    const int r1 = std::min(at_.row(around.y_high) + 1, at_.rows - 1);
    for (int r = std::max(at_.row(around.y_low) - 1, 0); r <= r1; ++r) {
      const std::int32_t* const row = at_.start.data() + static_cast<std::size_t>(r) * columns;
      const auto c0 = static_cast<std::size_t>(std::max(at_.column(around.x_low) - 1, 0));
      const auto c1 = std::min(static_cast<std::size_t>(at_.column(around.x_high)) + 2, columns);
      const auto end = static_cast<std::size_t>(row[c1]);
      for (auto first = static_cast<std::size_t>(row[c0]); first < end; first += at_once)
        if (!take(r, first, std::min(at_once, end - first))) return false;
    }
    front_.seal(tile_.owned);
    return true;
  }

 private:
  using D = hn::CappedTag<float, 16>;
  using DI = hn::RebindToSigned<D>;
  using V = hn::Vec<D>;
  using Bits = OwnedPoints::Bits;
  using Exact = Predicates<double>;

  static constexpr std::size_t lanes = hn::MaxLanes(D());
  static constexpr std::size_t at_once = 32, rows_at_once = 3;
  static constexpr std::size_t max_near = 48, near_padding = 16;  // bits of a word; one register more is written
  static constexpr std::size_t full = 1024;  // triples; there is room for as many more as one pair can add
  static_assert(max_near < OwnedPoints::word);

  /// A listed point, and the points within its reach, in ascending order; those from `next` on come after the point.
  struct Near {
    alignas(64) float x[max_near + near_padding], y[max_near + near_padding];
    std::int32_t label[max_near + near_padding];
    std::size_t point, place;  ///< its number in the tile, and in the batch
    Bits near;                 ///< a bit for each point around, set if within reach
    std::size_t count, next;
  };

  static std::size_t point_of(std::int32_t label) { return OwnedPoints::point_of(label); }
  bool owns(std::size_t point) const { return tile_.owned[point] != 0; }

  /// Processes `count` points of a row, from `first` on. Returns false if the search would take too long.
  bool take(int row, std::size_t first, std::size_t count) {
    if (!find_rows(row, first, count)) return false;
    listed_ = pairs_ = triples_ = 0;
    for (std::size_t j = 0; j < count; ++j) find_near(j, first + j);
    taken_ += count;
    if (wanted_ > max_wanted()) return false;
    for (std::size_t k = 0; k < listed_; ++k) list_near(near_[k]);
    for (std::size_t k = 0; k < pairs_; ++k) {
      find_triples(pair_[k]);
      if (is_doubtful() || (triples_ > full && !create_empty())) return false;
    }
    return create_empty();
  }

  /// Returns the maximum number of triples; dense points have too many.
  std::size_t max_wanted() const { return 256 + 12 * taken_; }

  /// Returns whether rounding has left too many decisions open. A front (pivots/) is faster then, as a front meets each
  /// of these decisions once.
  bool is_doubtful() const { return doubts_ > 32 + taken_ / 32; }

  /// Finds for each point the points in the 3 × 3 cells around the point, as a range in each of three rows. Returns
  /// false if there are more than max_near points in the cells around one point, that point included.
  bool find_rows(int row, std::size_t first, std::size_t count) {
    const D d;
    const DI di;
    const auto one = hn::Set(di, 1), columns = hn::Set(di, at_.columns);
    const int beyond = at_.rows + 1;  // an empty row
    const int rows[rows_at_once] = {row > 0 ? row - 1 : beyond, row, row + 1 < at_.rows ? row + 1 : beyond};
    for (std::size_t j = 0; j < at_once; j += lanes) {
      const V x = hn::LoadU(d, at_.x.data() + std::min(first + j, tile_.points.size()));
      const auto c = hn::ConvertTo(di, hn::Max(hn::Zero(d), (x - hn::Set(d, at_.x0)) * hn::Set(d, at_.per_cell)));
      const auto c0 = hn::Min(hn::Max(c, one), columns) - one, c1 = hn::Min(c + one + one, columns);
      auto sum = hn::Zero(di);
      for (std::size_t k = 0; k < rows_at_once; ++k) {
        const auto before = hn::Set(di, rows[k] * at_.columns);
        const auto from = hn::GatherIndex(di, at_.start.data(), before + c0),
                   to = hn::GatherIndex(di, at_.start.data(), before + c1);
        hn::Store(from, di, from_[k] + j);
        hn::Store(to, di, to_[k] + j);
        sum = sum + (to - from);
      }
      hn::Store(sum, di, around_ + j);
    }
    return std::all_of(around_, around_ + count,
                       [](std::int32_t around) { return around <= static_cast<std::int32_t>(max_near); });
  }

  /// Lists a point that has at least two later points within reach, if the tile owns the point or some point within
  /// reach. Lists the pairs of the rim, if any.
  HWY_INLINE void find_near(std::size_t j, std::size_t point) {
    const D d;
    const V px = hn::Set(d, at_.x[point]), py = hn::Set(d, at_.y[point]), reach = hn::Set(d, reach_ * reach_);
    Bits near = 0, owned = 0;  // bits of the points around, row by row
    std::size_t place = 0;
    for (std::size_t row = 0; row < rows_at_once; ++row) {
      const auto first = static_cast<std::size_t>(from_[row][j]), count = static_cast<std::size_t>(to_[row][j]) - first;
      Bits in_row = 0;
      std::size_t i = 0;
      do {  // mostly one iteration
        const V x = hn::LoadU(d, at_.x.data() + first + i), y = hn::LoadU(d, at_.y.data() + first + i);
        const V dx = x - px, dy = y - py;
        in_row |= bits_of(d, dx * dx + dy * dy <= reach) << i;
      } while ((i += lanes) < count);
      near |= (in_row & lowest(count)) << place;
      owned |= (owned_points_.from(first) & lowest(count)) << place;
      place += count;
    }
    const std::size_t self =
        static_cast<std::size_t>(to_[0][j] - from_[0][j]) + point - static_cast<std::size_t>(from_[1][j]);
    const bool is_owned = owned >> self & 1;
    near &= ~(Bits{1} << self);
    if (is_owned && (near & ~owned) != 0) [[unlikely]]
      list_rim(j, point, near, owned);
    Near& listed = near_[listed_];
    listed.point = point;
    listed.place = j;
    listed.near = near;
    listed.next = static_cast<std::size_t>(std::popcount(near & lowest(self)));
    const auto after = static_cast<std::size_t>(std::popcount(near >> self));
    const bool is_listed = (after > 1) & (is_owned | ((near & owned) != 0));
    listed_ += is_listed;
    wanted_ += is_listed * (after * (after - 1) / 2);
  }

  /// Lists a pair of the point and each near point. The tile owns the first point of each pair. Requires: the tile owns
  /// the point, but not all near points.
  HWY_NOINLINE void list_rim(std::size_t j, std::size_t point, Bits near, Bits owned) {
    const std::size_t first = static_cast<std::size_t>(from_[0][j]), second = static_cast<std::size_t>(from_[1][j]),
                      third = static_cast<std::size_t>(from_[2][j]);
    const std::size_t of_first = static_cast<std::size_t>(to_[0][j]) - first,
                      of_both = of_first + static_cast<std::size_t>(to_[1][j]) - second;
    const std::uint32_t site = tile_.site[point];
    for (Bits left = near; left != 0; left &= left - 1) {
      const auto place = static_cast<std::size_t>(std::countr_zero(left));
      const std::size_t in_row[] = {first + place, second + place - of_first, third + place - of_both};
      const std::uint32_t other = tile_.site[in_row[(place >= of_first) + (place >= of_both)]];
      const std::uint32_t swap = (owned >> place & 1) != 0 ? site ^ other : 0;
      near_rim_.push_back({site ^ swap, other ^ swap});
    }
  }

  /// Gathers the points near a listed point, and lists its pairs with the later near points, except the last of these:
  /// a third point must come after both.
  HWY_INLINE void list_near(Near& near) {
    const D d;
    const DI di;
    std::size_t count = 0;
    Bits bits = near.near;
    for (std::size_t row = 0; row < rows_at_once; ++row) {
      const auto first = static_cast<std::size_t>(from_[row][near.place]),
                 around = static_cast<std::size_t>(to_[row][near.place]) - first;
      std::size_t i = 0;
      do {
        const Bits here = bits >> i & lowest(std::min(lanes, around - i));
        const auto is_near = mask_of(d, here);
        hn::StoreU(hn::Compress(hn::LoadU(d, at_.x.data() + first + i), is_near), d, near.x + count);
        hn::StoreU(hn::Compress(hn::LoadU(d, at_.y.data() + first + i), is_near), d, near.y + count);
        hn::StoreU(hn::Compress(hn::LoadU(di, owned_points_.labels() + first + i), hn::RebindMask(di, is_near)), di,
                   near.label + count);
        count += static_cast<std::size_t>(std::popcount(here));
      } while ((i += lanes) < around);
      bits >>= around;
    }
    near.count = count;
    // Whole registers are written; only the first entries count.
    const auto number = static_cast<std::size_t>(&near - near_);
    auto pairs = hn::ShiftLeft<of_second>(hn::Iota(di, 0)) +
                 hn::Set(di, static_cast<std::int32_t>(number << of_point | near.next << of_second));
    for (std::size_t v = near.next; v < count; v += lanes) {
      hn::StoreU(pairs, di, pair_ + pairs_ + (v - near.next));
      pairs = pairs + hn::Set(di, static_cast<std::int32_t>(lanes << of_second));
    }
    pairs_ += count - near.next - 1;
  }

  /// Lists the triples of a pair and a later near point with a circumradius ≤ alpha and a corner that the tile owns.
  HWY_INLINE void find_triples(std::int32_t pair) {
    const D d;
    const DI di;
    const auto bits = static_cast<std::size_t>(pair);
    const std::size_t second = bits >> of_second & max_number;
    const Near& near = near_[bits >> of_point];
    const V px = hn::Set(d, at_.x[near.point]), py = hn::Set(d, at_.y[near.point]), qx = hn::Set(d, near.x[second]),
            qy = hn::Set(d, near.y[second]), factor = hn::Set(d, factor_);
    const bool is_owned = owns(near.point) | ((near.label[second] & 1) != 0);
    const auto one = hn::Set(di, 1), wanted = hn::Set(di, is_owned ? -1 : 0);
    for (std::size_t v = (second + 1) / lanes * lanes; v < near.count; v += lanes) {
      const auto [inside, outside, cross] =
          filter_circumradius(d, px, py, qx, qy, hn::LoadU(d, near.x + v), hn::LoadU(d, near.y + v), factor);
      const auto place = hn::Iota(di, 0) + hn::Set(di, static_cast<std::int32_t>(v));
      const auto label = hn::LoadU(di, near.label + v);
      const auto in_list = hn::And(place > hn::Set(di, static_cast<std::int32_t>(second)),
                                   place < hn::Set(di, static_cast<std::int32_t>(near.count)));
      const auto here = hn::RebindMask(d, hn::And(in_list, hn::And(label, one) > wanted)), sure = hn::And(here, inside);
      if (!hn::AllFalse(d, hn::AndNot(hn::Or(inside, outside), here))) [[unlikely]] {
        const Bits uncertain = bits_of(d, hn::AndNot(hn::Or(inside, outside), here));
        list_exactly(pair, v, bits_of(d, sure), uncertain, bits_of(d, cross < hn::Zero(d)));
        continue;
      }
      const auto is_right = hn::IfThenElseZero(hn::RebindMask(di, cross < hn::Zero(d)), hn::Set(di, 1));
      const auto third = hn::ShiftLeft<of_third>(place);
      const auto triples = hn::Or(hn::Or(hn::Set(di, pair), third), is_right);
      hn::StoreU(hn::Compress(triples, hn::RebindMask(di, sure)), di, triple_ + triples_);
      triples_ += hn::CountTrue(d, sure);
    }
  }

  void list(std::int32_t pair, std::size_t third, bool is_right) {
    triple_[triples_++] = pair | static_cast<std::int32_t>(third << of_third | std::size_t{is_right});
  }

  /// Lists the triples of a pair with near points from number v on that are `sure`, or `uncertain` and pass exact
  /// tests.
  HWY_NOINLINE void list_exactly(std::int32_t pair, std::size_t v, Bits sure, Bits uncertain, Bits right) {
    const std::size_t second = static_cast<std::size_t>(pair) >> of_second & max_number;
    const Near& near = near_[static_cast<std::size_t>(pair) >> of_point];
    const Point &a = tile_.points[near.point], &b = tile_.points[point_of(near.label[second])];
    for (Bits left = sure | uncertain; left != 0; left &= left - 1) {
      const auto third = static_cast<std::size_t>(std::countr_zero(left));
      if (sure >> third & 1) {
        list(pair, v + third, (right >> third & 1) != 0);
        continue;
      }
      ++doubts_;
      const Point& c = tile_.points[point_of(near.label[v + third])];
      const int turn = Exact::orientation(a, b, c);
      if (turn != 0 && Exact::compare_circumradius(a, b, c, alpha_) <= 0) list(pair, v + third, turn < 0);
    }
  }

  /// Makes triangles of the triples with an empty circle. Returns false if rounding leaves too many decisions open.
  bool create_empty() {
    const D d;
    std::size_t triangles = 0;
    for (std::size_t k = 0; k < triples_; ++k) {
      const auto bits = static_cast<std::size_t>(triple_[k]);
      const std::size_t second = bits >> of_second & max_number, third = bits >> of_third & max_number;
      const bool is_right = bits & 1;
      const std::size_t b = is_right ? third : second, c = is_right ? second : third;
      const Near& near = near_[bits >> of_point];
      const std::size_t p = near.point;
      const V px = hn::Set(d, at_.x[p]), py = hn::Set(d, at_.y[p]);
      const V qx = hn::Set(d, near.x[b]) - px, qy = hn::Set(d, near.y[b]) - py;
      const V sx = hn::Set(d, near.x[c]) - px, sy = hn::Set(d, near.y[c]) - py;
      const V q = qx * qx + qy * qy, s = sx * sx + sy * sy;
      const V cross = qx * sy - qy * sx, of_x = q * sy - s * qy, of_y = s * qx - q * sx;
      const V extent = hn::Max(hn::Max(hn::Abs(qx), hn::Abs(qy)), hn::Max(hn::Abs(sx), hn::Abs(sy)));
      Bits outside = 0, inside = 0;
      for (std::size_t v = 0; v < near.count; v += lanes) {
        const V x = hn::LoadU(d, near.x + v) - px, y = hn::LoadU(d, near.y + v) - py;
        const V size = hn::Max(extent, hn::Max(hn::Abs(x), hn::Abs(y)));
        const V error = error_of_difference(d, size), largest = size + error, square = largest * largest;
        const V bound =
            hn::Set(d, 1.02f) * (error * (hn::Set(d, 130) * (largest * square) + hn::Set(d, 70) * (error * square)));
        const V excess = cross * (x * x + y * y) - (x * of_x + y * of_y);
        outside |= bits_of(d, excess > bound) << v;
        inside |= bits_of(d, excess < hn::Neg(bound)) << v;
      }
      const Bits others = lowest(near.count) & ~(Bits{1} << second | Bits{1} << third);
      const Bits uncertain = others & ~outside;
      bool is_empty = uncertain == 0;
      if (uncertain != 0 && (uncertain & inside) == 0) [[unlikely]] {
        is_empty = !is_any_inside(near, p, b, c, uncertain);
        if (is_doubtful()) return false;
      }
      corners_[triangles] = {static_cast<LocalFront::Index>(p), static_cast<LocalFront::Index>(point_of(near.label[b])),
                             static_cast<LocalFront::Index>(point_of(near.label[c]))};
      triangles += is_empty;
    }
    for (std::size_t k = 0; k < triangles; ++k)
      front_.create(corners_[k][0], corners_[k][1], corners_[k][2], [](LocalFront::Index, bool) {});
    triples_ = 0;
    return true;
  }

  HWY_NOINLINE bool is_any_inside(const Near& near, std::size_t p, std::size_t q, std::size_t s, Bits uncertain) {
    const auto at = [&](std::size_t i) -> const Point& { return tile_.points[point_of(near.label[i])]; };
    for (; uncertain != 0; uncertain &= uncertain - 1) {
      ++doubts_;
      if (Exact::in_perturbed_circle(tile_.points[p], at(q), at(s),
                                     at(static_cast<std::size_t>(std::countr_zero(uncertain)))) > 0)
        return true;
    }
    return false;
  }

  static Bits lowest(std::size_t count) { return (Bits{1} << count) - 1; }

  // A pair or a triple in one number: the number of the listed point, and the positions of the other corners among the
  // points near that point.
  //   triple:  31 … 16  number of the listed point
  //            15 … 10  second corner    9 … 4  third corner    0  whether to exchange both
  static constexpr int of_point = 16, of_second = 10, of_third = 4;
  static constexpr std::size_t max_number = 63;
  static_assert(max_near + near_padding <= max_number + 1 && at_once < 1u << (31 - of_point));

  const Tile& tile_;
  double alpha_;
  const TileCoordinates& at_;
  LocalFront& front_;
  OwnedPoints owned_points_;
  std::vector<TilePatch::Neighbors>& near_rim_;
  double scaled_;  // alpha in the scale of the tile's coordinates, but at most 1
  float reach_, factor_;
  std::size_t listed_ = 0, pairs_ = 0, triples_ = 0, doubts_ = 0;
  std::size_t taken_ = 0, wanted_ = 0;  // number of points processed, and of triples that begin with these points
  alignas(64) std::int32_t from_[rows_at_once][at_once], to_[rows_at_once][at_once], around_[at_once];
  Near near_[at_once + 1];
  std::int32_t pair_[at_once * max_near + near_padding], triple_[full + 2 * max_near];
  std::array<LocalFront::Index, 3> corners_[full + 2 * max_near];
};

bool enumerate_on(const Tile& tile, double alpha, TileWorkspace& workspace, EnumerationWorkspace& own) {
  return Enumeration(tile, alpha, workspace, own).run();
}

}  // namespace
}  // namespace rbpa::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rbpa {

HWY_EXPORT(enumerate_on);

bool find_by_enumeration(const Tile& tile, const Radius& alpha, TileWorkspace& workspace, EnumerationWorkspace& own,
                         TilePatch& found) {
  if (alpha.is_infinite() || !HWY_DYNAMIC_DISPATCH(enumerate_on)(tile, alpha.value(), workspace, own)) return false;
  // All triangles found are within alpha: an infinite radius filters nothing.
  extract_patch(tile, workspace.coordinates, workspace.front, Radius(), workspace.extraction, found);
  found.unsettled_neighbors.insert(found.unsettled_neighbors.end(), own.near_rim.begin(), own.near_rim.end());
  return true;
}

}  // namespace rbpa
#endif
