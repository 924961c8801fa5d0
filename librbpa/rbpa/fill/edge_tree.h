// What:   the edges of a front by where they are: a loose quadtree, in whose cells edges come and go.
// Law:    a question visits the edges whose boxes meet its box.
// Why:    edges of a graded front differ by orders of magnitude, so that no grid of one cell size suits it.
// Cost:   the depth, at most 40, to add or remove an edge; a question costs the cells with edges that its box meets.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshops/patch/site.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/grid/box.h"

namespace rbpa {

struct FrontEdge {
  meshops::Site from, to;
  friend bool operator==(const FrontEdge&, const FrontEdge&) = default;
};

class EdgeTree {
 public:
  /// For edges within a box.
  explicit EdgeTree(const Box& box);

  void insert(const FrontEdge& edge, const Point& from, const Point& to);
  /// Requires: it was inserted with the same points.
  void erase(const FrontEdge& edge, const Point& from, const Point& to);

  /// Calls visit(FrontEdge) for those whose boxes meet it.
  template <typename Visit>
  void for_each_near(const Box& box, Visit visit) const {
    const Box inside{{box.low.x - corner_.x, box.low.y - corner_.y}, {box.high.x - corner_.x, box.high.y - corner_.y}};
    look(0, {side_ / 2, side_ / 2}, side_, inside, [&](const Stored& stored) {
      if (meet(stored.box, box)) visit(stored.edge);
    });
  }
  /// No edge lies outside of the box.
  bool is_within(const Box& box) const {
    return box.low.x <= corner_.x && box.high.x >= corner_.x + side_ && box.low.y <= corner_.y &&
           box.high.y >= corner_.y + side_;
  }
  /// Of the smallest cells.
  double least_side() const { return std::ldexp(side_, -deepest); }

 private:
  static constexpr std::uint32_t none = 0;
  static constexpr int deepest = 40;
  /// With its box, as thousands of edges may be in one cell, and few of them meet a question's box.
  struct Stored {
    FrontEdge edge;
    Box box;
  };
  struct Node {
    std::array<std::uint32_t, 4> child = {none, none, none, none};
    std::size_t edges_below = 0;  // its own included
    std::vector<Stored> edges = {};
  };

  /// The node of an edge: its middle is in the cell, and it is no longer than its side. `change` is added on the way.
  std::uint32_t find(const Point& from, const Point& to, std::size_t change);

  /// Half a side around its cell a node has no edge: a twentieth more is for what is rounded.
  template <typename Visit>
  void look(std::uint32_t n, const Point& centre, double side, const Box& box, const Visit& visit) const {
    const double reach = 1.05 * side;
    if (nodes_[n].edges_below == 0 || centre.x - reach > box.high.x || centre.x + reach < box.low.x ||
        centre.y - reach > box.high.y || centre.y + reach < box.low.y)
      return;
    for (const Stored& stored : nodes_[n].edges) visit(stored);
    for (std::size_t k = 0; k < 4; ++k)
      if (const std::uint32_t child = nodes_[n].child[k]; child != none)
        look(child, moved(centre, side, k), side / 2, box, visit);
  }
  static bool meet(const Box& a, const Box& b) {
    return a.low.x <= b.high.x && a.high.x >= b.low.x && a.low.y <= b.high.y && a.high.y >= b.low.y;
  }
  /// The centre of a quarter.
  static Point moved(const Point& centre, double side, std::size_t quarter) {
    return {centre.x + ((quarter & 1U) != 0 ? side : -side) / 4, centre.y + ((quarter & 2U) != 0 ? side : -side) / 4};
  }

  Point corner_;
  double side_;
  std::vector<Node> nodes_;
};

}  // namespace rbpa
