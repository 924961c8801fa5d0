// What: which point does a ball that rolls over a→b to its left touch first? For sixteen edges at a time, on the points
//       of a tile. Compiled once for each kind of vector unit; no include guard but the compiler's own per kind.
// Law:  the answer is that of Pivot, or none where the tile's points do not tell it.
// How:  as pivot/candidate.h: the circle through a, b and p has its centre k half-chords left of the chord's middle, and
//       the least k wins. Bounds in single precision leave one point nearly always; exact arithmetic decides the rest.
#if defined(RBPA_TILE_CONTEST_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_TILE_CONTEST_INL_H_
#undef RBPA_TILE_CONTEST_INL_H_
#else
#define RBPA_TILE_CONTEST_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "rbpa/predicate/predicates.h"
#include "rbpa/tile/coordinates.h"
#include "rbpa/tile/tile.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

class Contest {
 public:
  using Index = std::uint16_t;
  static constexpr Index none = 0xffff;
  static constexpr std::size_t batch = 16;

  /// The edges to be asked, and how large a circle is worth a look at first: that of a triangle at the edge. One more of
  /// each, so that a loop may write before it looks.
  alignas(64) std::int32_t a[batch + 1], b[batch + 1];
  alignas(64) float expected[batch + 1];
  /// The answers, and the radii of the circles.
  Index apex[batch];
  alignas(64) float found_radius[batch];

  /// Keeps references.
  Contest(const Tile& tile, const TileCoordinates& coordinates)
      : tile_(tile),
        at_(coordinates),
        low_(tile.points.size() + batch * static_cast<std::size_t>(tile.rows)),
        base_(low_.size()) {
    std::fill_n(high_, batch, infinity);
  }

  /// Finds the apexes of the first `size` edges, at least one.
  void run(std::size_t size) {
    for (std::size_t i = size; i < batch; ++i) {
      a[i] = a[0];
      b[i] = b[0];
      expected[i] = expected[0];
    }
    look_around();
    for (std::size_t i = 0; i < size; ++i) apex[i] = among_three_rows(i);
    certify();
    for (std::size_t i = 0; i < size; ++i)
      if (!is_certain_[i]) apex[i] = search(i);
  }

  /// One edge.
  Index operator()(Index from, Index to) {
    a[0] = from;
    b[0] = to;
    expected[0] = infinity;
    run(1);
    return apex[0];
  }

 private:
  using P = Predicates<double>;
  using D = hn::CappedTag<float, batch>;
  using I = hn::RebindToSigned<D>;
  using U = hn::RebindToUnsigned<D>;
  using V = hn::Vec<D>;

  static constexpr float infinity = std::numeric_limits<float>::infinity();
  static constexpr float unit = 0x1p-24f;  // of one rounding
  static constexpr float slack = 16 * unit;
  static constexpr int rows_at_once = 3;
  static constexpr std::size_t row_length = 16;  // points of a row that are looked at at once
  // Measured: a first look this far finds the apex of nearly all edges, and seldom has to leave three rows.
  static constexpr float first_reach_in_cells = 1;
  static constexpr float first_reach_in_chords = 0.52f;
  static constexpr float first_reach_in_circles = 3;
  static constexpr std::size_t most_contenders = 64;
  static constexpr float most_reach = 4;  // the whole tile, from any point of it

