// What: the search window of a pivot: the cells to search for the apex, for sixteen edges at a time, and the test that
//       these cells were enough. Compiled once for each kind of vector unit; HWY_TARGET_TOGGLE is the include guard.
// Law:  a verified apex is the apex among all points: the part of its circle left of the edge lies in the searched
//       cells, where the tile has all points.
#if defined(RBPA_PIVOTS_SEARCH_WINDOW_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_PIVOTS_SEARCH_WINDOW_INL_H_
#undef RBPA_PIVOTS_SEARCH_WINDOW_INL_H_
#else
#define RBPA_PIVOTS_SEARCH_WINDOW_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <limits>

#include "rbpa/plane/pivots/edge_batch.h"
#include "rbpa/plane/tile/coordinates.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

class SearchWindow {
 public:
  using D = hn::CappedTag<float, EdgeBatch::size>;
  static constexpr float slack = 16 * TileCoordinates::unit_roundoff;
  // maximum width of a disc, in chords: a wider one is treated as a half-plane
  static constexpr float max_chords = 0x1p20f;

  /// Keeps references to both arguments.
  SearchWindow(EdgeBatch& edges, const TileCoordinates& coordinates) : edges_(edges), at_(coordinates) {}

  /// Computes the first window of every edge: its cells, its extent, and its points if it fits three short rows.
  HWY_NOINLINE void open() {
    const D d;
    const I di;
    const U du;
    const auto set = [&](float value) { return hn::Set(d, value); };
    for (std::size_t i = 0; i < EdgeBatch::size; i += hn::Lanes(d)) {
      const auto ia = hn::Load(di, edges_.a + i), ib = hn::Load(di, edges_.b + i);
      const V ax = hn::GatherIndex(d, at_.x.data(), ia), ay = hn::GatherIndex(d, at_.y.data(), ia);
      const V bx = hn::GatherIndex(d, at_.x.data(), ib), by = hn::GatherIndex(d, at_.y.data(), ib);
      const V dx = bx - ax, dy = by - ay;
      const V length = hn::Max(hn::Sqrt(dx * dx + dy * dy), set(0x1p-60f));
      const V reach = hn::Max(set(first_reach_in_chords) * length,
                              hn::Min(set(first_reach_in_circles) * hn::Load(d, edges_.expected + i),
                                      set(first_reach_in_cells * at_.cell)));
      const V ratio = hn::Min((reach + reach) / length, set(max_chords));
      const V k = hn::Sqrt(hn::Max(hn::Zero(d), ratio * ratio - set(1)));
      const Box box = box_of(ax, ay, bx, by, k);
      const auto across = box.c1 - box.c0 + hn::Set(di, 1), up = box.r1 - box.r0;
      auto cell = box.r0 * hn::Set(di, at_.columns) + box.c0;
      auto fits = up < hn::Set(di, rows_at_once);
      const auto place_of = [&](auto point, auto first) {
        const auto place = point - first, in_row = hn::And(place, hn::Set(di, static_cast<int>(row_length) - 1));
        return hn::IfThenElseZero(place == in_row, hn::BitCast(di, hn::Shl(hn::Set(du, 1), hn::BitCast(du, in_row))));
      };
      for (int row = 0; row < rows_at_once; ++row) {
        const auto in_box = up > hn::Set(di, row - 1);
        const auto first = hn::GatherIndex(di, at_.start.data(), cell);
        const auto count = hn::IfThenElseZero(in_box, hn::GatherIndex(di, at_.start.data(), cell + across) - first);
        hn::Store(first, di, edges_.first[row] + i);
        hn::Store(count, di, edges_.count[row] + i);
        hn::Store(hn::Or(place_of(ia, first), place_of(ib, first)), di, edges_.ends[row] + i);
        fits = hn::And(fits, count < hn::Set(di, static_cast<int>(row_length) + 1));
        cell = cell + hn::Set(di, at_.columns);
      }
      hn::Store(hn::IfThenElseZero(fits, hn::Set(di, 1)), di, edges_.fits + i);
      hn::Store(k, d, edges_.k + i);
      store_cells(box, i);
      hn::Store(hn::ConvertTo(d, hn::Max(across, hn::Set(di, rows_at_once))) * set(at_.cell), d, edges_.extent + i);
      hn::Store(ax, d, edges_.ax + i);
      hn::Store(ay, d, edges_.ay + i);
      hn::Store(bx, d, edges_.bx + i);
      hn::Store(by, d, edges_.by + i);
    }
  }

