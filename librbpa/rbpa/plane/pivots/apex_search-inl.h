// What: finds the first point that a ball touches when the ball rolls over an edge a→b to the left, for sixteen edges
//       at a time, on the points of a tile. Compiled once for each kind of vector unit; HWY_TARGET_TOGGLE is the
//       include guard.
// Law:  the result is the Delaunay apex of the edge among all points, or none if the tile's points do not decide it.
// How:  the circle through a, b and p has its center k half-chords left of the chord's middle, and the least k wins.
//       Bounds in single precision leave one point nearly always; exact arithmetic decides the rest.
#if defined(RBPA_PIVOTS_APEX_SEARCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RBPA_PIVOTS_APEX_SEARCH_INL_H_
#undef RBPA_PIVOTS_APEX_SEARCH_INL_H_
#else
#define RBPA_PIVOTS_APEX_SEARCH_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "rbpa/base/lanes/lanes-inl.h"
#include "rbpa/plane/pivots/edge_batch.h"
#include "rbpa/plane/pivots/exact_apex.h"
#include "rbpa/plane/pivots/search_window-inl.h"
#include "rbpa/plane/tile/coordinates.h"
#include "rbpa/plane/tile/tile.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

class ApexSearch {
 public:
  using Index = EdgeBatch::Index;
  static constexpr Index none = EdgeBatch::none;

  /// Keeps references to both arguments.
  ApexSearch(const Tile& tile, const TileCoordinates& coordinates)
      : at_(coordinates),
        window_(edges_, coordinates),
        exact_(tile, coordinates),
        part_(tile.points.size() / lanes + static_cast<std::size_t>(tile.rows) + 1),
        low_(part_.size() * lanes) {
    std::fill_n(edges_.high, EdgeBatch::size, infinity);
  }

  EdgeBatch& edges() { return edges_; }

  /// Returns the total cost, as a number of points scanned, of edges for which three short rows of cells did not
  /// suffice.
  std::size_t work() const { return work_; }

  /// Finds the apexes of the first `size` edges, at least one, and stores them in edges().apex:
  ///   1. open a window of cells at each edge;
  ///   2. bound what rounding can do there;
  ///   3. find the apex among the window's points, edge by edge;
  ///   4. verify that the apex's circle lies in the window;
  ///   5. search on, from near to far, for the edges whose apex is not verified.
  /// Vectors of four to sixteen lanes cover a batch so:
  ///
  ///   steps 1 and 4: a lane is an edge           step 3: a lane is a point, and the edge is in all of them
  ///   ax    | ax 0 | ax 1 | ax 2 | … | ax 15 |   row 0 of the window   | p | p | p | p | · | … |   up to 16 points
  ///   ay    | ay 0 | ay 1 | ay 2 | … | ay 15 |   row 1                 | q | q | · | · | · | … |
  ///   first | start of row r of window i     |   row 2                 | a | s | s | b | · | … |   a, b: its own ends
  ///   count | points in that row             |   k, low … high         | of each; the least high is the bound
  ///   ends  | which of them are a or b       |   can win               | 48 bits: low ≤ bound, and neither a nor b
  void run(std::size_t size) {
    for (std::size_t i = size; i < EdgeBatch::size; ++i) {
      edges_.a[i] = edges_.a[0];
      edges_.b[i] = edges_.b[0];
      edges_.expected[i] = edges_.expected[0];
    }
    window_.open();
    for (std::size_t i = 0; i < EdgeBatch::size; ++i) bound_errors(i, edges_.extent[i]);
    for (std::size_t i = 0; i < size; ++i) edges_.apex[i] = edges_.fits[i] ? among_three_rows(i) : among_more(i);
    window_.verify();
    for (std::size_t i = 0; i < size; ++i)
      if (!edges_.is_verified[i]) edges_.apex[i] = search(i);
  }

