#include "rbpa/tile/triangulate.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "rbpa/predicate/predicates.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rbpa/tile/triangulate.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace rbpa {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using P = Predicates<double>;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float u = 0x1p-24f;  // of one rounding

struct Box {
  float x_low, x_high, y_low, y_high;
};

class Kernel {
 public:
  Kernel(const Tile& tile, const Radius& radius, TileWorkspace& w, TileTriangles& result)
      : tile_(tile),
        radius_(radius),
        result_(result),
        x_(w.x),
        y_(w.y),
        low_(w.low),
        start_(w.start),
        unknown_(w.unknown),
        base_(w.base),
        head_(w.head),
        corner_(w.corner),
        across_(w.across),
        link_(w.link),
        queue_(w.queue),
        seen_(w.seen),
        number_(w.number) {}

  void run() {
    result_.patch.clear();
    result_.known.clear();
    if (tile_.points.empty()) return;
    prepare();
    for (std::size_t v = 0; v < tile_.points.size(); ++v) {
      if (!tile_.own[v] || seen_[v]) continue;
      seed(static_cast<Index>(v));
      advance();
    }
    hand_over();
  }

 private:
  using Index = std::uint16_t;
  static constexpr Index none = 0xffff;
  static constexpr std::size_t lanes_most = 16;

  using D = hn::CappedTag<float, lanes_most>;
  using I = hn::RebindToUnsigned<D>;

  // ------------------------------------------------------------------ coordinates
  HWY_NOINLINE void prepare() {
    const std::size_t n = tile_.points.size();
    const double width = tile_.columns * tile_.cell, height = tile_.rows * tile_.cell;
    // The origin is a point near the middle: on a lattice it is one of the lattice.
    const Point origin = tile_.points[n / 2];
    const double cx = origin.x, cy = origin.y;
    int exponent;
    std::frexp(std::max(width, height), &exponent);
    const double scale = std::ldexp(1.0, -exponent);  // the box is within −1 … 1
    x_.resize(n + lanes_most);
    y_.resize(n + lanes_most);
    for (std::size_t i = 0; i < n; ++i) {
      x_[i] = static_cast<float>((tile_.points[i].x - cx) * scale);
      y_[i] = static_cast<float>((tile_.points[i].y - cy) * scale);
    }
    for (std::size_t i = n; i < n + lanes_most; ++i) x_[i] = y_[i] = 0;
    cell_ = static_cast<float>(tile_.cell * scale);
    per_cell_ = 1 / cell_;
    x0_ = static_cast<float>((tile_.x0 - cx) * scale);
    y0_ = static_cast<float>((tile_.y0 - cy) * scale);
    x1_ = static_cast<float>((tile_.x1() - cx) * scale);
    y1_ = static_cast<float>((tile_.y1() - cy) * scale);
    lattice_extent_ = lattice_extent(cx, cy, scale);
    start_.assign(tile_.start.begin(), tile_.start.end());
    start_.resize(start_.size() + 3 * static_cast<std::size_t>(tile_.columns), static_cast<std::int32_t>(n));
    reach_ = 0.9f * cell_;
    unknown_.assign(tile_.unknown.begin(), tile_.unknown.end());
    if (!unknown_.empty()) unknown_.resize(start_.size(), unknown_.back());
    known_.x_low = tile_.nothing_left ? -infinity : x0_;
    known_.x_high = tile_.nothing_right ? infinity : x1_;
    known_.y_low = tile_.nothing_below ? -infinity : y0_;
    known_.y_high = tile_.nothing_above ? infinity : y1_;
    head_.assign(n, none);
    seen_.assign(n, 0);
    if (corner_.size() < 6 * n + 3) {
      corner_.resize(6 * n + 3);
      across_.resize(6 * n + 3);
      link_.resize(6 * n + 3);
      queue_.resize(6 * n + 3);
    }
    sides_ = next_ = queued_ = 0;
    low_.resize(n + lanes_most * (static_cast<std::size_t>(tile_.rows) + 1));
    base_.resize(low_.size() / lanes_most + static_cast<std::size_t>(tile_.rows) + 1 + n);
  }

