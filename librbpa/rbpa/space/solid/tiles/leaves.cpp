#include "rbpa/space/solid/tiles/leaves.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "rbpa/base/sort/distribute.h"

namespace rbpa::space {
namespace {

constexpr std::size_t sample_in_leaf = 64, max_depth = 20;
constexpr double points_in_cell = 2.0;

double coordinate(const Point3& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/// The planes of the tree's inner nodes, numbered 1 to 2^depth − 1. Each plane halves a sample of the node's points
/// across the longest side of the sample's bounding box.
struct Planes {
  Planes(std::span<const Point3> points, std::size_t levels)
      : depth(levels), axis(std::size_t{1} << levels), at(std::size_t{1} << levels) {
    std::vector<Point3> sample;
    const std::size_t wanted = sample_in_leaf << depth;
    for (std::size_t i = 0; i < wanted; ++i)
      sample.push_back(points[static_cast<std::size_t>(static_cast<double>(points.size()) * static_cast<double>(i) /
                                                       static_cast<double>(wanted))]);
    if (depth > 0) split(sample, 1);
  }

  std::size_t leaf_of(const Point3& p) const {
    std::size_t node = 1;
    for (std::size_t level = 0; level < depth; ++level)
      node = 2 * node + (coordinate(p, axis[node]) >= at[node] ? 1 : 0);
    return node - (std::size_t{1} << depth);
  }

  std::size_t depth;
  std::vector<std::uint8_t> axis;
  std::vector<double> at;

 private:
  void split(std::span<Point3> sample, std::size_t node) {
    const Box box = box_of(sample);
    const double x = box.high.x - box.low.x, y = box.high.y - box.low.y, z = box.high.z - box.low.z;
    const int longest = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
    std::nth_element(sample.begin(), middle, sample.end(),
                     [&](const Point3& p, const Point3& q) { return coordinate(p, longest) < coordinate(q, longest); });
    axis[node] = static_cast<std::uint8_t>(longest);
    at[node] = coordinate(*middle, longest);
    if (2 * node >= axis.size()) return;
    split(sample.first(sample.size() / 2), 2 * node);
    split(sample.subspan(sample.size() / 2), 2 * node + 1);
  }
};

/// Returns a box around most of the points. A few that are farthest out along an axis may be outside of the box.
Box box_of_most(std::span<const Point3> points, const Box& all) {
  constexpr std::size_t most_sampled = 256, left_out = 2;
  constexpr double more = 0.04;  // so that points that are spread evenly are in the box
  const std::size_t step = points.size() / most_sampled + 1;
  std::vector<double> sample;
  const auto range = [&](int axis) {
    sample.clear();
    for (std::size_t i = 0; i < points.size(); i += step) sample.push_back(coordinate(points[i], axis));
    std::sort(sample.begin(), sample.end());
    const std::size_t out = sample.size() > most_sampled / 4 ? left_out : 0;
    const double low = sample[out], high = sample[sample.size() - 1 - out], margin = more * (high - low);
    if (out == 0) return std::pair(coordinate(all.low, axis), coordinate(all.high, axis));
    return std::pair(std::max(low - margin, coordinate(all.low, axis)),
                     std::min(high + margin, coordinate(all.high, axis)));
  };
  const auto [low_x, high_x] = range(0);
  const auto [low_y, high_y] = range(1);
  const auto [low_z, high_z] = range(2);
  return {{low_x, low_y, low_z}, {high_x, high_y, high_z}};
}

/// Returns the side of cubic cells that have points_in_cell points each if the given number of points fills `box`.
double cell_size(const Box& box, std::size_t points) {
  std::array<double, 3> side = {box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z};
  std::sort(side.begin(), side.end());
  const double cells = std::max(1.0, static_cast<double>(points) / points_in_cell);
  // The points fill three dimensions; two if the shortest side is at most a cell; one if the second side is, too.
  double size = std::cbrt(side[0]) * std::cbrt(side[1]) * std::cbrt(side[2]) / std::cbrt(cells);
  if (size >= side[0]) size = std::sqrt(side[1]) * std::sqrt(side[2]) / std::sqrt(cells);
  if (size >= side[1]) size = side[2] / cells;
  return size;
}

}  // namespace

Leaves::Leaves(std::span<const Point3> points, std::size_t points_in_leaf, Threads& threads)
    : points_(points.size()), index_(points.size()) {
  std::size_t depth = 0;
  while (depth < max_depth && (points.size() >> depth) > points_in_leaf) ++depth;
  const std::size_t count = std::size_t{1} << depth;
  const Planes planes(points, depth);
  constexpr std::size_t at_a_time = 1u << 17;
  const std::vector<std::uint32_t> first = distribute(
      points.size(), count, at_a_time, threads, [&](std::size_t i) { return planes.leaf_of(points[i]); },
      [&](std::size_t i, std::uint32_t place) {
        points_[place] = points[i];
        index_[place] = static_cast<std::uint32_t>(i);
      });
  leaves_.resize(count);
  repeated_.resize(count);
  boxes_.resize(2 * count);
  std::size_t cells = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Leaf& leaf = leaves_[i];
    leaf.first = first[i], leaf.end = first[i + 1];
    leaf.box = boxes_[count + i] = box_of(std::span<const Point3>(points_).subspan(first[i], first[i + 1] - first[i]));
    if (leaf.first == leaf.end) continue;
    const std::size_t size = leaf.end - leaf.first;
    const Box most = box_of_most(std::span<const Point3>(points_).subspan(leaf.first, size), leaf.box);
    const double side = cell_size(most, size);
    leaf.grid = {most.low, side, side > 0 ? 1 / side : 0};
    if (!std::isfinite(leaf.grid.inverse)) leaf.grid.inverse = 0;
    leaf.cells = {leaf.grid.along_x(most.high.x) + 1, leaf.grid.along_y(most.high.y) + 1,
                  leaf.grid.along_z(most.high.z) + 1};
    leaf.start = cells;
    cells += static_cast<std::size_t>(leaf.cells[0]) * static_cast<std::size_t>(leaf.cells[1]) *
                 static_cast<std::size_t>(leaf.cells[2]) +
             1;
  }
  for (std::size_t node = count; node-- > 1;) {
    boxes_[node] = boxes_[2 * node];
    boxes_[node].include(boxes_[2 * node + 1]);
  }
  starts_.resize(cells);
  for_each_index(threads, count, [&](std::size_t i) { sort_leaf(i, first[i], first[i + 1]); });
  double pairs = 0;
  for (const Leaf& leaf : leaves_) {
    distinct_ += leaf.end - leaf.first;
    pairs += leaf.pairs;
  }
  crowding_ = pairs / static_cast<double>(std::max<std::size_t>(distinct_, 1));
}

void Leaves::sort_leaf(std::size_t i, Place first, Place end) {
  Leaf& leaf = leaves_[i];
  const std::size_t size = end - first;
  if (size == 0) return;
  const std::size_t rows = static_cast<std::size_t>(leaf.cells[1]), columns = static_cast<std::size_t>(leaf.cells[2]);
  const std::size_t cells = static_cast<std::size_t>(leaf.cells[0]) * rows * columns;
  Place* const start = &starts_[leaf.start];
  std::fill_n(start, cells + 1, 0);
  std::vector<std::uint32_t> cell(size);
  for (std::size_t k = 0; k < size; ++k) {
    const Point3& p = points_[first + k];
    const auto at = [](int along, int count) { return static_cast<std::size_t>(std::clamp(along, 0, count - 1)); };
    cell[k] = static_cast<std::uint32_t>(
        (at(leaf.grid.along_x(p.x), leaf.cells[0]) * rows + at(leaf.grid.along_y(p.y), leaf.cells[1])) * columns +
        at(leaf.grid.along_z(p.z), leaf.cells[2]));
    ++start[cell[k]];
  }
  Place sum = 0;
  for (std::size_t c = 0; c < cells; ++c) start[c] = sum += start[c];
  struct Indexed {
    Point3 point;
    std::uint32_t index;
  };
  std::vector<Indexed> sorted(size);
  for (std::size_t k = size; k-- > 0;) sorted[--start[cell[k]]] = {points_[first + k], index_[first + k]};
  start[cells] = static_cast<Place>(size);
  // Keep one site for each distinct point. The repeated points go to repeated_.
  const auto same = [](const Point3& p, const Point3& q) { return p.x == q.x && p.y == q.y && p.z == q.z; };
  Place to = first;
  for (std::size_t c = 0; c < cells; ++c) {
    const std::size_t from = start[c], until = start[c + 1];
    start[c] = to;
    constexpr std::size_t few = 16;
    const bool is_sorted = until - from > few;
    if (is_sorted)
      std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(from), sorted.begin() + static_cast<std::ptrdiff_t>(until),
                [](const Indexed& a, const Indexed& b) {
                  return std::tie(a.point.x, a.point.y, a.point.z, a.index) <
                         std::tie(b.point.x, b.point.y, b.point.z, b.index);
                });
    const Place first_of_cell = to;
    for (std::size_t k = from; k < until; ++k) {
      const Indexed& p = sorted[k];
      Place equal = is_sorted && to > first_of_cell ? to - 1 : first_of_cell;
      while (equal < to && !same(points_[equal], p.point)) ++equal;
      if (equal == to) {
        points_[to] = p.point;
        index_[to++] = p.index;
      } else {
        repeated_[i].push_back({p.index, equal});  // the first of equal points has the lowest index
      }
    }
  }
  start[cells] = to;
  leaf.end = to;
  for (std::size_t c = 0; c < cells; ++c) leaf.pairs += std::pow(start[c + 1] - start[c], 2);
  for (Duplicate& d : repeated_[i]) d.stands_for = index_[d.stands_for];
}

std::vector<Duplicate> Leaves::duplicates() const {
  std::vector<Duplicate> all;
  for (const auto& some : repeated_) all.insert(all.end(), some.begin(), some.end());
  std::sort(all.begin(), all.end(), [](const Duplicate& a, const Duplicate& b) { return a.index < b.index; });
  return all;
}

}  // namespace rbpa::space