  /// A box of cells in every lane.
  struct Box {
    hn::Vec<I> c0, c1, r0, r1;
    V radius;
    hn::Mask<D> inside;  // all points are known there, but for those of unknown cells
  };
  /// The cells of what lies left of the chord in the disc whose centre is k half-chords left of the chord's middle.
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
    hn::Store(box.c0, di, c0_ + i);
    hn::Store(box.c1, di, c1_ + i);
    hn::Store(box.r0, di, r0_ + i);
    hn::Store(box.r1, di, r1_ + i);
  }

  /// Where to look first, for all edges.
  HWY_NOINLINE void look_around() {
    const D d;
    const I di;
    const U du;
    const auto set = [&](float value) { return hn::Set(d, value); };
    for (std::size_t i = 0; i < batch; i += hn::Lanes(d)) {
      const auto ia = hn::Load(di, a + i), ib = hn::Load(di, b + i);
      const V ax = hn::GatherIndex(d, at_.x.data(), ia), ay = hn::GatherIndex(d, at_.y.data(), ia);
      const V bx = hn::GatherIndex(d, at_.x.data(), ib), by = hn::GatherIndex(d, at_.y.data(), ib);
      const V dx = bx - ax, dy = by - ay;
      const V length = hn::Max(hn::Sqrt(dx * dx + dy * dy), set(0x1p-60f));
      const V reach = hn::Max(
          set(first_reach_in_chords) * length,
          hn::Min(set(first_reach_in_circles) * hn::Load(d, expected + i), set(first_reach_in_cells * at_.cell)));
      const V ratio = hn::Min((reach + reach) / length, set(0x1p20f));
      const V k = hn::Sqrt(hn::Max(hn::Zero(d), ratio * ratio - set(1)));
      const Box box = box_of(ax, ay, bx, by, k);
      const auto across = box.c1 - box.c0 + hn::Set(di, 1), up = box.r1 - box.r0;
      auto cell = box.r0 * hn::Set(di, at_.columns) + box.c0;
      auto unknown = hn::Zero(di);
      auto fits = up < hn::Set(di, rows_at_once);
      const auto place_of = [&](auto point, auto first) {
        const auto place = point - first, in_row = hn::And(place, hn::Set(di, static_cast<int>(row_length) - 1));
        return hn::IfThenElseZero(place == in_row, hn::BitCast(di, hn::Shl(hn::Set(du, 1), hn::BitCast(du, in_row))));
      };
      for (int row = 0; row < rows_at_once; ++row) {
        const auto in_box = up > hn::Set(di, row - 1);
        const auto first = hn::GatherIndex(di, at_.start.data(), cell);
        const auto count = hn::IfThenElseZero(in_box, hn::GatherIndex(di, at_.start.data(), cell + across) - first);
        if (!at_.unknown.empty())
          unknown = unknown + hn::IfThenElseZero(in_box, hn::GatherIndex(di, at_.unknown.data(), cell + across) -
                                                             hn::GatherIndex(di, at_.unknown.data(), cell));
        hn::Store(first, di, first_[row] + i);
        hn::Store(count, di, count_[row] + i);
        hn::Store(hn::Or(place_of(ia, first), place_of(ib, first)), di, ends_[row] + i);
        fits = hn::And(fits, count < hn::Set(di, static_cast<int>(row_length) + 1));
        cell = cell + hn::Set(di, at_.columns);
      }
      fits = hn::And(fits, unknown == hn::Zero(di));
      hn::Store(hn::IfThenElseZero(fits, hn::Set(di, 1)), di, fits_ + i);
      hn::Store(k, d, k_ + i);
      store_cells(box, i);
      hn::Store(hn::ConvertTo(d, hn::Max(across, hn::Set(di, rows_at_once))), d, extent_ + i);
      hn::Store(ax, d, ax_ + i);
      hn::Store(ay, d, ay_ + i);
      hn::Store(bx, d, bx_ + i);
      hn::Store(by, d, by_ + i);
    }
    for (std::size_t i = 0; i < batch; ++i) bound_errors(i, extent_[i]);
  }

  /// Which answers are certain: the circle lies in the cells that were looked at, and where all points are known. Leaves
  /// the cells in which to look for the others.
  HWY_NOINLINE void certify() {
    const D d;
    const I di;
    for (std::size_t i = 0; i < batch; i += hn::Lanes(d)) {
      const V high = hn::Load(d, high_ + i), infinite = hn::Set(d, infinity);
      const auto is_finite = high < infinite;
      const V k = hn::IfThenElse(is_finite, high, hn::Load(d, k_ + i));
      const Box box = box_of(hn::Load(d, ax_ + i), hn::Load(d, ay_ + i), hn::Load(d, bx_ + i), hn::Load(d, by_ + i), k);
      const auto beyond = hn::Or(hn::Or(box.c0<hn::Load(di, c0_ + i), box.c1> hn::Load(di, c1_ + i)),
                                 hn::Or(box.r0<hn::Load(di, r0_ + i), box.r1> hn::Load(di, r1_ + i)));
      const auto certain = hn::And(is_finite, hn::AndNot(hn::RebindMask(d, beyond), box.inside));
      const auto one = hn::Set(di, 1);
      hn::Store(hn::IfThenElseZero(hn::RebindMask(di, certain), one), di, is_certain_ + i);
      hn::Store(hn::IfThenElseZero(hn::RebindMask(di, box.inside), one), di, is_inside_ + i);
      store_cells(box, i);
      hn::Store(box.radius, d, found_radius + i);
    }
  }

  /// What rounding can do to the numbers of an edge in a box of so many cells.
  void bound_errors(std::size_t edge, float cells) {
    constexpr float two = 2 * TileCoordinates::rounding;
    const float extent = cells * at_.cell * (1 + slack) + slack;
    const float chord = std::max(std::abs(bx_[edge] - ax_[edge]), std::abs(by_[edge] - ay_[edge]));
    const float of_e = two + unit * extent, of_d = two + unit * chord;
    const bool exact = extent <= at_.lattice_extent;
    error_dot_[edge] = exact ? 0 : 12.3f * extent * (of_e + unit * extent);
    error_cross_[edge] = exact ? 0 : 2.1f * (chord * of_e + extent * of_d + 2 * unit * chord * extent);
    right_of_[edge] = exact ? std::numeric_limits<float>::min() : -4 * error_cross_[edge];
  }

  /// An edge in every lane.
  struct Edge {
    V ax, ay, bx, by, dx, dy, error_dot, error_cross, left_of, right_of;
  };
  HWY_INLINE Edge edge_of(std::size_t i) const {
    const D d;
    const V ax = hn::Set(d, ax_[i]), ay = hn::Set(d, ay_[i]), bx = hn::Set(d, bx_[i]), by = hn::Set(d, by_[i]);
    return {ax,
            ay,
            bx,
            by,
            bx - ax,
            by - ay,
            hn::Set(d, error_dot_[i]),
            hn::Set(d, 3 * error_cross_[i]),
            hn::Set(d, 4 * error_cross_[i]),
            hn::Set(d, right_of_[i])};
  }

  /// k of the points from `first` on between two bounds; whether each is left of the chord, and whether it may be.
  struct Bounds {
    V low, high;
    hn::Mask<D> left, perhaps;
  };
  HWY_INLINE Bounds bounds(const Edge& e, std::size_t first, std::size_t count) const {
    const D d;
    const V px = hn::LoadU(d, at_.x.data() + first), py = hn::LoadU(d, at_.y.data() + first);
    const V ex = px - e.ax, ey = py - e.ay, fx = px - e.bx, fy = py - e.by;
    const V cross = hn::MulSub(e.dx, ey, e.dy * ex), dot = hn::MulAdd(ex, fx, ey * fy);
    const V inverse = hn::Set(d, 1) / cross, k = dot * inverse;
    const V relative = hn::MulAdd(e.error_cross, inverse, hn::Set(d, 4 * unit));
    const V error = hn::MulAdd(hn::Abs(k), relative, e.error_dot * inverse);
    const auto valid = hn::FirstN(d, count);
    return {k - error, k + error, hn::And(valid, cross > e.left_of), hn::And(valid, cross >= e.right_of)};
  }

  /// The places of the ends of an edge among the points of three rows.
  HWY_INLINE std::uint64_t ends_of(std::size_t edge) const {
    std::uint64_t ends = 0;
    for (std::size_t row = 0; row < rows_at_once; ++row)
      ends |= static_cast<std::uint64_t>(ends_[row][edge]) << (row * row_length);
    return ends;
  }

  /// Among the points of at most three short rows; none: look again.
  HWY_NOINLINE Index among_three_rows(std::size_t edge) {
    const D d;
    constexpr std::size_t N = hn::MaxLanes(d), per_row = row_length / N, vectors = rows_at_once * per_row;
    high_[edge] = infinity;
    if (!fits_[edge]) return none;
    const Edge e = edge_of(edge);
    V low[vectors];
    hn::Mask<D> perhaps[vectors];
    V least = hn::Set(d, infinity);
    for (std::size_t j = 0; j < vectors; ++j) {
      const std::size_t row = j / per_row, skipped = j % per_row * N;
      const auto count = static_cast<std::size_t>(count_[row][edge]);
      const Bounds k =
          bounds(e, static_cast<std::size_t>(first_[row][edge]) + skipped, count > skipped ? count - skipped : 0);
      low[j] = hn::IfThenElse(k.left, k.low, hn::Set(d, -infinity));
      perhaps[j] = k.perhaps;
      least = hn::Min(least, hn::IfThenElse(k.left, k.high, hn::Set(d, infinity)));
    }
    const V bound = hn::MinOfLanes(d, least);
    std::uint64_t can_win = 0;
    for (std::size_t j = 0; j < vectors; ++j) can_win |= bits_of(hn::And(perhaps[j], low[j] <= bound)) << (j * N);
    can_win &= ~ends_of(edge);
    const float high = hn::GetLane(bound);
    high_[edge] = high;
    if (!(high < infinity)) return none;
    const auto point = [&](std::uint64_t bits) {
      const auto at = static_cast<std::size_t>(std::countr_zero(bits));
      return static_cast<Index>(static_cast<std::size_t>(first_[at / row_length][edge]) + at % row_length);
    };
    if ((can_win & (can_win - 1)) == 0) return point(can_win);
    contenders_.clear();
    for (; can_win != 0; can_win &= can_win - 1) contenders_.push_back(point(can_win));
    return decide(edge);
  }

  static HWY_INLINE std::uint64_t bits_of(hn::Mask<D> mask) {
    const D d;
    std::conditional_t<hn::MaxLanes(d) == 16, std::uint16_t, std::uint8_t> bits;
    hn::StoreMaskBits(d, mask, reinterpret_cast<std::uint8_t*>(&bits));
    return bits;
  }

  /// What the bounds left undecided.
  HWY_NOINLINE Index decide(std::size_t edge) const {
    const auto ia = static_cast<std::size_t>(a[edge]), ib = static_cast<std::size_t>(b[edge]);
    const Point &pa = tile_.points[ia], &pb = tile_.points[ib];
    const bool exact = error_cross_[edge] == 0;
    Index winner = none;
    for (const Index i : contenders_) {
      if (!exact && P::orientation(pa, pb, tile_.points[i]) <= 0) continue;
      if (winner == none || (exact ? beats_on_lattice(ia, ib, i, winner)
                                   : P::in_perturbed_circle(pa, pb, tile_.points[winner], tile_.points[i]) > 0))
        winner = i;
    }
    return winner;
  }

  /// p is in the circle of a, b, q. In double precision products of four differences are exact.
  bool beats_on_lattice(std::size_t ia, std::size_t ib, std::size_t p, std::size_t q) const {
    struct Ratio {
      double dot, cross;
    };
    const auto centre = [&](std::size_t i) -> Ratio {
      const double ex = double(at_.x[i]) - at_.x[ia], ey = double(at_.y[i]) - at_.y[ia];
      const double dx = double(at_.x[ib]) - at_.x[ia], dy = double(at_.y[ib]) - at_.y[ia];
      return {ex * (double(at_.x[i]) - at_.x[ib]) + ey * (double(at_.y[i]) - at_.y[ib]), dx * ey - dy * ex};
    };
    const Ratio of_p = centre(p), of_q = centre(q);
    const double first = of_p.dot * of_q.cross, second = of_q.dot * of_p.cross;
    return first < second || (first == second && wins_tie_on_lattice(ia, ib, p, q));
  }

  /// P::perturbed_side(a, b, q, p) > 0 for p and q left of a→b, without a branch: a lattice has a tie a point. Of the
  /// four on the circle the largest decides.
  bool wins_tie_on_lattice(std::size_t ia, std::size_t ib, std::size_t p, std::size_t q) const {
    const auto order = [&](std::size_t i) { return double(at_.x[i]) * 0x1p27 + at_.y[i]; };  // exact, lexicographic
    const double a_order = order(ia), b_order = order(ib), p_order = order(p), q_order = order(q);
    const double qx = double(at_.x[q]) - at_.x[ib], qy = double(at_.y[q]) - at_.y[ib];
    const double px = double(at_.x[p]) - at_.x[ib], py = double(at_.y[p]) - at_.y[ib];
    const bool p_is_behind_q = qx * py - qy * px > 0;  // from b on around the circle
    const bool end_decides = std::max(a_order, b_order) > std::max(p_order, q_order);
    const bool by_end = p_is_behind_q == (a_order > b_order), by_apex = q_order > p_order;
    return (end_decides & by_end) | (!end_decides & by_apex);
  }

  /// Cells, and whether all points of the box for which they are, but for those of unknown cells, are in the tile.
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
  /// The cells of what lies left of the chord in the disc whose centre is k half-chords left of the chord's middle.
  Cells cells_for(std::size_t edge, float k) const {
    const float ax = ax_[edge], ay = ay_[edge], bx = bx_[edge], by = by_[edge];
    const float dx = bx - ax, dy = by - ay, squared = dx * dx + dy * dy, half = 0.5f * k;
    const float x = 0.5f * (ax + bx) - half * dy, y = 0.5f * (ay + by) + half * dx;
    const float radius = 0.5f * std::sqrt(squared) * std::sqrt(1 + k * k), wide = slack * (1 + radius + std::abs(k));
    const float r = radius + wide, reach = half * squared;
    const float x_low = -r * dy <= reach ? x - r : std::min(ax, bx) - wide;
    const float x_high = -r * dy >= -reach ? x + r : std::max(ax, bx) + wide;
    const float y_low = r * dx <= reach ? y - r : std::min(ay, by) - wide;
    const float y_high = r * dx >= -reach ? y + r : std::max(ay, by) + wide;
    return {at_.column(x_low), at_.column(x_high), at_.row(y_low), at_.row(y_high),
            x_low >= at_.x_low && x_high <= at_.x_high && y_low >= at_.y_low && y_high <= at_.y_high};
  }

  /// From near to far, as far as it takes.
  HWY_NOINLINE Index search(std::size_t edge) {
    const float dx = bx_[edge] - ax_[edge], dy = by_[edge] - ay_[edge], length = std::sqrt(dx * dx + dy * dy);
    if (!(length > 0)) return none;
    Cells cells{c0_[edge], c1_[edge], r0_[edge], r1_[edge], is_inside_[edge] != 0};
    for (float reach = found_radius[edge];;) {
      const auto [winner, high] = among(edge, cells);
      if (high < infinity) {
        const Cells needed = cells_for(edge, high);
        if (cells.contain(needed)) {
          found_radius[edge] = 0.5f * length * std::sqrt(1 + high * high);
          return is_known(needed) ? winner : none;
        }
        cells = cells.with(needed);
        continue;
      }
      if (!is_known(cells) || reach > most_reach) return none;
      reach *= 2;
      const float ratio = 2 * reach / length;
      cells = cells_for(edge, std::sqrt(std::max(0.0f, ratio * ratio - 1)));
    }
  }

  /// The winner among the points of some cells, and how far left of the middle its circle's centre is, at most.
  struct Winner {
    Index point;
    float high;  // infinity when there is none
  };
  Winner among(std::size_t edge, const Cells& cells) {
    const D d;
    const std::size_t N = hn::Lanes(d);
    bound_errors(edge, static_cast<float>(std::max(cells.c1 - cells.c0, cells.r1 - cells.r0) + 1));
    const Edge e = edge_of(edge);
    V least = hn::Set(d, infinity);
    std::size_t vectors = 0;
    for (int r = cells.r0; r <= cells.r1; ++r) {
      const auto end = static_cast<std::size_t>(at_.start[static_cast<std::size_t>(r * at_.columns + cells.c1 + 1)]);
      for (auto i = static_cast<std::size_t>(at_.start[static_cast<std::size_t>(r * at_.columns + cells.c0)]); i < end;
           i += N) {
        const Bounds k = bounds(e, i, end - i);
        least = hn::Min(least, hn::IfThenElse(k.left, k.high, hn::Set(d, infinity)));
        const V low = hn::IfThenElse(k.left, k.low, hn::Set(d, -infinity));
        hn::StoreU(hn::IfThenElse(k.perhaps, low, hn::Set(d, infinity)), d, low_.data() + vectors * N);
        base_[vectors++] = static_cast<Index>(i);
      }
    }
    const V bound = hn::MinOfLanes(d, least);
    const float high = hn::GetLane(bound);
    contenders_.clear();
    for (std::size_t j = 0; j < vectors; ++j) {
      const V low = hn::LoadU(d, low_.data() + j * N);
      for (std::uint64_t bits = bits_of(hn::And(low <= bound, low < hn::Set(d, infinity))); bits != 0;
           bits &= bits - 1) {
        const auto point = base_[j] + static_cast<std::uint32_t>(std::countr_zero(bits));
        if (point != static_cast<std::uint32_t>(a[edge]) && point != static_cast<std::uint32_t>(b[edge]))
          contenders_.push_back(static_cast<Index>(point));
      }
    }
    // A circle full of points: no tile has an easier time with it than the front of the whole mesh.
    if (contenders_.empty() || contenders_.size() > most_contenders) return {none, high};
    return {contenders_.size() == 1 && high < infinity ? contenders_[0] : decide(edge), high};
  }

  const Tile& tile_;
  const TileCoordinates& at_;
  // Of each edge: the cells to look at; whether they have few points, and these row by row.
  alignas(64) std::int32_t c0_[batch], c1_[batch], r0_[batch], r1_[batch], fits_[batch];
  alignas(64) std::int32_t first_[rows_at_once][batch], count_[rows_at_once][batch], ends_[rows_at_once][batch];
  alignas(64) float ax_[batch], ay_[batch], bx_[batch], by_[batch], extent_[batch];
  alignas(64) float error_dot_[batch], error_cross_[batch], right_of_[batch];
  // How far left of the middle centres are worth a look; how far the winner's is at most, and whether that is certain.
  alignas(64) float k_[batch], high_[batch];
  alignas(64) std::int32_t is_certain_[batch], is_inside_[batch];
  std::vector<float> low_;
  std::vector<Index> base_, contenders_;
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace rbpa
HWY_AFTER_NAMESPACE();

#endif