  /// Where the points are on a lattice: an extent within which products of coordinates are exact in single precision.
  /// 0 where they are not.
  float lattice_extent(double cx, double cy, double scale) const {
    std::uint32_t all = 0;
    for (std::size_t i = 0; i < tile_.points.size(); ++i) {
      const Point& p = tile_.points[i];
      const double x = (p.x - cx) * scale * 0x1p24, y = (p.y - cy) * scale * 0x1p24;
      const auto ix = static_cast<std::int32_t>(x), iy = static_cast<std::int32_t>(y);
      // The difference is exact when adding it up gives the coordinate back and it has few digits.
      if (double(ix) != x || double(iy) != y || x / (scale * 0x1p24) + cx != p.x || y / (scale * 0x1p24) + cy != p.y)
        return 0;
      all |= static_cast<std::uint32_t>(std::abs(ix)) | static_cast<std::uint32_t>(std::abs(iy));
    }
    if (all == 0) return 0;
    return static_cast<float>(std::ldexp(1.0, std::countr_zero(all) - 24 + 11));
  }

  int column(float at) const { return clamp((at - x0_) * per_cell_, tile_.columns); }
  int row(float at) const { return clamp((at - y0_) * per_cell_, tile_.rows); }
  static int clamp(float cells, int count) {
    return static_cast<int>(std::max(0.0f, std::min(cells, static_cast<float>(count - 1))));
  }

  // ------------------------------------------------------------------ pivot
  /// The apex left of a→b; none when it cannot be told from what is known.
  Index pivot(Index a, Index b) {
    const float ax = x_[a], ay = y_[a], bx = x_[b], by = y_[b];
    const float dx = bx - ax, dy = by - ay, squared = dx * dx + dy * dy;
    const float length = std::sqrt(squared);
    if (!(length > 0)) return none;
    float reach = std::max(0.6f * length, 1.1f * cell_);
    const auto centre_for = [&](float radius) {
      const float ratio = 2 * radius / length;
      return std::sqrt(std::max(0.0f, ratio * ratio - 1));
    };
    float k = centre_for(reach);
    for (;;) {
      // The segment left of the chord of the disc whose centre is k half-chords left of the chord's middle.
      const float half = 0.5f * k;
      const float x = 0.5f * (ax + bx) - half * dy, y = 0.5f * (ay + by) + half * dx;
      const float radius = 0.5f * length * std::sqrt(1 + k * k);
      const float slack = 16 * u * (1 + radius + k);
      const float r = radius + slack, chord_reach = half * squared;
      Box box;
      box.x_low = -r * dy <= chord_reach ? x - r : std::min(ax, bx) - slack;
      box.x_high = -r * dy >= -chord_reach ? x + r : std::max(ax, bx) + slack;
      box.y_low = r * dx <= chord_reach ? y - r : std::min(ay, by) - slack;
      box.y_high = r * dx >= -chord_reach ? y + r : std::max(ay, by) + slack;
      const bool inside = box.x_low >= known_.x_low && box.x_high <= known_.x_high && box.y_low >= known_.y_low &&
                          box.y_high <= known_.y_high;
      const int c0 = column(box.x_low), c1 = column(box.x_high), r0 = row(box.y_low), r1 = row(box.y_high);
      const bool certain = inside && (tile_.unknown.empty() || is_known(c0, c1, r0, r1));
      const Index apex = contest(a, b, ax, ay, bx, by, dx, dy, c0, c1, r0, r1);
      if (high_ <= k) return certain ? apex : certain_at(a, b, high_) ? apex : none;
      if (high_ == infinity) {
        if (!certain || reach > 4) return none;
        reach *= 2;
        k = centre_for(reach);
      } else {
        k = high_;
      }
    }
  }

  /// The same box again, for a circle smaller than the one searched.
  bool certain_at(Index a, Index b, float k) const {
    const float ax = x_[a], ay = y_[a], bx = x_[b], by = y_[b];
    const float dx = bx - ax, dy = by - ay, squared = dx * dx + dy * dy, length = std::sqrt(squared);
    const float half = 0.5f * k;
    const float x = 0.5f * (ax + bx) - half * dy, y = 0.5f * (ay + by) + half * dx;
    const float radius = 0.5f * length * std::sqrt(1 + k * k);
    const float slack = 16 * u * (1 + radius + std::abs(k));
    const float r = radius + slack, chord_reach = half * squared;
    const float x_low = -r * dy <= chord_reach ? x - r : std::min(ax, bx) - slack;
    const float x_high = -r * dy >= -chord_reach ? x + r : std::max(ax, bx) + slack;
    const float y_low = r * dx <= chord_reach ? y - r : std::min(ay, by) - slack;
    const float y_high = r * dx >= -chord_reach ? y + r : std::max(ay, by) + slack;
    if (!(x_low >= known_.x_low && x_high <= known_.x_high && y_low >= known_.y_low && y_high <= known_.y_high))
      return false;
    return tile_.unknown.empty() || is_known(column(x_low), column(x_high), row(y_low), row(y_high));
  }

