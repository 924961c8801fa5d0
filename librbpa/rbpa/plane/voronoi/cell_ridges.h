// What: the ridges around each cell of a Voronoi diagram, from the Delaunay triangulation.
// Why:  the ridges of a cell are the edges at its point, in the same order; each ridge goes from the circumcenter of
//       one triangle at the edge to that of the other.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/plane/delaunay.h"

namespace rbpa {

/// A ridge, passed with its cell on the left: the common boundary of the cell and that of the point `other`.
struct CellRidge {
  std::uint32_t other;
  std::uint32_t from, to;  ///< the triangles whose circumcenters are the ends; no_index: infinity
};

class CellRidges {
 public:
  /// Keeps a copy of `delaunay`. Cost: linear, 80 bytes a point; n log n if all points are on a line.
  CellRidges(const Delaunay& delaunay, Steps& step);

  const Delaunay& delaunay() const { return delaunay_; }
  const Point& point(std::uint32_t i) const { return delaunay_.points()[i]; }
  /// Returns whether the point has a cell: whether it equals no earlier point.
  bool has_cell(std::uint32_t point) const {
    return along_.empty() ? begin_[point] < begin_[point + 1] : begin_[point] != no_index;
  }
  /// Returns the distinct points in lexicographic order if they are on one line, otherwise nothing.
  const std::vector<std::uint32_t>& along_line() const { return along_; }

  /// Calls visit(ridge) for each ridge of the cell of `point`, counter-clockwise, an unbounded cell from infinity to
  /// infinity, until a call returns true. Requires: has_cell(point).
  template <typename Visit>
  void for_each(std::uint32_t point, Visit visit) const {
    if (!along_.empty()) {
      const std::uint32_t at = begin_[point];
      if (at > 0 && visit(CellRidge{along_[at - 1], no_index, no_index})) return;
      if (at + 1 < along_.size()) visit(CellRidge{along_[at + 1], no_index, no_index});
      return;
    }
    const std::span fan = std::span(corners_).subspan(begin_[point], begin_[point + 1] - begin_[point]);
    const Corner &first = fan.front(), &last = fan.back();
    const bool is_open = last.after != first.before;
    if (is_open && visit(CellRidge{first.before, no_index, first.triangle})) return;
    for (std::size_t i = 0; i + 1 < fan.size(); ++i)
      if (visit(CellRidge{fan[i].after, fan[i].triangle, fan[i + 1].triangle})) return;
    visit(CellRidge{last.after, last.triangle, is_open ? no_index : first.triangle});
  }

 private:
  /// A corner of a triangle at a point, and the two other corners of the triangle, counter-clockwise.
  struct Corner {
    std::uint32_t before, after, triangle;
  };
  static void put_in_order(std::span<Corner> fan, std::vector<Corner>& by_before);

  Delaunay delaunay_;
  std::vector<std::uint32_t> along_;
  // For each point the begin of its corners; its position on the line if all points are on one line.
  meshops::FreshVector<std::uint32_t> begin_;
  meshops::FreshVector<Corner> corners_;  // of each point counter-clockwise
};

}  // namespace rbpa
