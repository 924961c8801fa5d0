#include "rbpa/fill/rings/noded_rings.h"

#include <algorithm>
#include <utility>

#include "rbpa/fill/rings/plane_predicates.h"
#include "rbpa/plane/grid/box.h"

namespace rbpa {
namespace {

/// A tree of bounding boxes of points; node k has the children 2 k + 1 and 2 k + 2.
class PointTree {
 public:
  /// Builds the tree of the points with the indices `used`. Throws: Cancelled.
  PointTree(std::span<const Point> points, std::vector<std::uint32_t> used, Steps& step)
      : points_(points), used_(std::move(used)) {
    if (!used_.empty()) build(0, 0, used_.size(), step);
  }

  /// Appends the indices of the points on the segment from `low` to `high`, its ends excluded, in lexicographic order
  /// of the points. Requires: low < high; `found` is empty.
  void find_between(const Point& low, const Point& high, std::vector<std::uint32_t>& found) const {
    if (!used_.empty()) look(0, 0, used_.size(), low, high, found);
    std::sort(found.begin(), found.end(), [&](std::uint32_t a, std::uint32_t b) { return points_[a] < points_[b]; });
  }

 private:
  static constexpr std::size_t leaf = 8;

  void build(std::size_t node, std::size_t first, std::size_t last, Steps& step) {
    step(last - first);
    if (boxes_.size() <= node) boxes_.resize(node + 1);
    Box box{points_[used_[first]], points_[used_[first]]};
    for (std::size_t i = first; i < last; ++i) box = common_box(box, {points_[used_[i]], points_[used_[i]]});
    boxes_[node] = box;
    if (last - first <= leaf) return;
    const bool by_x = box.high.x / 2 - box.low.x / 2 > box.high.y / 2 - box.low.y / 2;
    const auto begin = used_.begin();
    std::nth_element(begin + static_cast<std::ptrdiff_t>(first),
                     begin + static_cast<std::ptrdiff_t>(first + (last - first) / 2),
                     begin + static_cast<std::ptrdiff_t>(last), [&](std::uint32_t a, std::uint32_t b) {
                       const Point &p = points_[a], &q = points_[b];
                       return by_x ? p.x < q.x : p.y < q.y;
                     });
    build(2 * node + 1, first, first + (last - first) / 2, step);
    build(2 * node + 2, first + (last - first) / 2, last, step);
  }

  void look(std::size_t node, std::size_t first, std::size_t last, const Point& low, const Point& high,
            std::vector<std::uint32_t>& found) const {
    const Box& box = boxes_[node];
    const auto [bottom, top] = std::minmax(low.y, high.y);
    if (box.high.x < low.x || box.low.x > high.x || box.high.y < bottom || box.low.y > top) return;
    if (last - first <= leaf) {
      for (std::size_t i = first; i < last; ++i)
        if (const Point& p = points_[used_[i]]; low < p && p < high && plane_orientation(low, high, p) == 0)
          found.push_back(used_[i]);
      return;
    }
    // A box on one side of the line through the segment contains no point of the segment.
    const int sides[] = {plane_orientation(low, high, box.low), plane_orientation(low, high, box.high),
                         plane_orientation(low, high, {box.low.x, box.high.y}),
                         plane_orientation(low, high, {box.high.x, box.low.y})};
    if (std::all_of(std::begin(sides), std::end(sides), [](int side) { return side > 0; }) ||
        std::all_of(std::begin(sides), std::end(sides), [](int side) { return side < 0; }))
      return;
    look(2 * node + 1, first, first + (last - first) / 2, low, high, found);
    look(2 * node + 2, first + (last - first) / 2, last, low, high, found);
  }

  std::span<const Point> points_;
  std::vector<std::uint32_t> used_;
  std::vector<Box> boxes_;
};

}  // namespace

NodedRings node(std::span<const Point> points, std::span<const Ring> rings, Steps& step) {
  std::vector<std::uint32_t> used;
  for (const Ring& ring : rings) used.insert(used.end(), ring.points.begin(), ring.points.end());
  const auto less = [&](std::uint32_t a, std::uint32_t b) { return std::pair(points[a], a) < std::pair(points[b], b); };
  sort(used, step, less);
  std::vector<std::uint32_t> first_at(points.size());
  std::size_t kept = 0;
  for (const std::uint32_t i : used) {
    if (kept == 0 || points[used[kept - 1]] != points[i]) used[kept++] = i;
    first_at[i] = used[kept - 1];
  }
  used.resize(kept);
  const PointTree tree(points, std::move(used), step);

  NodedRings noded;
  std::vector<std::uint32_t> between;
  for (const Ring& ring : rings) {
    std::vector<std::uint32_t>& made = noded.rings.emplace_back().points;
    std::vector<std::size_t>& edge_of = noded.edge_of.emplace_back();
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
      step();
      const std::uint32_t from = first_at[ring.points[i]], to = first_at[ring.points[(i + 1) % ring.points.size()]];
      if (from == to) continue;
      made.push_back(from);
      between.clear();
      tree.find_between(std::min(points[from], points[to]), std::max(points[from], points[to]), between);
      if (points[to] < points[from]) std::reverse(between.begin(), between.end());
      made.insert(made.end(), between.begin(), between.end());
      edge_of.resize(made.size(), i);
    }
  }
  return noded;
}

}  // namespace rbpa
