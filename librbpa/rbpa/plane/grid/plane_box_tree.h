// What: a tree of boxes, halved by their middles, that finds the boxes that meet others.
// Cost: n log n to build; a search takes log n, and the boxes that it meets.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "rbpa/base/run/steps.h"
#include "rbpa/plane/grid/box.h"

namespace rbpa {

class PlaneBoxTree {
 public:
  /// Builds the tree; boxes have their positions in `boxes` as numbers. Keeps `step`. Throws: Cancelled.
  PlaneBoxTree(std::vector<Box> boxes, Steps& step) : boxes_(std::move(boxes)), step_(step), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    if (!order_.empty()) build(root());
  }

  /// Calls visit(i) for each box i that lies in boxes of which may_meet(box) is true.
  template <typename MayMeet, typename Visit>
  void visit(MayMeet may_meet, Visit visit) const {
    if (!order_.empty()) descend(root(), may_meet, visit);
  }

  /// Calls visit(i, j) for each pair of boxes that meet, once.
  template <typename Visit>
  void visit_pairs(Visit visit) const {
    if (!order_.empty()) within(root(), visit);
  }

 private:
  static constexpr std::size_t leaf = 8;

  /// A node and its range of order_. Node k has the children 2 k + 1 and 2 k + 2.
  struct Node {
    std::size_t number, first, last;
    std::size_t size() const { return last - first; }
    bool is_leaf() const { return size() <= leaf; }
    std::size_t middle() const { return first + size() / 2; }
    Node lower() const { return {2 * number + 1, first, middle()}; }
    Node upper() const { return {2 * number + 2, middle(), last}; }
  };
  Node root() const { return {0, 0, order_.size()}; }

  static bool meet(const Box& a, const Box& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
  }

  void build(const Node& node) {
    step_(node.size());
    if (of_node_.size() <= node.number) of_node_.resize(node.number + 1);
    Box all = boxes_[order_[node.first]];
    for (std::size_t i = node.first; i < node.last; ++i) all = common_box(all, boxes_[order_[i]]);
    of_node_[node.number] = all;
    if (node.is_leaf()) return;
    const bool by_x = all.high.x / 2 - all.low.x / 2 > all.high.y / 2 - all.low.y / 2;
    const auto middle = [&](std::uint32_t i) {
      const auto& [low, high] = boxes_[i];
      return by_x ? low.x / 2 + high.x / 2 : low.y / 2 + high.y / 2;
    };
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(node.first), at(node.middle()), at(node.last),
                     [&](std::uint32_t a, std::uint32_t b) { return middle(a) < middle(b); });
    build(node.lower());
    build(node.upper());
  }

  template <typename MayMeet, typename Visit>
  void descend(const Node& node, MayMeet& may_meet, Visit& visit) const {
    if (!may_meet(of_node_[node.number])) return;
    if (!node.is_leaf()) {
      descend(node.lower(), may_meet, visit);
      return descend(node.upper(), may_meet, visit);
    }
    for (std::size_t i = node.first; i < node.last; ++i) visit(order_[i]);
  }

  template <typename Visit>
  void within(const Node& node, Visit& visit) const {
    if (!node.is_leaf()) {
      within(node.lower(), visit);
      within(node.upper(), visit);
      return between(node.lower(), node.upper(), visit);
    }
    for (std::size_t i = node.first; i < node.last; ++i)
      for (std::size_t j = i + 1; j < node.last; ++j) visit_pair(order_[i], order_[j], visit);
  }

  template <typename Visit>
  void between(const Node& a, const Node& b, Visit& visit) const {
    step_();
    if (!meet(of_node_[a.number], of_node_[b.number])) return;
    if (a.is_leaf() && b.is_leaf()) {
      for (std::size_t i = a.first; i < a.last; ++i)
        for (std::size_t j = b.first; j < b.last; ++j) visit_pair(order_[i], order_[j], visit);
      return;
    }
    if (a.size() < b.size()) return between(b, a, visit);
    between(a.lower(), b, visit);
    between(a.upper(), b, visit);
  }

  template <typename Visit>
  void visit_pair(std::uint32_t i, std::uint32_t j, Visit& visit) const {
    step_();
    if (meet(boxes_[i], boxes_[j])) visit(i, j);
  }

  std::vector<Box> boxes_, of_node_;
  Steps& step_;
  std::vector<std::uint32_t> order_;
};

}  // namespace rbpa