  /// Returns the apex of one edge, or `none` if the tile's points do not decide it.
  Index operator()(Index from, Index to) {
    edges_.a[0] = from;
    edges_.b[0] = to;
    edges_.expected[0] = infinity;
    run(1);
    return edges_.apex[0];
  }

 private:
  using D = SearchWindow::D;
  using V = hn::Vec<D>;
  using Cells = SearchWindow::Cells;

  static constexpr float infinity = std::numeric_limits<float>::infinity();
  static constexpr float unit_roundoff = TileCoordinates::unit_roundoff, slack = SearchWindow::slack;
  static constexpr std::size_t rows_at_once = EdgeBatch::rows_at_once, row_length = EdgeBatch::row_length;
  static constexpr std::size_t lanes = hn::MaxLanes(D());
  static constexpr std::size_t max_candidates = 64;
  static constexpr float max_reach = 4;  // the whole tile, from any point of it
  // Measured: the number of points that can be scanned in the time of a search window, of an apex in it, and of an
  // exact decision.
  static constexpr std::size_t work_of_window = 64, work_of_apex = 192, work_of_candidate = 16;

  /// Bounds the rounding errors in the numbers of an edge and of points in a box of the given width.
  void bound_errors(std::size_t edge, float width) {
    constexpr float two = 2 * TileCoordinates::rounding;
    const float extent = width * (1 + slack) + slack;
    const float chord =
        std::max(std::abs(edges_.bx[edge] - edges_.ax[edge]), std::abs(edges_.by[edge] - edges_.ay[edge]));
    const float of_e = two + unit_roundoff * extent, of_d = two + unit_roundoff * chord;
    const bool exact = extent <= at_.lattice_extent;
    error_dot_[edge] = exact ? 0 : 12.3f * extent * (of_e + unit_roundoff * extent);
    error_cross_[edge] = exact ? 0 : 2.1f * (chord * of_e + extent * of_d + 2 * unit_roundoff * chord * extent);
    right_of_[edge] = exact ? std::numeric_limits<float>::min() : -4 * error_cross_[edge];
  }

  /// An edge in every lane.
  struct Edge {
    V ax, ay, bx, by, dx, dy, error_dot, error_cross, left_of, right_of;
  };
  HWY_INLINE Edge edge_of(std::size_t i) const {
    const D d;
    const V ax = hn::Set(d, edges_.ax[i]), ay = hn::Set(d, edges_.ay[i]), bx = hn::Set(d, edges_.bx[i]),
            by = hn::Set(d, edges_.by[i]);
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

  /// Bounds of k for points, one in each lane; whether each point is certainly left of the chord, and whether it may
  /// be.
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
    const V relative = hn::MulAdd(e.error_cross, inverse, hn::Set(d, 4 * unit_roundoff));
    const V error = hn::MulAdd(hn::Abs(k), relative, e.error_dot * inverse);
    const auto valid = hn::FirstN(d, count);
    return {k - error, k + error, hn::And(valid, cross > e.left_of), hn::And(valid, cross >= e.right_of)};
  }

  /// Returns a bit for each point of the three rows, as among_three_rows() counts them: 1 for the ends of the edge.
  HWY_INLINE std::uint64_t ends_of(std::size_t edge) const {
    std::uint64_t ends = 0;
    for (std::size_t row = 0; row < rows_at_once; ++row)
      ends |= static_cast<std::uint64_t>(edges_.ends[row][edge]) << (row * row_length);
    return ends;
  }