  bool is_known(int c0, int c1, int r0, int r1) const {
    for (int r = r0; r <= r1; ++r) {
      const std::size_t row = static_cast<std::size_t>(r) * static_cast<std::size_t>(tile_.columns);
      if (tile_.unknown[row + static_cast<std::size_t>(c0)] != tile_.unknown[row + static_cast<std::size_t>(c1) + 1])
        return false;
    }
    return true;
  }

  /// The winner among the points of some cells; leaves in high_ how far left of the middle its circle's centre is, at
  /// most: infinity for no winner.
  HWY_INLINE Index contest(Index a, Index b, float ax, float ay, float bx, float by, float dx, float dy, int c0, int c1,
                           int r0, int r1) {
    const D d;
    const I di;
    const std::size_t N = hn::Lanes(d);
    const float extent = static_cast<float>(std::max(c1 - c0, r1 - r0) + 1) * cell_ * (1 + 16 * u) + 8 * u;
    const float size_d = std::max(std::abs(dx), std::abs(dy));
    constexpr float delta = 1.02f * 0x1p-25f;
    const float error_e = 2 * delta + u * extent, error_d = 2 * delta + u * size_d;
    const float error_dot = 3 * (4.1f * extent * error_e + 4.1f * u * extent * extent);
    const float error_cross = 2.1f * (size_d * error_e + extent * error_d + 2 * u * size_d * extent);
    const auto vax = hn::Set(d, ax), vay = hn::Set(d, ay), vbx = hn::Set(d, bx), vby = hn::Set(d, by);
    const auto vdx = hn::Set(d, dx), vdy = hn::Set(d, dy);
    const auto e_dot = hn::Set(d, error_dot), e_cross = hn::Set(d, 3 * error_cross);
    const auto left_of = hn::Set(d, 4 * error_cross), right_of = hn::Set(d, -4 * error_cross);
    const auto inf = hn::Set(d, infinity), minus_inf = hn::Set(d, -infinity), one = hn::Set(d, 1.0f);
    const auto va = hn::Set(di, std::uint32_t{a}), vb = hn::Set(di, std::uint32_t{b});
    auto least = inf;
    std::size_t m = 0;
    for (int r = r0; r <= r1; ++r) {
      const std::size_t row = static_cast<std::size_t>(r) * static_cast<std::size_t>(tile_.columns);
      std::size_t i = tile_.start[row + static_cast<std::size_t>(c0)];
      const std::size_t end = tile_.start[row + static_cast<std::size_t>(c1) + 1];
      for (; i < end; i += N) {
        const auto px = hn::LoadU(d, x_.data() + i), py = hn::LoadU(d, y_.data() + i);
        const auto ex = px - vax, ey = py - vay, fx = px - vbx, fy = py - vby;
        const auto cross = hn::MulSub(vdx, ey, vdy * ex);
        const auto dot = hn::MulAdd(ex, fx, ey * fy);
        const auto index = hn::Iota(di, static_cast<std::uint32_t>(i));
        const auto other = hn::AndNot(hn::Or(index == va, index == vb), hn::FirstN(di, end - i));
        const auto valid = hn::RebindMask(d, other);
        const auto inverse = one / cross;
        const auto k = dot * inverse;
        const auto error = hn::MulAdd(hn::Abs(k), e_cross, e_dot) * inverse;
        const auto left = cross > left_of;
        const auto in = hn::And(valid, cross >= right_of);
        const auto low = hn::IfThenElse(in, hn::IfThenElse(left, k - error, minus_inf), inf);
        const auto high = hn::IfThenElse(hn::And(in, left), k + error, inf);
        least = hn::Min(least, high);
        hn::StoreU(low, d, low_.data() + m * N);
        base_[m++] = static_cast<Index>(i);
      }
    }
    const float bound = hn::GetLane(hn::MinOfLanes(d, least));
    const auto bound_lanes = hn::Set(d, bound);
    std::size_t count = 0;
    Index winner = none;
    for (std::size_t j = 0; j < m; ++j) {
      const auto can_win =
          hn::And(hn::LoadU(d, low_.data() + j * N) <= bound_lanes, hn::LoadU(d, low_.data() + j * N) < inf);
      std::uint8_t bytes[8] = {};
      hn::StoreMaskBits(d, can_win, bytes);
      std::uint32_t bits = static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8;
      if (bits != 0) {
        count += static_cast<std::size_t>(__builtin_popcount(bits));
        winner = static_cast<Index>(base_[j] + __builtin_ctz(bits));
      }
    }
    high_ = bound;
    if (count == 1 && bound < infinity) return winner;
    if (count == 0) return none;
    return contest_exactly(a, b, m, N);
  }

