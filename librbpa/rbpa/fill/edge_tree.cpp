#include "rbpa/fill/edge_tree.h"

#include <algorithm>

namespace rbpa {

EdgeTree::EdgeTree(const Box& box)
    : corner_(box.low), side_(std::max(box.high.x - box.low.x, box.high.y - box.low.y)), nodes_(1) {}

std::uint32_t EdgeTree::find(const Point& from, const Point& to, std::size_t change) {
  // From the corner on, so that what is far from the origin is as exact as what is near to it.
  const double from_x = from.x - corner_.x, from_y = from.y - corner_.y, to_x = to.x - corner_.x,
               to_y = to.y - corner_.y;
  const Point middle{(from_x + to_x) / 2, (from_y + to_y) / 2};
  const double length = std::max(std::abs(to_x - from_x), std::abs(to_y - from_y));
  Point centre{side_ / 2, side_ / 2};
  double side = side_;
  std::uint32_t n = 0;
  nodes_[n].edges_below += change;
  for (int depth = 0; depth < deepest && length <= side / 2; ++depth, side /= 2) {
    const std::size_t quarter = (middle.x >= centre.x ? 1U : 0U) + (middle.y >= centre.y ? 2U : 0U);
    if (nodes_[n].child[quarter] == none) {
      nodes_[n].child[quarter] = static_cast<std::uint32_t>(nodes_.size());
      nodes_.emplace_back();
    }
    n = nodes_[n].child[quarter];
    nodes_[n].edges_below += change;
    centre = moved(centre, side, quarter);
  }
  return n;
}

void EdgeTree::insert(const FrontEdge& edge, const Point& from, const Point& to) {
  const Box box{{std::min(from.x, to.x), std::min(from.y, to.y)}, {std::max(from.x, to.x), std::max(from.y, to.y)}};
  nodes_[find(from, to, 1)].edges.push_back({edge, box});
}

void EdgeTree::erase(const FrontEdge& edge, const Point& from, const Point& to) {
  std::vector<Stored>& edges = nodes_[find(from, to, std::size_t{0} - 1)].edges;
  edges.erase(std::find_if(edges.begin(), edges.end(), [&](const Stored& stored) { return stored.edge == edge; }));
}

}  // namespace rbpa