  /// Returns the apex among the points of at most three short rows, or `none` if no point is certainly left of the
  /// chord. Every point has a bit:
  ///     47 … 32  third row    31 … 16  second row    15 … 0  first row, its first point last
  HWY_NOINLINE Index among_three_rows(std::size_t edge) {
    const D d;
    constexpr std::size_t N = lanes, per_row = row_length / N, vectors = rows_at_once * per_row;
    const Edge e = edge_of(edge);
    V low[vectors];
    hn::Mask<D> perhaps[vectors];
    V least = hn::Set(d, infinity);
    for (std::size_t j = 0; j < vectors; ++j) {
      const std::size_t row = j / per_row, skipped = j % per_row * N;
      const auto count = static_cast<std::size_t>(edges_.count[row][edge]);
      const Bounds k =
          bounds(e, static_cast<std::size_t>(edges_.first[row][edge]) + skipped, count > skipped ? count - skipped : 0);
      low[j] = hn::IfThenElse(k.left, k.low, hn::Set(d, -infinity));
      perhaps[j] = k.perhaps;
      least = hn::Min(least, hn::IfThenElse(k.left, k.high, hn::Set(d, infinity)));
    }
    const float high = least_lane(least);
    const V bound = hn::Set(d, high);
    std::uint64_t can_win = 0;
    for (std::size_t j = 0; j < vectors; ++j) can_win |= bits_of(d, hn::And(perhaps[j], low[j] <= bound)) << (j * N);
    can_win &= ~ends_of(edge);
    edges_.high[edge] = high;
    if (!(high < infinity)) return none;
    const auto point = [&](std::uint64_t bits) {
      const auto at = static_cast<std::size_t>(std::countr_zero(bits));
      return static_cast<Index>(static_cast<std::size_t>(edges_.first[at / row_length][edge]) + at % row_length);
    };
    if ((can_win & (can_win - 1)) == 0) return point(can_win);
    candidates_.clear();
    for (; can_win != 0; can_win &= can_win - 1) candidates_.push_back(point(can_win));
    return decide(edge);
  }

  /// Returns the least lane; infinity also if emulated vectors give the largest finite number in its place.
  static HWY_INLINE float least_lane(V v) {
    const float least = hn::GetLane(hn::MinOfLanes(D(), v));
    return least < std::numeric_limits<float>::max() ? least : infinity;
  }

  /// Returns the apex among candidates_, decided exactly.
  HWY_NOINLINE Index decide(std::size_t edge) const {
    const auto a = static_cast<std::size_t>(edges_.a[edge]), b = static_cast<std::size_t>(edges_.b[edge]);
    return error_cross_[edge] == 0 ? exact_.winner_on_lattice(a, b, candidates_)
                                   : exact_.winner(a, b, candidates_, none);
  }

  /// Returns the apex in a first window of more than three short rows, or `none`.
  Index among_more(std::size_t edge) {
    const auto [winner, high] = among(edge, {edges_.c0[edge], edges_.c1[edge], edges_.r0[edge], edges_.r1[edge], true});
    edges_.high[edge] = high;
    return winner;
  }

  /// Returns the apex, searched from near to far, as far as necessary; `none` if the tile's points do not decide it.
  HWY_NOINLINE Index search(std::size_t edge) {
    const float dx = edges_.bx[edge] - edges_.ax[edge], dy = edges_.by[edge] - edges_.ay[edge];
    const float length = std::sqrt(dx * dx + dy * dy);
    if (!(length > 0)) return none;
    Cells cells{edges_.c0[edge], edges_.c1[edge], edges_.r0[edge], edges_.r1[edge], edges_.is_inside[edge] != 0};
    for (float reach = edges_.found_radius[edge];;) {
      const auto [winner, high] = among(edge, cells);
      if (high < infinity) {
        const Cells needed = window_.cells_for(edge, high);
        if (cells.contain(needed)) {
          edges_.found_radius[edge] = 0.5f * length * std::sqrt(1 + high * high);
          return window_.is_known(needed) ? winner : none;
        }
        cells = cells.with(needed);
        continue;
      }
      if (!window_.is_known(cells) || reach > max_reach) return none;
      reach *= 2;
      const float ratio = std::min(2 * reach / length, SearchWindow::max_chords);
      cells = window_.cells_for(edge, std::sqrt(std::max(0.0f, ratio * ratio - 1)));
    }
  }