  /// What the bounds left undecided.
  Index contest_exactly(Index a, Index b, std::size_t m, std::size_t N) {
    const Point &pa = tile_.points[a], &pb = tile_.points[b];
    Index winner = none;
    for (std::size_t j = 0; j < m; ++j) {
      for (std::size_t lane = 0; lane < N; ++lane) {
        const float low = low_[j * N + lane];
        if (low > high_ || low == infinity) continue;
        const auto i = static_cast<Index>(base_[j] + lane);
        const Point& p = tile_.points[i];
        if (low == -infinity && P::orientation(pa, pb, p) <= 0) continue;
        if (winner == none || P::in_perturbed_circle(pa, pb, tile_.points[winner], p) > 0) winner = i;
      }
    }
    return winner;
  }

  // ------------------------------------------------------------------ front
  Index find(Index from, Index to) const {
    for (Index s = head_[from]; s != none; s = link_[s])
      if (corner_[s] == to) return s;
    return none;
  }
  void unlink(Index from, Index s) {
    Index* at = &head_[from];
    while (*at != s) at = &link_[*at];
    *at = link_[s];
  }
  static Index next_side(Index s) { return static_cast<Index>(s % 3 == 2 ? s - 2 : s + 1); }

  /// Side s of a new triangle, from→to: glued to the front, or on it.
  HWY_INLINE void settle(Index s, Index from, Index to) {
    corner_[s] = from;
    const Index f = find(from, to);
    across_[s] = f;
    if (f != none) {
      across_[f] = s;
      unlink(from, f);
    } else {
      link_[s] = head_[to];
      head_[to] = s;
      queue_[queued_] = s;
      queued_ += std::size_t{tile_.own[from]} | tile_.own[to];
    }
  }

  void add(Index a, Index b, Index c) {
    const auto s = static_cast<Index>(sides_);
    sides_ += 3;
    corner_[s] = a;  // a side of the triangle may be looked for before it is settled
    settle(s, a, b);
    settle(static_cast<Index>(s + 1), b, c);
    settle(static_cast<Index>(s + 2), c, a);
    seen_[a] = seen_[b] = seen_[c] = 1;
  }

  /// Attaches to the side f, whose edge is a→b from outside.
  HWY_INLINE void attach(Index f, Index a, Index b, Index c) {
    const auto s = static_cast<Index>(sides_);
    sides_ += 3;
    corner_[s] = a;
    across_[s] = f;
    across_[f] = s;
    unlink(a, f);
    settle(static_cast<Index>(s + 1), b, c);
    settle(static_cast<Index>(s + 2), c, a);
    seen_[c] = 1;
  }

  HWY_NOINLINE void advance() {
    while (next_ < queued_) {
      // A wave of the front, taken at distances: neighbours often lead to the same triangle.
      const std::size_t first = next_, last = queued_, stride = (last - first + batch - 1) / batch;
      next_ = last;
      for (std::size_t k = 0; k < stride; ++k) {
        std::size_t size = 0;
        for (std::size_t i = first + k; i < last; i += stride) {
          const Index s = queue_[i];
          side_[size] = s;
          a_[size] = corner_[next_side(s)];
          b_[size] = corner_[s];
          size += across_[s] == none;
        }
        if (size == 0) continue;
        for (std::size_t i = size; i < batch; ++i) a_[i] = a_[0], b_[i] = b_[0];
        set_up();
        for (std::size_t i = 0; i < size; ++i) apex_[i] = contest_in_three_rows(i);
        for (std::size_t i = 0; i < size; ++i) {
          if (across_[side_[i]] != none) continue;
          const auto a = static_cast<Index>(a_[i]), b = static_cast<Index>(b_[i]);
          Index c = apex_[i];
          if (c == none) c = pivot(a, b);
          if (c != none) attach(side_[i], a, b, c);
        }
      }
    }
  }

