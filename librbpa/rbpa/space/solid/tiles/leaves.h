// What: sorts points in space into leaves of a k-d tree, each of some thousand points, and the points of a leaf into
//       cubic cells that fit the leaf's density.
// Law:  equal points are one site, represented by the lowest index. The order of sites may depend on the order of the
//       points; results computed from the sites do not.
// Cost: a few comparisons a point to build the tree, whose planes come from a sample; a counting sort for the cells.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/duplicate.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/predicate/bounding_box.h"

namespace rbpa::space {

/// A position in the order of leaves and cells: the position of a site, or an unused one where a point repeats another.
using Place = std::uint32_t;

/// A map from points to cubic cells. Along each axis, the cell is a monotone function of the coordinate, so that a
/// value between two coordinates is in a cell between the cells of these coordinates.
struct CellGrid {
  Point3 low;
  double size = 1, inverse = 1;

  int along_x(double x) const { return floor_of((x - low.x) * inverse); }
  int along_y(double y) const { return floor_of((y - low.y) * inverse); }
  int along_z(double z) const { return floor_of((z - low.z) * inverse); }

  static constexpr int farthest = 1 << 20;  ///< greatest absolute number of a cell

 private:
  static int floor_of(double value) {
    // Rounds down without a function call; the conversion rounds toward 0.
    constexpr double limit = farthest;
    const double bounded = value < -limit ? -limit : value > limit ? limit : value;
    const int whole = static_cast<int>(bounded);
    return whole - (static_cast<double>(whole) > bounded ? 1 : 0);
  }
};

struct Leaf {
  Box box;        ///< bounding box of the leaf's points
  CellGrid grid;  ///< grid of the leaf; `low` is the corner of a box around most points
  /// Number of cells along each axis. Points beyond these cells are in the outermost ones.
  std::array<int, 3> cells{};
  Place first = 0, end = 0;  ///< the leaf's sites are first … end − 1
  std::size_t start = 0;     ///< beginning of the leaf's table of cells in Leaves::starts_
  double pairs = 0;          ///< number of ordered pairs of sites in one cell, each site with itself included
};

class Leaves {
 public:
  /// Sorts the points. A leaf has about `points_in_leaf` points at most, unless 2^20 leaves are too few. Requires:
  /// finite points that fit double (base/exact/magnitude.h), fewer than 2^32 − 1.
  Leaves(std::span<const Point3> points, std::size_t points_in_leaf, Threads& threads);

  std::size_t size() const { return leaves_.size(); }
  const Leaf& operator[](std::size_t i) const { return leaves_[i]; }
  const Box& box() const { return boxes_[1]; }

  /// Returns the number of places, one for each input point. If points of a leaf repeat others, its last places are
  /// unused.
  std::size_t places() const { return points_.size(); }
  std::size_t distinct() const { return distinct_; }
  /// Returns the average number of sites in the cell of a site, about three for points spread evenly at random.
  double crowding() const { return crowding_; }
  const Point3& point(Place place) const { return points_[place]; }
  /// Returns the input index of each place.
  std::span<const std::uint32_t> index() const { return index_; }
  /// Moves the array of index() to the caller; afterwards index() is empty.
  meshops::FreshVector<std::uint32_t> release_index() { return std::move(index_); }
  std::vector<Duplicate> duplicates() const;

  /// Returns the first site of cell number `cell` of `leaf`; the end of the last cell if `cell` is the number of cells.
  Place first_in(const Leaf& leaf, std::size_t cell) const { return starts_[leaf.start + cell]; }

  /// Calls visit(i) for each leaf i whose box touches `box`, in ascending order.
  template <typename Visit>
  void for_each_leaf(const Box& box, Visit visit) const {
    visit_below(1, box, visit);
  }

 private:
  template <typename Visit>
  void visit_below(std::size_t node, const Box& box, Visit& visit) const {
    if (!boxes_[node].meets(box)) return;
    if (node >= leaves_.size()) return visit(node - leaves_.size());
    visit_below(2 * node, box, visit);
    visit_below(2 * node + 1, box, visit);
  }
  void sort_leaf(std::size_t i, Place first, Place end);

  std::vector<Box> boxes_;  // of the nodes: 1 is the root; 2 i and 2 i + 1 are the children of i
  std::vector<Leaf> leaves_;
  meshops::FreshVector<Point3> points_;
  meshops::FreshVector<std::uint32_t> index_;
  meshops::FreshVector<Place> starts_;
  std::size_t distinct_ = 0;
  double crowding_ = 0;
  std::vector<std::vector<Duplicate>> repeated_;  // for each leaf, the points that repeat others
};

}  // namespace rbpa::space
