#include "rbpa/plane/pivots/find_by_pivots.h"

#include <cmath>
#include <limits>
#include <utility>

#include "rbpa/plane/predicate/predicates.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rbpa/plane/pivots/find_by_pivots.cpp"
#include <hwy/foreach_target.h>
// Included last: the code below is compiled once for each kind of vector unit.
#include <hwy/highway.h>

#include "rbpa/plane/pivots/apex_search-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::HWY_NAMESPACE {
namespace {

/// An advancing front on one tile.
class TileFront {
 public:
  using Index = LocalFront::Index;
  static constexpr Index none = ApexSearch::none;

  TileFront(const Tile& tile, TileWorkspace& workspace, PivotWorkspace& own)
      : tile_(tile),
        at_(workspace.coordinates),
        front_(workspace.front),
        queue_(own.queue),
        wave_(own.wave),
        circumradius_(own.circumradius),
        apexes_(tile, workspace.coordinates) {}

  /// Runs the front. Returns false if the front has given up.
  bool run() {
    front_.begin(tile_.points.size());
    if (const std::size_t triangles = 2 * tile_.points.size() + 2; circumradius_.size() < triangles) {
      for (auto* sides : {&queue_, &wave_}) sides->resize(4 * triangles);
      circumradius_.resize(triangles);
    }
    for (std::size_t v = 0; v < tile_.points.size(); ++v) {
      if (!tile_.owned[v] || front_.is_touched(v)) continue;
      seed(static_cast<Index>(v));
      advance();
      if (has_given_up()) return false;
    }
    return true;
  }

 private:
  /// Adds a triangle at point v, which has no triangle yet, on the edge from v to the nearest point: this edge is
  /// Delaunay. Does nothing if the tile's points do not decide a triangle.
  void seed(Index v) {
    const Index q = nearest(v);
    if (q == none) return;
    circumradius_[front_.triangles()] = std::numeric_limits<float>::infinity();
    const auto note = [&](Index side, bool on_front) { activate(side, on_front); };
    if (const Index left = apexes_(v, q); left != none)
      front_.create(v, q, left, note);
    else if (const Index right = apexes_(q, v); right != none)
      front_.create(q, v, right, note);
  }

  /// Returns whether the front has given up, as searches took too long. Where points are scattered, few searches are
  /// long. Along curves and in clusters, many are. The search for the remainder (remainder.h) is faster there, and
  /// processes the points that are left.
  bool has_given_up() const {
    constexpr std::size_t max_work = 200;                          // measured: points read for a triangle
    const std::size_t in_advance = 24 + tile_.points.size() / 16;  // triangles: edges of the hull may come first
    return apexes_.work() > max_work * (front_.triangles() + in_advance);
  }

  /// Returns the point nearest to v, or `none` if the tile's points do not determine that point.
  Index nearest(Index v) const {
    constexpr float farthest = 2, slack = 0x1p-18f;
    const float x = at_.x[v], y = at_.y[v];
    for (float reach = at_.cell; reach <= farthest; reach *= 2) {
      if (x - reach < at_.x_low || x + reach > at_.x_high || y - reach < at_.y_low || y + reach > at_.y_high) break;
      const int c0 = at_.column(x - reach), c1 = at_.column(x + reach);
      const int r0 = at_.row(y - reach), r1 = at_.row(y + reach);
      if (!at_.is_known(c0, c1, r0, r1)) break;
      Index best = none;
      for (int r = r0; r <= r1; ++r) {
        const auto end = at_.start[static_cast<std::size_t>(r * at_.columns + c1 + 1)];
        for (auto i = at_.start[static_cast<std::size_t>(r * at_.columns + c0)]; i < end; ++i)
          if (i != v && (best == none || is_nearer(v, static_cast<std::size_t>(i), best))) best = static_cast<Index>(i);
      }
      if (best == none) continue;
      const float dx = at_.x[best] - x, dy = at_.y[best] - y;
      if (std::sqrt(dx * dx + dy * dy) + slack <= reach) return best;
    }
    return none;
  }
  bool is_nearer(std::size_t v, std::size_t p, std::size_t q) const {
    return Predicates<double>::compare_distances(tile_.points[v], tile_.points[p], tile_.points[q]) < 0;
  }

  /// Queues a side if it is on the front and one of its ends is owned: other sides do not concern the tile.
  void activate(Index side, bool on_front) {
    queue_[queued_] = side;
    const auto owned = static_cast<unsigned>(tile_.owned[front_.from(side)] | tile_.owned[front_.to(side)]);
    queued_ += owned & static_cast<unsigned>(on_front);
  }