  HWY_NOINLINE void set_up() {
    const D d;
    const hn::RebindToSigned<D> di;
    for (std::size_t i = 0; i < batch; i += hn::Lanes(d)) {
      const auto a = hn::Load(di, a_ + i), b = hn::Load(di, b_ + i);
      const auto ax = hn::GatherIndex(d, x_.data(), a), ay = hn::GatherIndex(d, y_.data(), a);
      const auto bx = hn::GatherIndex(d, x_.data(), b), by = hn::GatherIndex(d, y_.data(), b);
      const auto half = hn::Set(d, 0.5f), one = hn::Set(d, 1.0f), zero = hn::Zero(d);
      const auto dx = bx - ax, dy = by - ay, squared = dx * dx + dy * dy;
      const auto length = hn::Max(hn::Sqrt(squared), hn::Set(d, 0x1p-60f));
      const auto reach = hn::Max(hn::Set(d, 0.6f) * length, hn::Set(d, reach_));
      const auto ratio = hn::Min((reach + reach) / length, hn::Set(d, 0x1p20f));
      const auto k = hn::Sqrt(hn::Max(zero, ratio * ratio - one));
      const auto half_k = half * k;
      const auto x = half * (ax + bx) - half_k * dy, y = half * (ay + by) + half_k * dx;
      const auto radius = half * length * hn::Sqrt(one + k * k);
      const auto slack = hn::Set(d, 16 * u) * (one + radius + k);
      const auto r = radius + slack, chord_reach = half_k * squared;
      const auto left_x = r * dy, left_y = r * dx;
      const auto x_low = hn::IfThenElse(hn::Neg(left_x) <= chord_reach, x - r, hn::Min(ax, bx) - slack);
      const auto x_high = hn::IfThenElse(left_x <= chord_reach, x + r, hn::Max(ax, bx) + slack);
      const auto y_low = hn::IfThenElse(left_y <= chord_reach, y - r, hn::Min(ay, by) - slack);
      const auto y_high = hn::IfThenElse(hn::Neg(left_y) <= chord_reach, y + r, hn::Max(ay, by) + slack);
      auto inside = hn::And(hn::And(x_low >= hn::Set(d, known_.x_low), x_high <= hn::Set(d, known_.x_high)),
                            hn::And(y_low >= hn::Set(d, known_.y_low), y_high <= hn::Set(d, known_.y_high)));
      const auto per_cell = hn::Set(d, per_cell_);
      const auto cell_of = [&](auto at, float from, int count) {
        const auto cells = (at - hn::Set(d, from)) * per_cell;
        return hn::ConvertTo(di, hn::Max(zero, hn::Min(cells, hn::Set(d, static_cast<float>(count - 1)))));
      };
      const auto c0 = cell_of(x_low, x0_, tile_.columns), c1 = cell_of(x_high, x0_, tile_.columns);
      const auto r0 = cell_of(y_low, y0_, tile_.rows), r1 = cell_of(y_high, y0_, tile_.rows);
      const auto columns = hn::Set(di, tile_.columns);
      const auto across = c1 - c0 + hn::Set(di, 1), up = r1 - r0;
      auto cell = r0 * columns + c0;
      auto unknown = hn::Zero(di);
      auto fits = up < hn::Set(di, 3);
      for (int row = 0; row < 3; ++row) {
        const auto first = hn::GatherIndex(di, start_.data(), cell);
        const auto last = hn::GatherIndex(di, start_.data(), cell + across);
        const auto count = hn::IfThenElseZero(up > hn::Set(di, row - 1), last - first);
        if (!unknown_.empty())
          unknown = unknown +
                    hn::IfThenElseZero(up > hn::Set(di, row - 1), hn::GatherIndex(di, unknown_.data(), cell + across) -
                                                                      hn::GatherIndex(di, unknown_.data(), cell));
        hn::Store(first, di, first_[row] + i);
        hn::Store(count, di, count_[row] + i);
        fits = hn::And(fits, count < hn::Set(di, 17));
        cell = cell + columns;
      }
      fits = hn::And(fits, unknown == hn::Zero(di));
      const auto good = hn::And(inside, hn::RebindMask(d, fits));
      hn::Store(hn::IfThenElse(good, k, hn::Set(d, -infinity)), d, k_ + i);
      // Errors of single precision; docs/tiles.md derives them.
      const auto extent =
          hn::ConvertTo(d, hn::Max(across, hn::Set(di, 3))) * hn::Set(d, cell_ * (1 + 16 * u)) + hn::Set(d, 8 * u);
      const auto size_d = hn::Max(hn::Abs(dx), hn::Abs(dy));
      const auto unit = hn::Set(d, u), two_delta = hn::Set(d, 2.04f * 0x1p-25f);
      const auto error_e = two_delta + unit * extent, error_d = two_delta + unit * size_d;
      auto error_dot = hn::Set(d, 12.3f) * extent * (error_e + unit * extent);
      auto error_cross = hn::Set(d, 2.1f) * (size_d * error_e + extent * error_d + hn::Set(d, 2 * u) * size_d * extent);
      auto right_of = hn::Set(d, -4.0f) * error_cross;
      if (lattice_extent_ > 0) {
        const auto products_exact = extent <= hn::Set(d, lattice_extent_);
        error_dot = hn::IfThenZeroElse(products_exact, error_dot);
        error_cross = hn::IfThenZeroElse(products_exact, error_cross);
        right_of = hn::IfThenElse(products_exact, hn::Set(d, std::numeric_limits<float>::min()), right_of);
      }
      hn::Store(error_dot, d, error_dot_ + i);
      hn::Store(error_cross, d, error_cross_ + i);
      hn::Store(right_of, d, right_of_ + i);
      hn::Store(ax, d, ax_ + i);
      hn::Store(ay, d, ay_ + i);
      hn::Store(bx, d, bx_ + i);
      hn::Store(by, d, by_ + i);
    }
    for (std::size_t i = 0; i < batch; ++i) {
      std::uint64_t ends = 0;
      for (int row = 0; row < 3; ++row) {
        const std::uint32_t a = static_cast<std::uint32_t>(a_[i] - first_[row][i]),
                            b = static_cast<std::uint32_t>(b_[i] - first_[row][i]);
        ends |= (a < 16 ? std::uint64_t{1} << (a + 16 * static_cast<unsigned>(row)) : 0) |
                (b < 16 ? std::uint64_t{1} << (b + 16 * static_cast<unsigned>(row)) : 0);
      }
      not_ends_[i] = ~ends;
    }
  }

