// What: the ridges around each cell of a Voronoi diagram, from the Delaunay triangulation.
// Why:  the ridges of a cell are the edges at its point, in the same order; each ridge goes from the circumcenter of
//       one triangle at the edge to that of the other.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "rbpa/plane/delaunay.h"

namespace rbpa {

/// A ridge, passed with its cell on the left: the common boundary of the cell and that of the point `other`.
struct CellRidge {
  std::uint32_t other;
  std::uint32_t from, to;  ///< the triangles whose circumcenters are the ends; no_index: infinity
};

class CellRidges {
 public:
  /// Keeps a copy of `delaunay`. Cost: linear; n log n if all points are on a line.
  explicit CellRidges(const Delaunay& delaunay) : delaunay_(delaunay), corner_(delaunay.points().size(), no_index) {
    const AlphaComplex& made = delaunay_.triangulation();
    for (std::uint32_t t = 0; t < made.triangles.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k)
        if (std::uint32_t& corner = corner_[made.triangles[t][k]];
            corner == no_index || made.neighbors[t][(k + 2) % 3] == no_index)
          corner = 3 * t + k;
    along_ = made.isolated;
    std::sort(along_.begin(), along_.end(), [&](auto a, auto b) { return point(a) < point(b); });
    for (std::uint32_t i = 0; i < along_.size(); ++i) corner_[along_[i]] = i;
  }

  const Delaunay& delaunay() const { return delaunay_; }
  const Point& point(std::uint32_t i) const { return delaunay_.points()[i]; }
  /// Returns whether the point has a cell: whether it equals no earlier point.
  bool has_cell(std::uint32_t point) const { return corner_[point] != no_index; }
  /// Returns the distinct points in lexicographic order if they are on one line, otherwise nothing.
  const std::vector<std::uint32_t>& along_line() const { return along_; }

  /// Calls visit(ridge) for each ridge of the cell of `point`, counter-clockwise, an unbounded cell from infinity to
  /// infinity, until a call returns true. Requires: has_cell(point).
  template <typename Visit>
  void for_each(std::uint32_t point, Visit visit) const {
    const AlphaComplex& made = delaunay_.triangulation();
    const std::uint32_t first = corner_[point];
    if (!along_.empty()) {
      if (first > 0 && visit(CellRidge{along_[first - 1], no_index, no_index})) return;
      if (first + 1 < along_.size()) visit(CellRidge{along_[first + 1], no_index, no_index});
      return;
    }
    std::uint32_t t = first / 3, k = first % 3;
    if (made.neighbors[t][(k + 2) % 3] == no_index && visit(CellRidge{made.triangles[t][(k + 1) % 3], no_index, t}))
      return;
    const std::uint32_t begin = t;
    do {
      const std::uint32_t next = made.neighbors[t][(k + 1) % 3];
      if (visit(CellRidge{made.triangles[t][(k + 2) % 3], t, next}) || next == no_index) return;
      t = next;
      const Triangle& corners = made.triangles[t];
      k = static_cast<std::uint32_t>(std::find(corners.begin(), corners.end(), point) - corners.begin());
    } while (t != begin);
  }

 private:
  Delaunay delaunay_;
  // For each point a corner 3 t + k at which its ridges begin; its position on the line if all are on one line.
  std::vector<std::uint32_t> corner_;
  std::vector<std::uint32_t> along_;
};

}  // namespace rbpa
