#include "rbpa/space/cells/box_tree.h"

#include <numeric>

namespace rbpa::space {
namespace {

constexpr std::uint32_t leaf_size = 6;

/// Returns the middle of a box along an axis. Coordinates are halved before the sum, which could overflow otherwise.
double middle(const Box& box, int axis) {
  if (axis == 0) return box.low.x / 2 + box.high.x / 2;
  if (axis == 1) return box.low.y / 2 + box.high.y / 2;
  return box.low.z / 2 + box.high.z / 2;
}

int longest_axis(const Box& box) {
  const double x = box.high.x / 2 - box.low.x / 2, y = box.high.y / 2 - box.low.y / 2,
               z = box.high.z / 2 - box.low.z / 2;
  if (x >= y && x >= z) return 0;
  return y >= z ? 1 : 2;
}

}  // namespace

BoxTree::BoxTree(std::span<const Box> boxes, meshops::Steps& step) : numbers_(boxes.size()) {
  std::iota(numbers_.begin(), numbers_.end(), std::uint32_t{0});
  if (!boxes.empty()) build(boxes, 0, static_cast<std::uint32_t>(boxes.size()), step);
  boxes_.reserve(boxes.size());
  for (const std::uint32_t number : numbers_) boxes_.push_back(boxes[number]);
}

void BoxTree::build(std::span<const Box> boxes, std::uint32_t first, std::uint32_t last, meshops::Steps& step) {
  step(last - first);
  const std::size_t at = nodes_.size();
  nodes_.push_back({.box = {}, .first = first, .last = last});
  Box middles;
  for (std::uint32_t k = first; k < last; ++k) {
    const Box& box = boxes[numbers_[k]];
    nodes_[at].box.include(box);
    middles.include(Point3{middle(box, 0), middle(box, 1), middle(box, 2)});
  }
  if (last - first <= leaf_size) return;
  const int axis = longest_axis(middles);
  const std::uint32_t half = first + (last - first) / 2;
  const auto place = [&](std::uint32_t k) { return numbers_.begin() + static_cast<std::ptrdiff_t>(k); };
  std::nth_element(place(first), place(half), place(last),
                   [&](std::uint32_t i, std::uint32_t j) { return middle(boxes[i], axis) < middle(boxes[j], axis); });
  build(boxes, first, half, step);
  nodes_[at].second = static_cast<std::uint32_t>(nodes_.size());
  build(boxes, half, last, step);
}

void BoxTree::replace(std::uint32_t i, const Box& box) {
  if (position_.empty()) {
    position_.resize(numbers_.size());
    for (std::uint32_t k = 0; k < numbers_.size(); ++k) position_[numbers_[k]] = k;
  }
  const std::uint32_t k = position_[i];
  if (boxes_[k] == box) return;
  boxes_[k] = box;
  std::array<std::uint32_t, 64> above{};
  std::size_t count = 0;
  std::uint32_t at = 0;
  while (nodes_[at].second != 0) {
    above[count++] = at;
    at = k < nodes_[nodes_[at].second].first ? at + 1 : nodes_[at].second;
  }
  Box whole;
  for (std::uint32_t j = nodes_[at].first; j < nodes_[at].last; ++j) whole.include(boxes_[j]);
  while (whole != nodes_[at].box) {
    nodes_[at].box = whole;
    if (count == 0) return;
    at = above[--count];
    whole = nodes_[at + 1].box;
    whole.include(nodes_[nodes_[at].second].box);
  }
}

}  // namespace rbpa::space