  /// none: look again.
  HWY_NOINLINE Index contest_in_three_rows(std::size_t edge) {
    const D d;
    constexpr std::size_t N = hn::MaxLanes(d), vectors = 16 / N;
    const float k_searched = k_[edge];
    if (!(k_searched >= 0)) return none;
    const auto ax = hn::Set(d, ax_[edge]), ay = hn::Set(d, ay_[edge]);
    const auto bx = hn::Set(d, bx_[edge]), by = hn::Set(d, by_[edge]);
    const auto dx = bx - ax, dy = by - ay;
    const float ec = error_cross_[edge];
    const auto e_dot = hn::Set(d, error_dot_[edge]), e_cross = hn::Set(d, 3 * ec);
    const auto left_of = hn::Set(d, 4 * ec), right_of = hn::Set(d, right_of_[edge]), rounding = hn::Set(d, 4 * u);
    const auto inf = hn::Set(d, infinity), one = hn::Set(d, 1.0f);
    hn::Vec<D> low[3 * vectors];
    std::uint64_t left_bits = 0, in_bits = 0;
    auto least = inf;
    for (std::size_t row = 0; row < 3; ++row) {
      const auto first = static_cast<std::size_t>(first_[row][edge]);
      const auto count = static_cast<std::size_t>(count_[row][edge]);
      for (std::size_t v = 0; v < vectors; ++v) {
        const std::size_t i = first + v * N, j = row * vectors + v;
        const auto px = hn::LoadU(d, x_.data() + i), py = hn::LoadU(d, y_.data() + i);
        const auto ex = px - ax, ey = py - ay, fx = px - bx, fy = py - by;
        const auto cross = hn::MulSub(dx, ey, dy * ex);
        const auto dot = hn::MulAdd(ex, fx, ey * fy);
        const auto inverse = one / cross;
        const auto k = dot * inverse;
        const auto error = hn::MulAdd(hn::Abs(k), hn::MulAdd(e_cross, inverse, rounding), e_dot * inverse);
        const auto valid = hn::FirstN(d, count > v * N ? count - v * N : 0);
        const auto left = hn::And(valid, cross > left_of);
        const auto in = hn::And(valid, cross >= right_of);
        low[j] = k - error;
        least = hn::Min(least, hn::IfThenElse(left, k + error, inf));
        left_bits |= bits_of(left) << (j * N);
        in_bits |= bits_of(in) << (j * N);
      }
    }
    const auto bound = hn::MinOfLanes(d, least);
    std::uint64_t low_bits = 0;
    for (std::size_t j = 0; j < 3 * vectors; ++j) low_bits |= bits_of(low[j] <= bound) << (j * N);
    const std::uint64_t bits = in_bits & (low_bits | ~left_bits) & not_ends_[edge];
    const float high = hn::GetLane(bound);
    if (!(high <= k_searched)) return none;
    if ((bits & (bits - 1)) != 0) return decide(edge, bits);
    const auto at = static_cast<std::size_t>(__builtin_ctzll(bits));
    return static_cast<Index>(static_cast<std::size_t>(first_[at / 16][edge]) + at % 16);
  }