  /// Verifies the apex of every edge: the part of its circle left of the edge must lie in the cells of the window,
  /// where the tile has all points. Replaces the window's cells by the cells that this part meets.
  HWY_NOINLINE void verify() {
    const D d;
    const I di;
    for (std::size_t i = 0; i < EdgeBatch::size; i += hn::Lanes(d)) {
      const V high = hn::Load(d, edges_.high + i), infinite = hn::Set(d, infinity);
      const auto is_finite = high < infinite;
      const V k = hn::IfThenElse(is_finite, high, hn::Load(d, edges_.k + i));
      const Box box = box_of(hn::Load(d, edges_.ax + i), hn::Load(d, edges_.ay + i), hn::Load(d, edges_.bx + i),
                             hn::Load(d, edges_.by + i), k);
      const auto beyond = hn::Or(hn::Or(box.c0<hn::Load(di, edges_.c0 + i), box.c1> hn::Load(di, edges_.c1 + i)),
                                 hn::Or(box.r0<hn::Load(di, edges_.r0 + i), box.r1> hn::Load(di, edges_.r1 + i)));
      auto verified = hn::And(is_finite, hn::AndNot(hn::RebindMask(d, beyond), box.inside));
      if (!at_.unknown.empty()) verified = hn::And(verified, hn::RebindMask(d, are_known(box)));
      const auto one = hn::Set(di, 1);
      hn::Store(hn::IfThenElseZero(hn::RebindMask(di, verified), one), di, edges_.is_verified + i);
      hn::Store(hn::IfThenElseZero(hn::RebindMask(di, box.inside), one), di, edges_.is_inside + i);
      store_cells(box, i);
      hn::Store(box.radius, d, edges_.found_radius + i);
    }
  }

  /// A range of cells, and whether the tile has all points of the box that they cover, except those of unknown cells.
  struct Cells {
    int c0, c1, r0, r1;
    bool inside;

    bool contain(const Cells& o) const { return c0 <= o.c0 && o.c1 <= c1 && r0 <= o.r0 && o.r1 <= r1; }
    Cells with(const Cells& o) const {
      return {std::min(c0, o.c0), std::max(c1, o.c1), std::min(r0, o.r0), std::max(r1, o.r1), inside && o.inside};
    }
  };
  bool is_known(const Cells& cells) const {
    return cells.inside && at_.is_known(cells.c0, cells.c1, cells.r0, cells.r1);
  }
  /// Returns the cells that a disc meets left of the chord. Its center is k half-chords left of the chord's middle.
  Cells cells_for(std::size_t edge, float k) const {
    const D d;
    const Box box = box_of(hn::Set(d, edges_.ax[edge]), hn::Set(d, edges_.ay[edge]), hn::Set(d, edges_.bx[edge]),
                           hn::Set(d, edges_.by[edge]), hn::Set(d, k));
    return {hn::GetLane(box.c0), hn::GetLane(box.c1), hn::GetLane(box.r0), hn::GetLane(box.r1),
            hn::AllTrue(d, box.inside)};
  }

 private:
  using I = hn::RebindToSigned<D>;
  using U = hn::RebindToUnsigned<D>;
  using V = hn::Vec<D>;

  static constexpr float infinity = std::numeric_limits<float>::infinity();
  static constexpr int rows_at_once = EdgeBatch::rows_at_once;
  static constexpr int row_length = EdgeBatch::row_length;
  // Measured: a first window of this size contains the apex of nearly all edges, and seldom exceeds three rows.
  static constexpr float first_reach_in_cells = 1;
  static constexpr float first_reach_in_chords = 0.52f;
  static constexpr float first_reach_in_circles = 3;

