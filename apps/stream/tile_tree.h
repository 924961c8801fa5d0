// What: the plane cut in two, and each part again, until the parts are tiles.
// Law:  every point is in the box of exactly one tile.
// Cost: a point's tile is found by a comparison a cut; near sides of tiles several tiles are.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/region.h"

namespace rbpa::app {

// Distances to the sides of regions, rounded so that no point is missing.

/// At most a − b, and by little; at least a + b.
inline double below(double a, double b) {
  const double rounded = a - b;
  return rounded - std::abs(rounded) * 0x1p-52;
}
inline double above(double a, double b) {
  const double rounded = a + b;
  return rounded + std::abs(rounded) * 0x1p-52;
}

/// How far a point may be from a tile and matter for it: no less than 2 alpha; infinite beyond the range of double.
inline double reach_of(double alpha) { return std::nextafter(2 * alpha, std::numeric_limits<double>::infinity()); }

class TileTree {
 public:
  /// A part of the plane: cut at a line, or a tile.
  struct Part {
    enum class Kind : std::uint8_t { tile, cut_x, cut_y };
    Kind kind = Kind::tile;
    double line = 0;          ///< what is less is in the first part
    std::uint32_t first = 0;  ///< the parts, or in `first` the number of the tile
    std::uint32_t second = 0;
  };

  /// One tile, number 0.
  TileTree() : parts_{Part{}}, boxes_{Region{}} {}
  /// Of parts as parts() has them. Requires that they are.
  explicit TileTree(std::vector<Part> parts);

  /// The tile keeps its number for what is less, and the rest becomes a new tile, whose number is returned.
  std::uint32_t cut(std::uint32_t tile, Part::Kind kind, double line);

  std::size_t tiles() const { return boxes_.size(); }
  const Region& box(std::uint32_t tile) const { return boxes_[tile]; }
  const std::vector<Part>& parts() const { return parts_; }  ///< the first is the plane

  /// The numbers of all tiles, neighbours near each other: all of a part before what follows it.
  std::vector<std::uint32_t> order() const;

  std::uint32_t tile_of(const Point& p) const {
    const Part* part = parts_.data();
    while (part->kind != Part::Kind::tile)
      part = &parts_[(part->kind == Part::Kind::cut_x ? p.x : p.y) < part->line ? part->first : part->second];
    return part->first;
  }

  /// Calls visit(tile) for every tile that has points within `reach` of p, and perhaps for some whose points are a
  /// little farther.
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
  std::vector<Region> boxes_;                 // of each tile
  std::vector<std::uint32_t> part_of_ = {0};  // of each tile
};

}  // namespace rbpa::app