  /// What the bounds left undecided.
  HWY_NOINLINE Index decide(std::size_t edge, std::uint64_t bits) {
    const auto ia = static_cast<std::size_t>(a_[edge]), ib = static_cast<std::size_t>(b_[edge]);
    const Point &a = tile_.points[ia], &b = tile_.points[ib];
    const bool is_exact = error_cross_[edge] == 0;
    Index winner = none;
    for (; bits != 0; bits &= bits - 1) {
      const auto at = static_cast<std::size_t>(std::countr_zero(bits));
      const auto i = static_cast<Index>(static_cast<std::size_t>(first_[at / 16][edge]) + at % 16);
      if (!is_exact && P::orientation(a, b, tile_.points[i]) <= 0) continue;
      if (winner == none || (is_exact ? beats_on_lattice(ia, ib, i, winner)
                                      : P::in_perturbed_circle(a, b, tile_.points[winner], tile_.points[i]) > 0))
        winner = i;
    }
    return winner;
  }

  /// p is in the circle of a, b, q. All products of two coordinates are exact, in double precision those of four are.
  bool beats_on_lattice(std::size_t a, std::size_t b, std::size_t p, std::size_t q) const {
    const auto centre = [&](std::size_t i, double& dot, double& cross) {
      const double ex = double(x_[i]) - x_[a], ey = double(y_[i]) - y_[a];
      dot = ex * (double(x_[i]) - x_[b]) + ey * (double(y_[i]) - y_[b]);
      cross = (double(x_[b]) - x_[a]) * ey - (double(y_[b]) - y_[a]) * ex;
    };
    double dot_p, cross_p, dot_q, cross_q;
    centre(p, dot_p, cross_p);
    centre(q, dot_q, cross_q);
    const double first = dot_p * cross_q, second = dot_q * cross_p;
    if (first != second) return first < second;
    return P::perturbed_side(tile_.points[a], tile_.points[b], tile_.points[q], tile_.points[p]) > 0;
  }

  static HWY_INLINE std::uint64_t bits_of(hn::Mask<D> mask) {
    const D d;
    if constexpr (hn::MaxLanes(d) == 16) {
      std::uint16_t bits;
      hn::StoreMaskBits(d, mask, reinterpret_cast<std::uint8_t*>(&bits));
      return bits;
    } else {
      std::uint8_t bits;
      hn::StoreMaskBits(d, mask, &bits);
      return bits;
    }
  }

  void seed(Index v) {
    const Index q = nearest(v);
    if (q == none) return;
    Index c = pivot(v, q);
    if (c != none) return add(v, q, c);
    c = pivot(q, v);
    if (c != none) add(q, v, c);
  }

  Index nearest(Index v) const {
    const float x = x_[v], y = y_[v];
    for (float reach = cell_;; reach *= 2) {
      if (x - reach < known_.x_low || x + reach > known_.x_high || y - reach < known_.y_low ||
          y + reach > known_.y_high || reach > 2)
        return none;
      const int c0 = column(x - reach), c1 = column(x + reach), r0 = row(y - reach), r1 = row(y + reach);
      if (!tile_.unknown.empty() && !is_known(c0, c1, r0, r1)) return none;
      Index best = none;
      for (int r = r0; r <= r1; ++r) {
        const std::size_t row = static_cast<std::size_t>(r) * static_cast<std::size_t>(tile_.columns);
        for (std::size_t i = tile_.start[row + static_cast<std::size_t>(c0)];
             i < tile_.start[row + static_cast<std::size_t>(c1) + 1]; ++i)
          if (i != v &&
              (best == none || P::compare_distances(tile_.points[v], tile_.points[i], tile_.points[best]) < 0))
            best = static_cast<Index>(i);
      }
      if (best == none) continue;
      const float ex = x_[best] - x, ey = y_[best] - y;
      if (std::sqrt(ex * ex + ey * ey) + 64 * u <= reach) return best;
    }
  }

