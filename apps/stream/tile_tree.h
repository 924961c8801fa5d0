// What: stores a tree that cuts the plane in two, and each part again, until the parts are tiles.
// Law:  every point is in the box of exactly one tile.
// Cost: finding the tile of a point takes one comparison for each cut above the tile; finding the tiles near a point
//       takes one descent for each tile in reach.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/plane/region.h"

namespace rbpa::app {

// The bounds below are rounded outward, so that no point within a distance is missed.

/// Return a number close to a − b and at most a − b; a number close to a + b and at least a + b.
inline double below(double a, double b) {
  const double rounded = a - b;
  return rounded - std::abs(rounded) * 0x1p-52;
}
inline double above(double a, double b) {
  const double rounded = a + b;
  return rounded + std::abs(rounded) * 0x1p-52;
}

/// Returns the distance from a tile up to which points matter for the tile: the next double above 2 alpha, or infinity.
inline double reach_of(double alpha) { return std::nextafter(2 * alpha, std::numeric_limits<double>::infinity()); }

class TileTree {
 public:
  /// A part of the plane: a tile, or a part that a line cuts in two.
  struct Part {
    enum class Kind : std::uint8_t { tile, cut_x, cut_y };
    Kind kind = Kind::tile;
    double line = 0;          ///< coordinate of the cut; the first part has the smaller coordinates
    std::uint32_t first = 0;  ///< numbers of the two parts; in a tile `first` is the number of the tile
    std::uint32_t second = 0;
  };

  /// Makes a tree of one tile with number 0: the whole plane.
  TileTree() : parts_{Part{}}, boxes_{Region{}} {}
  /// Makes a tree of `parts`. Requires: parts() of a tree has returned `parts`.
  explicit TileTree(std::vector<Part> parts);

  /// Cuts tile number `tile` at a line. The half with the smaller coordinates keeps the number. Returns the number of
  /// the other half.
  std::uint32_t cut(std::uint32_t tile, Part::Kind kind, double line);

  std::size_t tiles() const { return boxes_.size(); }
  const Region& box(std::uint32_t tile) const { return boxes_[tile]; }
  /// Returns all parts: parts that are cut, and tiles. Part 0 is the whole plane.
  const std::vector<Part>& parts() const { return parts_; }

  /// Returns the numbers of all tiles in the order of a walk through the tree. Tiles that are neighbors are mostly
  /// close to each other in this order.
  std::vector<std::uint32_t> order() const;

  std::uint32_t tile_of(const Point& p) const {
    const Part* part = parts_.data();
    while (part->kind != Part::Kind::tile)
      part = &parts_[(part->kind == Part::Kind::cut_x ? p.x : p.y) < part->line ? part->first : part->second];
    return part->first;
  }

  /// Calls visit(tile) for every tile within `reach` of p along both axes, possibly also for tiles slightly farther
  /// away.
  template <typename Visit>
  void for_each_near(const Point& p, double reach, Visit visit) const {
    const Point low{below(p.x, reach), below(p.y, reach)}, high{above(p.x, reach), above(p.y, reach)};
    visit_near(0, low, high, visit);
  }

 private:
  template <typename Visit>
  void visit_near(std::uint32_t at, const Point& low, const Point& high, Visit& visit) const {
    while (parts_[at].kind != Part::Kind::tile) {
      const Part& part = parts_[at];
      const bool x = part.kind == Part::Kind::cut_x;
      const bool first = (x ? low.x : low.y) < part.line, second = (x ? high.x : high.y) >= part.line;
      if (first && second) visit_near(part.second, low, high, visit);
      at = first ? part.first : part.second;
    }
    visit(parts_[at].first);
  }

  std::vector<Part> parts_;
  std::vector<Region> boxes_;                 // box of each tile
  std::vector<std::uint32_t> part_of_ = {0};  // number of the part that is each tile
};

}  // namespace rbpa::app