  void advance() {
    while (queued_ != 0 && !has_given_up()) {
      wave_.swap(queue_);
      const std::size_t length = std::exchange(queued_, 0);
      // A stride is used, as neighbors on the front often lead to the same triangle.
      const std::size_t stride = (length + EdgeBatch::size - 1) / EdgeBatch::size;
      std::size_t size = 0;
      EdgeBatch& edges = apexes_.edges();
      Index side[EdgeBatch::size + 1];
      for (std::size_t k = 0; k < stride && !has_given_up(); ++k)
        for (std::size_t i = k; i < length; i += stride) {
          const Index s = wave_[i];
          side[size] = s;
          edges.a[size] = front_.to(s);
          edges.b[size] = front_.from(s);
          edges.expected[size] = circumradius_[s / 4];
          size += front_.across(s) == LocalFront::none;
          if (size == EdgeBatch::size) attach(side, std::exchange(size, 0));
        }
      // A batch that is not full waits for the next wave, if there is one.
      if (queued_ == 0)
        attach(side, size);
      else
        for (std::size_t i = 0; i < size; ++i) queue_[queued_++] = side[i];
    }
  }

  /// Attaches triangles across the sides of a batch.
  void attach(const Index* side, std::size_t size) {
    if (size == 0) return;
    apexes_.run(size);
    const EdgeBatch& edges = apexes_.edges();
    for (std::size_t i = 0; i < size; ++i) {
      if (edges.apex[i] == none || front_.across(side[i]) != LocalFront::none) continue;
      circumradius_[front_.triangles()] = edges.found_radius[i];
      front_.attach(side[i], static_cast<Index>(edges.a[i]), static_cast<Index>(edges.b[i]), edges.apex[i],
                    [&](Index added, bool on_front) { activate(added, on_front); });
    }
  }

  const Tile& tile_;
  const TileCoordinates& at_;
  LocalFront& front_;
  std::vector<Index>&queue_, &wave_;
  std::size_t queued_ = 0;
  std::vector<float>& circumradius_;  // for each triangle, the radius of its circle
  ApexSearch apexes_;
};

}  // namespace

bool advance_on(const Tile& tile, TileWorkspace& workspace, PivotWorkspace& own) {
  return TileFront(tile, workspace, own).run();
}

}  // namespace rbpa::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rbpa {
namespace {

HWY_EXPORT(advance_on);

/// Returns whether points lie along curves: the points fill few cells, about the same number in each, and most of these
/// cells have few neighbors with points.
bool is_along_curves(const Tile& tile) {
  constexpr double max_per_cell = 4;     // evenly scattered points have 2.3 per cell that is not empty
  constexpr double min_neighbors = 1.3;  // filled cells right or above: 1 along a curve, 1.7 if scattered
  // The mean over points of the number in their cell, divided by the mean over filled cells, is high in clusters.
  constexpr double max_occupancy = 2.5;
  const auto columns = static_cast<std::size_t>(tile.columns), cells = tile.cells();
  std::uint64_t filled = 0, neighbors = 0, squares = 0;
  // No branches, as all would be mispredicted. The last cell of a row and the first cell of the next row count as
  // neighbors: they are few.
  const auto has_points = [&](std::size_t c) { return std::uint64_t{tile.start[c] < tile.start[c + 1]}; };
  for (std::size_t c = 0; c + columns < cells; ++c) {
    const std::uint64_t count = std::uint64_t{tile.start[c + 1]} - tile.start[c], here = has_points(c);
    squares += count * count;
    filled += here;
    neighbors += here & has_points(c + 1);
    neighbors += here & has_points(c + columns);
  }
  const auto points = static_cast<double>(tile.start[cells - columns]), of_filled = static_cast<double>(filled);
  return points > max_per_cell * of_filled && static_cast<double>(neighbors) < min_neighbors * of_filled &&
         static_cast<double>(squares) * of_filled < max_occupancy * points * points;
}

}  // namespace

bool find_by_pivots(const Tile& tile, const Radius& alpha, TileWorkspace& workspace, PivotWorkspace& own,
                    TilePatch& found) {
  if (is_along_curves(tile) || !HWY_DYNAMIC_DISPATCH(advance_on)(tile, workspace, own)) return false;
  extract_patch(tile, workspace.coordinates, workspace.front, alpha, workspace.extraction, found);
  return true;
}

}  // namespace rbpa
#endif
