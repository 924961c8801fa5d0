#include "rbpa/fill/rings/noded_rings.h"

#include <algorithm>
#include <utility>

#include "rbpa/plane/grid/plane_box_tree.h"
#include "rbpa/plane/predicate/plane_predicates.h"

namespace rbpa {
namespace {

/// Points that are prepared for searches.
class PointsOfRings {
 public:
  /// Prepares the points with the indices `used`. Throws: Cancelled.
  PointsOfRings(std::span<const Point> points, std::vector<std::uint32_t> used, Steps& step)
      : points_(points), used_(std::move(used)), tree_(boxes(), step) {}

  /// Appends the indices of the points on the segment from `low` to `high`, its ends excluded, in lexicographic order
  /// of the points. Requires: low < high; `found` is empty.
  void find_between(const Point& low, const Point& high, std::vector<std::uint32_t>& found) const {
    const double bottom = std::min(low.y, high.y), top = std::max(low.y, high.y);
    const auto may_meet = [&](const Box& box) {
      if (box.high.x < low.x || box.low.x > high.x || box.high.y < bottom || box.low.y > top) return false;
      // A box on one side of the line through the segment contains no point of the segment.
      const int sides[] = {plane_orientation(low, high, box.low), plane_orientation(low, high, box.high),
                           plane_orientation(low, high, {box.low.x, box.high.y}),
                           plane_orientation(low, high, {box.high.x, box.low.y})};
      return !std::all_of(std::begin(sides), std::end(sides), [](int side) { return side > 0; }) &&
             !std::all_of(std::begin(sides), std::end(sides), [](int side) { return side < 0; });
    };
    tree_.visit(may_meet, [&](std::uint32_t i) {
      if (const Point& p = points_[used_[i]]; low < p && p < high && plane_orientation(low, high, p) == 0)
        found.push_back(used_[i]);
    });
    std::sort(found.begin(), found.end(), [&](std::uint32_t a, std::uint32_t b) { return points_[a] < points_[b]; });
  }

 private:
  std::vector<Box> boxes() const {
    std::vector<Box> boxes;
    for (const std::uint32_t i : used_) boxes.push_back({points_[i], points_[i]});
    return boxes;
  }

  std::span<const Point> points_;
  std::vector<std::uint32_t> used_;
  PlaneBoxTree tree_;
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
  const PointsOfRings tree(points, std::move(used), step);

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
