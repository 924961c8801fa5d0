// What:   the uniform grid of the method: cells of side 2α, and the sites in the nine cells around a point.
// Law:    all sites within 2α of a site s are in the nine cells around s. All sites that the ball can touch together
//         with both ends of an edge are in the nine cells around the middle of the edge. Both hold for coordinates of
//         any magnitude: docs/explanation/paper.md, section 2.
// Cost:   linear to build, without sorting; a query costs the number of sites in the nine cells, #V_p, which grows with
//         α².
// Source: Restricted BPA, section 3.1, "Data structure", and section 3.2: 9 pixels instead of 27 voxels.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <unordered_map>
#include <vector>

#include "meshops/patch/site.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/predicate/radius.h"

namespace rbpa::paper {

using meshops::Site;
using Real = long double;  ///< the number type of the whole method, whose exponents fit any input

class Grid {
 public:
  /// Builds the grid of `sites`, which are indices into `points`. Keeps the span `points`.
  Grid(std::span<const Point> points, std::span<const Site> sites, Radius alpha)
      : points_(points), side_(alpha.is_infinite() ? infinity : 2 * Real(alpha.value()) * widened) {
    for (const Site s : sites) cells_[cell_at(Real(points[s].x), Real(points[s].y))].push_back(s);
  }

  /// Calls visit(Site) for each site in the nine cells around site v, v itself included.
  template <typename Visit>
  void for_each_near(Site v, Visit visit) const {
    for_each_in_nine(cell_at(Real(points_[v].x), Real(points_[v].y)), visit);
  }

  /// Calls visit(Site) for each site in the nine cells around the middle of the edge ab.
  template <typename Visit>
  void for_each_near(Site a, Site b, Visit visit) const {
    const Point &p = points_[a], &q = points_[b];
    for_each_in_nine(cell_at((Real(p.x) + Real(q.x)) / 2, (Real(p.y) + Real(q.y)) / 2), visit);
  }

 private:
  static constexpr Real infinity = std::numeric_limits<Real>::infinity();
  static constexpr Real widened = 1 + 0x1p-6L;  // exceeds the rounding error of cell numbers

  /// The column and row of a cell: integers of any magnitude, from 0 at the origin.
  struct Cell {
    Real column, row;
    friend bool operator==(const Cell&, const Cell&) = default;
  };
  struct Hash {
    std::size_t operator()(const Cell& c) const {
      const std::hash<Real> hash;
      return hash(c.column) * 0x9e3779b97f4a7c15u ^ hash(c.row);
    }
  };

  Cell cell_at(Real x, Real y) const { return {std::floor(x / side_), std::floor(y / side_)}; }

  /// Returns the number of neighbors to search on each side of a cell: 1 for a cell number below 2⁶², otherwise 0. From
  /// 2⁵⁴ on, a cell number stands for a single coordinate, and no other double is within 2α of this coordinate.
  static int neighbors(Real number) { return std::abs(number) < 0x1p62L ? 1 : 0; }

  template <typename Visit>
  void for_each_in_nine(const Cell& middle, Visit& visit) const {
    const int columns = neighbors(middle.column), rows = neighbors(middle.row);
    for (int row = -rows; row <= rows; ++row)
      for (int column = -columns; column <= columns; ++column) {
        const auto cell = cells_.find({middle.column + Real(column), middle.row + Real(row)});
        if (cell == cells_.end()) continue;
        for (const Site s : cell->second) visit(s);
      }
  }

  std::span<const Point> points_;
  Real side_;
  std::unordered_map<Cell, std::vector<Site>, Hash> cells_;
};

}  // namespace rbpa::paper