  // ------------------------------------------------------------------ result
  bool owns(Index a, Index b, Index c) const {
    if (tile_.own[a] & tile_.own[b] & tile_.own[c]) return true;
    if (!(tile_.own[a] | tile_.own[b] | tile_.own[c])) return false;
    Index least = a;
    if (tile_.points[b] < tile_.points[least]) least = b;
    if (tile_.points[c] < tile_.points[least]) least = c;
    return tile_.own[least] != 0;
  }

  HWY_NOINLINE void hand_over() {
    auto& [patch, known] = result_;
    patch.clear();
    known.clear();
    const std::size_t triangles = sides_ / 3;
    auto& number = number_;
    number.assign(triangles, 0);
    for (std::size_t t = 0; t < triangles; ++t) {
      const Index a = corner_[3 * t], b = corner_[3 * t + 1], c = corner_[3 * t + 2];
      if (!radius_.admits<double>(tile_.points[a], tile_.points[b], tile_.points[c])) {
        number[t] = meshops::Patch::frozen;
      } else if (!owns(a, b, c)) {
        number[t] = meshops::Patch::open;
        seen_[a] = seen_[b] = seen_[c] = 0;  // whether its owner has found it as well is not known here
      } else {
        number[t] = static_cast<int>(patch.triangles.size());
        patch.triangles.push_back(
            {static_cast<int>(tile_.site[a]), static_cast<int>(tile_.site[b]), static_cast<int>(tile_.site[c])});
      }
    }
    patch.across.reserve(patch.triangles.size());
    for (std::size_t t = 0; t < triangles; ++t) {
      if (number[t] < 0) continue;
      auto& across = patch.across.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const Index s = across_[3 * t + i];
        const int other = s == none ? meshops::Patch::open : number[s / 3];
        across[i] = other < 0 ? other : 3 * other + s % 3;
      }
    }
    for (std::size_t v = 0; v < tile_.points.size(); ++v)
      if (tile_.own[v] && seen_[v] && head_[v] == none) known.push_back(tile_.site[v]);
  }

 private:
  const Tile& tile_;
  const Radius& radius_;
  TileTriangles& result_;
  static constexpr std::size_t batch = 16;
  alignas(64) std::int32_t a_[batch + 1], b_[batch + 1], first_[3][batch], count_[3][batch];
  alignas(64) float ax_[batch], ay_[batch], bx_[batch], by_[batch], k_[batch], error_dot_[batch],
      error_cross_[batch], right_of_[batch];
  Index side_[batch + 1], apex_[batch];
  std::uint64_t not_ends_[batch];
  float reach_ = 0, lattice_extent_ = 0;
  Box known_;
  float x0_ = 0, y0_ = 0, x1_ = 0, y1_ = 0, cell_ = 0, per_cell_ = 0;
  float high_ = 0;
  std::vector<float>&x_, &y_, &low_;
  std::vector<std::int32_t>&start_, &unknown_;
  std::vector<Index>& base_;
  std::vector<Index>& head_;  // of each point, the first front edge that leaves it, named by the side it is across
  std::vector<Index>&corner_, &across_, &link_, &queue_;
  std::vector<std::uint8_t>& seen_;
  std::vector<int>& number_;
  std::size_t sides_ = 0, next_ = 0, queued_ = 0;
};

}  // namespace

void triangulate_tile(const Tile& tile, const Radius& radius, TileWorkspace& workspace, TileTriangles& result) {
  Kernel(tile, radius, workspace, result).run();
}

}  // namespace HWY_NAMESPACE
}  // namespace rbpa
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rbpa {

HWY_EXPORT(triangulate_tile);

void triangulate(const Tile& tile, const Radius& radius, TileWorkspace& workspace, TileTriangles& result) {
  HWY_DYNAMIC_DISPATCH(triangulate_tile)(tile, radius, workspace, result);
}

}  // namespace rbpa
#endif
