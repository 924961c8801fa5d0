// What: stores boxes in a tree; finds the boxes that meet a given box, or the item in a box nearest to a point.
// Cost: n log n to build; a query visits only nodes near the given box or point.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "meshops/core/progress.h"
#include "rbpa/space/predicate/bounding_box.h"

namespace rbpa::space {

class BoxTree {
 public:
  BoxTree() = default;
  /// Builds the tree. Throws: Cancelled.
  BoxTree(std::span<const Box> boxes, meshops::Steps& step);

  /// Replaces box i. Cost: the depth of the tree; that of the first call is linear in the number of boxes.
  void replace(std::uint32_t i, const Box& box);

  /// Calls visit(i) for each box i that meets `box`, in an unspecified order.
  template <typename Visit>
  void for_each_meeting(const Box& box, const Visit& visit) const {
    if (nodes_.empty()) return;
    std::array<std::uint32_t, 64> waiting{};
    std::size_t count = 1;  // the root waits
    while (count > 0) {
      const Node& node = nodes_[waiting[--count]];
      if (!node.box.meets(box)) continue;
      if (node.second != 0) {
        waiting[count++] = node.second;
        waiting[count++] = static_cast<std::uint32_t>(&node - nodes_.data()) + 1;
        continue;
      }
      for (std::uint32_t k = node.first; k < node.last; ++k)
        if (boxes_[k].meets(box)) visit(numbers_[k]);
    }
  }

  /// Returns i and squared(i) for the i with the least squared(i), the lowest of several; nothing if all values are
  /// above `most`. squared(i) is the squared distance of p from the item in box i.
  template <typename Squared>
  std::optional<std::pair<std::uint32_t, double>> nearest(const Point3& p, double most, const Squared& squared) const {
    std::optional<std::pair<std::uint32_t, double>> best;
    if (nodes_.empty()) return best;
    std::array<std::pair<std::uint32_t, double>, 64> waiting{};
    std::size_t count = 0;
    waiting[count++] = {0, nodes_[0].box.squared_distance(p)};
    while (count > 0) {
      const auto [number, distance] = waiting[--count];
      if (!(distance <= most)) continue;
      const Node& node = nodes_[number];
      if (node.second == 0) {
        for (std::uint32_t k = node.first; k < node.last; ++k) {
          if (!(boxes_[k].squared_distance(p) <= most)) continue;
          const double found = squared(numbers_[k]);
          if (!(found <= most) || (best && found == best->second && numbers_[k] > best->first)) continue;
          best = {numbers_[k], found};
          most = found;
        }
        continue;
      }
      std::pair<std::uint32_t, double> near = {number + 1, nodes_[number + 1].box.squared_distance(p)};
      std::pair<std::uint32_t, double> far = {node.second, nodes_[node.second].box.squared_distance(p)};
      if (far.second < near.second) std::swap(near, far);
      waiting[count++] = far;
      waiting[count++] = near;
    }
    return best;
  }

 private:
  /// A node of the tree. The first child of an inner node is the next node in `nodes_`.
  struct Node {
    Box box;
    std::uint32_t first, last;  // the boxes of the node are boxes_[first] … boxes_[last − 1]
    std::uint32_t second = 0;   // number of the second child; 0 for a leaf
  };

  void build(std::span<const Box> boxes, std::uint32_t first, std::uint32_t last, meshops::Steps& step);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> numbers_;
  std::vector<Box> boxes_;               // the boxes, in the order of numbers_
  std::vector<std::uint32_t> position_;  // for each box, its index in numbers_; empty until a box is replaced
};

}  // namespace rbpa::space
