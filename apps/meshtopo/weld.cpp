#include "meshtopo/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <limits>

#include "io/interrupt.h"
#include "io/mesh/equal_positions.h"
#include "io/sort.h"
#include "meshops/core/disjoint_sets.h"
#include "meshtopo/exact.h"

namespace rbpa::app {
namespace {

using Positions = std::vector<Position>;
using Cell = std::array<std::int64_t, 3>;

std::vector<std::uint32_t> at_equal_places(const Positions& positions) {
  EqualPositions places(positions.size());
  std::vector<std::uint32_t> least(positions.size());
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    if (i % 16384 == 0) stop_if_interrupted();
    least[i] = places.first_at(positions, i);
  }
  return least;
}

/// A grid of cells with a side a little over half the distance, eight of them in a block: vertices in one cell are near
/// each other, and near vertices are in blocks that touch. Positions are scaled by a power of two, so that nothing
/// overflows, and only choose the pairs to compare: are_within() decides. If the distance is tiny beside the box, the
/// cells are larger, 2⁴⁰ along the box; then vertices of one cell are compared, too.
class NearVertices {
 public:
  NearVertices(const Positions& positions, double distance)
      : positions_(positions), distance_(distance), sets_(positions.size()) {
    place();
    for (std::size_t begin = 0; begin < vertices_.size(); begin = end_of_block(begin)) blocks_.push_back(begin);
    blocks_.push_back(vertices_.size());
  }

  std::vector<std::uint32_t> operator()() {
    for (std::size_t b = 0; b + 1 < blocks_.size(); ++b) join_within(b);
    // Only half of the 26 neighbors of a block, those after it in the order of blocks, have to be searched.
    for (std::int64_t x = 0; x <= 1; ++x)
      for (std::int64_t y = -1; y <= 1; ++y)
        for (std::int64_t z = -1; z <= 1; ++z)
          if (Cell offset = {x, y, z}; offset > Cell{0, 0, 0}) join_across(offset);
    std::vector<std::uint32_t> least(positions_.size());
    for (std::uint32_t i = 0; i < least.size(); ++i) least[i] = sets_.find(i);
    return least;
  }

 private:
  struct Placed {
    Cell block, cell;
    std::uint32_t vertex;
    friend auto operator<=>(const Placed&, const Placed&) = default;
  };

  void place() {
    constexpr double infinity = std::numeric_limits<double>::infinity(), most_cells = 0x1p40;
    double greatest = distance_;
    for (const Position& p : positions_)
      for (const double x : p) greatest = std::max(greatest, std::abs(x));
    const int exponent = std::ilogb(greatest) + 1;
    Position low = {infinity, infinity, infinity};
    double size = 0;
    for (const Position& p : positions_)
      for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], std::scalbn(p[k], -exponent));
    for (const Position& p : positions_)
      for (std::size_t k = 0; k < 3; ++k) size = std::max(size, std::scalbn(p[k], -exponent) - low[k]);
    // The error of a quotient is below 2⁻¹², which the extra 1/256 of the side covers.
    double side = std::scalbn(distance_, -exponent) / 2 * (1 + 1.0 / 256);
    is_near_within_ = side >= size / most_cells && side > 0x1p-1000;
    if (!is_near_within_) side = std::max({side, size / most_cells, 0x1p-1000});
    vertices_.reserve(positions_.size());
    for (std::uint32_t i = 0; i < positions_.size(); ++i) {
      if (i % 16384 == 0) stop_if_interrupted();
      Placed placed{{}, {}, i};
      for (std::size_t k = 0; k < 3; ++k) {
        placed.cell[k] = static_cast<std::int64_t>((std::scalbn(positions_[i][k], -exponent) - low[k]) / side);
        placed.block[k] = placed.cell[k] / 2;
      }
      vertices_.push_back(placed);
    }
    sort(vertices_);
  }

  std::size_t end_of_block(std::size_t begin) const {
    std::size_t end = begin + 1;
    while (end < vertices_.size() && vertices_[end].block == vertices_[begin].block) ++end;
    return end;
  }
  std::size_t end_of_cell(std::size_t begin, std::size_t end_of_block) const {
    std::size_t end = begin + 1;
    while (end < end_of_block && vertices_[end].cell == vertices_[begin].cell) ++end;
    return end;
  }

  /// The vertices of one cell, as a range of `vertices_`.
  struct Range {
    std::size_t begin, end;
  };

  void join_within(std::size_t block) {
    stop_if_interrupted();
    const std::size_t end = blocks_[block + 1];
    for (Range cell{blocks_[block], 0}; cell.begin < end; cell.begin = cell.end) {
      cell.end = end_of_cell(cell.begin, end);
      for (std::size_t i = cell.begin + 1; i < cell.end; ++i) {
        if (is_near_within_)
          sets_.join(vertices_[cell.begin].vertex, vertices_[i].vertex);
        else
          join(cell, {i, i + 1});
      }
    }
    for (Range cell{blocks_[block], 0}; cell.begin < end; cell.begin = cell.end) {
      cell.end = end_of_cell(cell.begin, end);
      join_from(cell, cell.end, end);
    }
  }

  void join_across(const Cell& offset) {
    std::size_t other = 0;
    for (std::size_t b = 0; b + 1 < blocks_.size(); ++b) {
      if (b % 1024 == 0) stop_if_interrupted();
      Cell wanted = vertices_[blocks_[b]].block;
      for (std::size_t k = 0; k < 3; ++k) wanted[k] += offset[k];
      while (other + 1 < blocks_.size() && vertices_[blocks_[other]].block < wanted) ++other;
      if (other + 1 == blocks_.size()) return;
      if (vertices_[blocks_[other]].block != wanted) continue;
      for (Range cell{blocks_[b], 0}; cell.begin < blocks_[b + 1]; cell.begin = cell.end) {
        cell.end = end_of_cell(cell.begin, blocks_[b + 1]);
        join_from(cell, blocks_[other], blocks_[other + 1]);
      }
    }
  }

  /// Joins a cell with the cells of a block that begins at `begin`.
  void join_from(const Range& cell, std::size_t begin, std::size_t end) {
    for (Range other{begin, 0}; other.begin < end; other.begin = other.end) {
      other.end = end_of_cell(other.begin, end);
      join(cell, other);
    }
  }

  /// Joins two cells if a pair of their vertices is near; compares all pairs if vertices of one cell need not be near.
  void join(const Range& cell, const Range& other) {
    if (is_near_within_ && sets_.find(vertices_[cell.begin].vertex) == sets_.find(vertices_[other.begin].vertex))
      return;
    for (std::size_t i = cell.begin; i < cell.end; ++i) {
      stop_if_interrupted();
      for (std::size_t k = other.begin; k < other.end; ++k) {
        const std::uint32_t a = vertices_[i].vertex, b = vertices_[k].vertex;
        if (i == k || sets_.find(a) == sets_.find(b) || !are_within(positions_[a], positions_[b], distance_)) continue;
        sets_.join(a, b);
        if (is_near_within_) return;
      }
    }
  }

  const Positions& positions_;
  const double distance_;
  meshops::DisjointSets sets_;
  bool is_near_within_ = true;       // vertices in one cell are near each other
  std::vector<Placed> vertices_;     // in the order of blocks and cells
  std::vector<std::size_t> blocks_;  // first vertex of each block, and the end
};

}  // namespace

std::vector<std::uint32_t> near_vertices(const Positions& positions, double distance) {
  if (positions.empty() || distance == 0) return at_equal_places(positions);
  return NearVertices(positions, distance)();
}

}  // namespace rbpa::app
