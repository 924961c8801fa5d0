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

/// A grid of cells whose side is a little over half the distance. Vertices in one cell are near each other, and near
/// vertices are in cells at most two apart along each axis. Positions are scaled by a power of two, so that nothing
/// overflows. The grid only chooses the pairs to compare; are_within() decides. If half the distance is below 2⁻⁴⁰ of
/// the box, the side is 2⁻⁴⁰ of the box, and vertices in one cell are compared too.
class NearVertices {
 public:
  NearVertices(const Positions& positions, double distance)
      : positions_(positions), distance_(distance), sets_(positions.size()) {
    place();
    for (std::size_t i = 0; i < vertices_.size(); ++i)
      if (i == 0 || vertices_[i].cell != vertices_[i - 1].cell) begin_.push_back(i);
    begin_.push_back(vertices_.size());
  }

  std::vector<std::uint32_t> operator()() {
    for (std::size_t c = 0; c + 1 < begin_.size(); ++c) join_within(c);
    // Search only neighbors that come after a cell in the order of cells: half of all neighbors.
    for (std::int64_t x = 0; x <= 2; ++x)
      for (std::int64_t y = -2; y <= 2; ++y)
        if (x > 0 || y >= 0) join_across(x, y, x == 0 && y == 0 ? 1 : -2);
    std::vector<std::uint32_t> least(positions_.size());
    for (std::uint32_t i = 0; i < least.size(); ++i) least[i] = sets_.find(i);
    return least;
  }

 private:
  struct Placed {
    Cell cell;
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
    // Enlarge the side by 1/256: rounding changes (position - low) / side by less than 2⁻¹² cells.
    double side = std::scalbn(distance_, -exponent) / 2 * (1 + 1.0 / 256);
    is_near_within_ = side >= size / most_cells && side > 0x1p-1000;
    if (!is_near_within_) side = std::max({side, size / most_cells, 0x1p-1000});
    vertices_.reserve(positions_.size());
    for (std::uint32_t i = 0; i < positions_.size(); ++i) {
      if (i % 16384 == 0) stop_if_interrupted();
      Placed placed{{}, i};
      for (std::size_t k = 0; k < 3; ++k)
        placed.cell[k] = static_cast<std::int64_t>((std::scalbn(positions_[i][k], -exponent) - low[k]) / side);
      vertices_.push_back(placed);
    }
    sort(vertices_);
  }

  void join_within(std::size_t cell) {
    if (!is_near_within_) return join(cell, cell);
    for (std::size_t i = begin_[cell] + 1; i < begin_[cell + 1]; ++i)
      sets_.join(vertices_[begin_[cell]].vertex, vertices_[i].vertex);
  }

  /// Joins each cell with the cells that are `x` and `y` cells away along x and y, and `first` to 2 cells along z.
  void join_across(std::int64_t x, std::int64_t y, std::int64_t first) {
    for (std::size_t c = 0, other = 0; c + 1 < begin_.size(); ++c) {
      if (c % 1024 == 0) stop_if_interrupted();
      const Cell& cell = vertices_[begin_[c]].cell;
      const Cell low = {cell[0] + x, cell[1] + y, cell[2] + first}, high = {low[0], low[1], cell[2] + 2};
      while (other + 1 < begin_.size() && vertices_[begin_[other]].cell < low) ++other;
      for (std::size_t k = other; k + 1 < begin_.size() && vertices_[begin_[k]].cell <= high; ++k) join(c, k);
    }
  }

  /// Joins two cells if a vertex of one is near a vertex of the other. Unless is_near_within_, compares all pairs of
  /// vertices, and joins every near pair.
  void join(std::size_t cell, std::size_t other) {
    if (is_near_within_ && sets_.find(vertices_[begin_[cell]].vertex) == sets_.find(vertices_[begin_[other]].vertex))
      return;
    for (std::size_t i = begin_[cell]; i < begin_[cell + 1]; ++i) {
      stop_if_interrupted();
      for (std::size_t k = begin_[other]; k < begin_[other + 1]; ++k) {
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
  bool is_near_within_ = true;      // whether all vertices in one cell are near each other
  std::vector<Placed> vertices_;    // all vertices, in the order of their cells
  std::vector<std::size_t> begin_;  // index of the first vertex of each cell, and the end
};

}  // namespace

std::vector<std::uint32_t> near_vertices(const Positions& positions, double distance) {
  if (positions.empty() || distance == 0) return at_equal_places(positions);
  return NearVertices(positions, distance)();
}

}  // namespace rbpa::app
