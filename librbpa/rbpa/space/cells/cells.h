// What: sorts points in space into cubic cells whose side is slightly more than a radius; empty cells are not stored.
// Law:  all points within two radii of a point are in the 125 cells around the cell of the point, for coordinates of
//       any exponents. Equal points are one site. The order of the cells is a function of the set of points.
//       docs/explanation/surfaces.md, section 16.
// Cost: a sort; as much memory as the points.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/duplicate.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point3.h"

namespace rbpa::space {

using Site = std::uint32_t;  ///< a position among the distinct points in the order of cells

class Cells {
 public:
  struct Equal {
    Site site;
    std::uint32_t index;  // input index of another point equal to the site
  };

  /// Sorts the points. Requires: finite points, fewer than 2^32 − 1; a finite radius above 0.
  Cells(std::span<const Point3> points, double radius, Threads& threads);

  double radius() const { return radius_; }
  /// Returns the number of cells.
  std::size_t size() const { return cells_.size() - 1; }
  /// Returns the distinct points.
  std::span<const Point3> sites() const { return sites_; }
  /// Returns the lowest input index of each site's points.
  std::span<const std::uint32_t> input_index() const { return input_index_; }
  /// Returns the input points that are equal to one of lower index, sorted by site, then by index.
  std::span<const Equal> equals() const { return equals_; }
  /// Returns the input points that are equal to one of lower index, ascending by index.
  std::vector<Duplicate> duplicates() const;

  /// Returns the first site in cell i; first_in(size()) is the number of sites.
  Site first_in(std::size_t i) const { return cells_[i].first; }

  /// Returns the cell that contains a site.
  std::size_t cell_of(Site site) const;

  /// A search for the cells around a cell. Queries are cheap if cells are queried in ascending order.
  class Around {
   public:
    explicit Around(const Cells& cells) : cells_(cells) {}

    /// Calls visit(first, last) for runs of sites first … last − 1, in the order of sites. The runs together contain
    /// the sites in cell i and in all cells at most `reach` cells away along each axis. Requires: reach is at most 2.
    template <std::int64_t reach = 2, typename Visit>
    void for_each_run(std::size_t i, Visit visit) {
      const Key& key = cells_.cells_[i].key;
      const bool is_next = i >= last_query_;
      last_query_ = i;
      std::size_t row = 0;
      for (std::int64_t x = key[0] - reach; x <= key[0] + reach; ++x)
        for (std::int64_t y = key[1] - reach; y <= key[1] + reach; ++y, ++row) {
          std::size_t& first = first_[row];
          first = cells_.first_not_before({x, y, key[2] - reach}, is_next ? first : 0);
          std::size_t last = first;
          while (cells_.is_in_row(last, x, y, key[2] + reach)) ++last;
          if (first != last) visit(cells_.first_in(first), cells_.first_in(last));
        }
    }

   private:
    const Cells& cells_;
    std::size_t last_query_ = static_cast<std::size_t>(-1);
    std::array<std::size_t, 25> first_{};  // for each row of cells, the result of the last search
  };

 private:
  using Key = std::array<std::int64_t, 3>;
  struct Cell {
    Key key;
    Site first;
  };

  /// Returns the first cell whose key is not below `key`. Requires: all cells before `from` have lower keys.
  std::size_t first_not_before(const Key& key, std::size_t from) const;
  bool is_in_row(std::size_t cell, std::int64_t x, std::int64_t y, std::int64_t last) const {
    const Key& key = cells_[cell].key;  // valid also for cell == size()
    return cell < size() && key[0] == x && key[1] == y && key[2] <= last;
  }

  double radius_;
  std::vector<Point3> sites_;
  std::vector<std::uint32_t> input_index_;
  std::vector<Equal> equals_;
  std::vector<Cell> cells_;  // sorted by key; then one entry for the end
};

}  // namespace rbpa::space
