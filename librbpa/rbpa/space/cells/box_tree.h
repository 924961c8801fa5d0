// What: a tree of boxes that finds those that meet a given box.
// Cost: n log n to build; a query visits only nodes near the box.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/progress.h"
#include "rbpa/space/predicate/bounding_box.h"

namespace rbpa::space {

class BoxTree {
 public:
  BoxTree() = default;
  /// Builds the tree. Throws: Cancelled.
  BoxTree(std::span<const Box> boxes, meshops::Steps& step);

  /// Calls visit(i) for each box i that meets `box`, in some order.
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

 private:
  /// A node of the tree. The first half of an inner node is the next node in `nodes_`.
  struct Node {
    Box box;
    std::uint32_t first, last;  // its boxes are boxes_[first] … boxes_[last − 1]
    std::uint32_t second = 0;   // node of the second half; 0 for a leaf
  };

  void build(std::span<const Box> boxes, std::uint32_t first, std::uint32_t last, meshops::Steps& step);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> numbers_;
  std::vector<Box> boxes_;  // the boxes, in the order of numbers_
};

}  // namespace rbpa::space