  /// The apex among the points of some cells, and an upper bound, in half-chords, of how far left of the chord's middle
  /// the center of the apex's circle is.
  struct Winner {
    Index point;
    float high;  // infinity without an apex
  };
  /// Returns the apex of an edge among the points of `cells`. Only the ends of loops are unpredictable branches.
  HWY_NOINLINE Winner among(std::size_t edge, const Cells& cells) {
    const D d;
    constexpr std::size_t N = lanes;
    std::size_t parts = 0;
    work_ += work_of_window;
    for (int r = cells.r0; r <= cells.r1; ++r) {
      const auto row = static_cast<std::size_t>(r * at_.columns);
      const auto end = static_cast<std::uint32_t>(at_.start[row + static_cast<std::size_t>(cells.c1) + 1]);
      const auto begin = static_cast<std::uint32_t>(at_.start[row + static_cast<std::size_t>(cells.c0)]);
      for (auto i = begin; i < end; i += N) part_[parts++] = {i, end - i, 0};
      work_ += end - begin;
    }
    bound_errors(edge, static_cast<float>(std::max(cells.c1 - cells.c0, cells.r1 - cells.r0) + 1) * at_.cell);
    const Edge e = edge_of(edge);
    V least = hn::Set(d, infinity);
    for (std::size_t j = 0; j < parts; ++j) {
      const Bounds k = bounds(e, part_[j].first, part_[j].count);
      least = hn::Min(least, hn::IfThenElse(k.left, k.high, hn::Set(d, infinity)));
      const V low = hn::IfThenElse(k.left, k.low, hn::Set(d, -infinity));
      hn::StoreU(hn::IfThenElse(k.perhaps, low, hn::Set(d, infinity)), d, low_.data() + j * N);
    }
    const float high = least_lane(least);
    if (!(high < infinity)) return {none, high};
    work_ += work_of_apex;
    const V bound = hn::Set(d, high);
    const auto a = static_cast<std::uint32_t>(edges_.a[edge]), b = static_cast<std::uint32_t>(edges_.b[edge]);
    std::uint32_t candidates = 0, last = 0;
    for (std::size_t j = 0; j < parts; ++j) {
      const V low = hn::LoadU(d, low_.data() + j * N);
      const std::uint32_t from_a = a - part_[j].first, from_b = b - part_[j].first;
      const std::uint32_t ends = (std::uint32_t{from_a < N} << from_a % N) | (std::uint32_t{from_b < N} << from_b % N);
      const auto can_win = static_cast<std::uint32_t>(bits_of(d, low <= bound)) & ~ends;
      part_[j].can_win = can_win;
      candidates += static_cast<std::uint32_t>(std::popcount(can_win));
      last = can_win != 0 ? part_[j].first + static_cast<std::uint32_t>(std::countr_zero(can_win)) : last;
    }
    // A circle with very many points on it is left to the remainder.
    if (candidates == 0 || candidates > max_candidates) return {none, high};
    if (candidates == 1) return {static_cast<Index>(last), high};
    work_ += work_of_candidate * candidates;
    candidates_.clear();
    for (std::size_t j = 0; j < parts; ++j)
      for (std::uint32_t bits = part_[j].can_win; bits != 0; bits &= bits - 1)
        candidates_.push_back(static_cast<Index>(part_[j].first + static_cast<std::uint32_t>(std::countr_zero(bits))));
    return {decide(edge), high};
  }

  /// Points of a row that fill a register.
  struct Part {
    std::uint32_t first, count, can_win;
  };

  const TileCoordinates& at_;
  EdgeBatch edges_;
  SearchWindow window_;
  ExactApex exact_;
  alignas(64) float error_dot_[EdgeBatch::size], error_cross_[EdgeBatch::size], right_of_[EdgeBatch::size];
  std::vector<Part> part_;
  std::vector<float> low_;
  std::vector<Index> candidates_;
  std::size_t work_ = 0;
};

}  // namespace
}  // namespace rbpa::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