  /// A box of cells in every lane.
  struct Box {
    hn::Vec<I> c0, c1, r0, r1;
    V radius;
    hn::Mask<D> inside;  // the tile has all points there, except those of unknown cells
  };
  /// Returns the cells that a disc meets left of the chord. Its center is k half-chords left of the chord's middle.
  HWY_INLINE Box box_of(V ax, V ay, V bx, V by, V k) const {
    const D d;
    const I di;
    const auto set = [&](float value) { return hn::Set(d, value); };
    const V half = set(0.5f), one = set(1), zero = hn::Zero(d), half_k = half * k;
    const V dx = bx - ax, dy = by - ay, squared = dx * dx + dy * dy;
    const V x = half * (ax + bx) - half_k * dy, y = half * (ay + by) + half_k * dx;
    const V radius_of_disc = half * hn::Sqrt(squared) * hn::Sqrt(one + k * k);
    const V wide = set(slack) * (one + radius_of_disc + hn::Abs(k));
    const V r = radius_of_disc + wide, chord_reach = half_k * squared, left_x = r * dy, left_y = r * dx;
    const V x_low = hn::IfThenElse(hn::Neg(left_x) <= chord_reach, x - r, hn::Min(ax, bx) - wide);
    const V x_high = hn::IfThenElse(left_x <= chord_reach, x + r, hn::Max(ax, bx) + wide);
    const V y_low = hn::IfThenElse(left_y <= chord_reach, y - r, hn::Min(ay, by) - wide);
    const V y_high = hn::IfThenElse(hn::Neg(left_y) <= chord_reach, y + r, hn::Max(ay, by) + wide);
    const auto cell_of = [&](V at, float from, int count) {
      const V cells = (at - set(from)) * set(at_.per_cell);
      return hn::ConvertTo(di, hn::Max(zero, hn::Min(cells, set(static_cast<float>(count - 1)))));
    };
    return {cell_of(x_low, at_.x0, at_.columns),
            cell_of(x_high, at_.x0, at_.columns),
            cell_of(y_low, at_.y0, at_.rows),
            cell_of(y_high, at_.y0, at_.rows),
            radius_of_disc,
            hn::And(hn::And(x_low >= set(at_.x_low), x_high <= set(at_.x_high)),
                    hn::And(y_low >= set(at_.y_low), y_high <= set(at_.y_high)))};
  }

  HWY_INLINE void store_cells(const Box& box, std::size_t i) {
    const I di;
    hn::Store(box.c0, di, edges_.c0 + i);
    hn::Store(box.c1, di, edges_.c1 + i);
    hn::Store(box.r0, di, edges_.r0 + i);
    hn::Store(box.r1, di, edges_.r1 + i);
  }

  /// Returns whether no unknown cell is in the box; false for boxes of many rows, which are searched otherwise.
  HWY_INLINE hn::Mask<I> are_known(const Box& box) const {
    constexpr int max_rows = 6;
    const I di;
    const auto columns = hn::Set(di, at_.columns), across = box.c1 - box.c0 + hn::Set(di, 1), up = box.r1 - box.r0;
    auto cell = box.r0 * columns + box.c0;
    auto unknown = hn::IfThenElseZero(up > hn::Set(di, max_rows - 1), hn::Set(di, 1));
    for (int row = 0; row < max_rows; ++row) {
      const auto in_box = up > hn::Set(di, row - 1);
      unknown = unknown + hn::GatherIndex(di, at_.unknown.data(), hn::IfThenElseZero(in_box, cell + across)) -
                hn::GatherIndex(di, at_.unknown.data(), hn::IfThenElseZero(in_box, cell));
      cell = cell + columns;
    }
    return unknown == hn::Zero(di);
  }

  EdgeBatch& edges_;
  const TileCoordinates& at_;
};

}  // namespace
}  // namespace rbpa::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
