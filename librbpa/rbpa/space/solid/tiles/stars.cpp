#include "rbpa/space/solid/tiles/stars.h"

#include <algorithm>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rbpa/space/solid/tiles/stars.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h: the code below is compiled once for each kind of vector unit.
#include <hwy/highway.h>

#include "rbpa/space/solid/tiles/open_faces-inl.h"
#include "rbpa/space/solid/tiles/sphere_search-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rbpa::space::HWY_NAMESPACE {
namespace {

class StarSearch : public StarFinder, private SphereSearch {
 public:
  StarSearch(const Leaves& leaves, const Spread& spread, double alpha) : SphereSearch(spread, alpha), leaves_(leaves) {}

  void find(std::size_t leaf, Stars& found) override {
    found_ = &found;
    found.tetrahedra.clear();
    found.neighbors.clear();
    found.border.clear();
    found.unsettled.clear();
    found.is_within.clear();
    found.shared.clear();
    found.shared_is_within.clear();
    found.exact = 0;
    const Leaf& of = leaves_[leaf];
    if (!tile_.gather(leaves_, leaf)) {
      for (Place i = of.first; i < of.end; ++i) found.unsettled.push_back(i);
      return;
    }
    start(of);
    is_settled_.assign(of.end - of.first, 0);
    const auto& cells = tile_.cells();
    for (int x = Tile::margin; x < cells[0] - Tile::margin; ++x)
      for (int y = Tile::margin; y < cells[1] - Tile::margin; ++y)
        for (int z = Tile::margin; z < cells[2] - Tile::margin; z += at_once)
          if (!is_abandoned()) complete_cells({x, y, z}, std::min(at_once, cells[2] - Tile::margin - z));
    found.exact = exact_;
    link();
  }

 private:
  using Corners = std::array<std::uint16_t, 4>;
  static constexpr std::uint32_t none = Stars::none;
  /// The value in across_ for a face without a neighbor. Tetrahedron 0 does not exist.
  static constexpr std::uint32_t nobody = 0;
  /// The rank of points at which no face waits: points outside of the leaf, and points that were given up. The rank of
  /// any other point is its number in the leaf.
  static constexpr std::uint32_t waits_for_nothing = 1U << 16U;

  void start(const Leaf& leaf) {
    const std::size_t size = tile_.size();
    start_tile(leaf);
    open_.clear(leaf.end - leaf.first);
    if (rank_.size() < size) rank_.resize(2 * size);
    std::uint32_t own = 0;
    is_reached_.assign(size, 0);
    is_finished_.assign(size, 0);
    std::fill_n(rank_.begin(), size, waits_for_nothing);
    for_each_row(leaf_cells(), [&](Local first, Local end) {
      for (Local i = first; i < end; ++i)
        if (tile_.is_own(i)) rank_[i] = own++;
    });
    count_ = 1;
    completed_ = failures_ = 0;
    of_leaf_ = leaf.end - leaf.first;
    make_room();
  }

  /// Returns whether the search in the tile is abandoned. The test begins after an eighth of the leaf's points, at
  /// least 64. The search is abandoned if more than three quarters of the points visited are unsettled, or if exact
  /// decisions, which take long, are more than twelve a point.
  bool is_abandoned() const {
    constexpr std::size_t fewest = 64, most_exact = 12;
    return completed_ >= std::max(fewest, of_leaf_ / 8) &&
           (failures_ > completed_ / 4 * 3 || exact_ > most_exact * completed_);
  }

  /// Maximum number of consecutive cells of a row that share a block.
  static constexpr int at_once = 2;

  /// Returns the ranges without `left_out` cells at each end of each axis.
  static std::array<Tile::Range, 3> inner(std::array<Tile::Range, 3> cells, int left_out) {
    for (Tile::Range& range : cells) range = {range.low + left_out, range.high - left_out};
    return cells;
  }
  std::array<Tile::Range, 3> leaf_cells() const {
    const auto& cells = tile_.cells();
    return inner({{{0, cells[0] - 1}, {0, cells[1] - 1}, {0, cells[2] - 1}}}, Tile::margin);
  }

  void complete_cells(const std::array<int, 3>& first_cell, int count) {
    const std::size_t c = tile_.cell(first_cell[0], first_cell[1], first_cell[2]);
    const Local first = tile_.first_in(c), end = tile_.first_in(c + static_cast<std::size_t>(count));
    bool is_gathered = false;
    for (Local v = first; v < end; ++v) {
      if (!tile_.is_own(v)) continue;
      if (!is_gathered) block_.gather(tile_, first_cell, count - 1, open_bits_.data());
      is_gathered = true;
      ++completed_;
      if (complete(v)) {
        block_.remove(v);
        continue;
      }
      give_up(v);
      ++failures_;
    }
  }

  /// Finds the tetrahedra at v, and appends those found to found_. Returns false if some cannot be found.
  bool complete(Local v) {
    start_at(v);
    const std::uint32_t before = count_;
    const bool is_complete = find_star();
    const Place own = tile_.place(v);
    for (std::uint32_t t = before; t < count_; ++t) {
      const std::array<Place, 4> row = row_of(t);
      const bool is_first = own < std::min({row[0], row[1], row[2]});
      if (is_complete && is_first) {
        number_[t] = static_cast<std::uint32_t>(found_->tetrahedra.size());
        found_->tetrahedra.push_back(row);
        found_->is_within.push_back(is_within_[t]);
      } else {
        number_[t] = none;
        found_->shared.push_back(row);
        found_->shared_is_within.push_back(is_within_[t]);
      }
    }
    if (!is_complete) return false;
    is_finished_[v] = 1;
    is_settled_[own - tile_.first_own()] = 1;
    open_bits_[v / 8] = static_cast<std::uint8_t>(open_bits_[v / 8] & ~(1U << v % 8));
    return true;
  }

  std::array<Place, 4> row_of(std::uint32_t t) const {
    const Corners& corner = corners_[t];
    return {tile_.place(corner[0]), tile_.place(corner[1]), tile_.place(corner[2]), tile_.place(corner[3])};
  }

  bool find_star() {
    OpenFaces::AtCorner open(open_, rank_[at_]);
    if (is_reached_[at_] == 0 && !add_first(open)) return false;
    while (!open.empty()) {
      const OpenFace face = open.pop();
      if (!find_apex(face.first, face.second)) [[unlikely]] {
        open.close_or_add(face, nobody);
        return false;
      }
      make_room();
      const std::uint32_t t = add(open, face.first, face.second);
      connect(4 * t + 2, face.face);
    }
    return true;
  }

  HWY_INLINE void make_room() {
    if (count_ + 1 < corners_.size()) [[likely]]
      return;
    corners_.resize(2 * count_ + 1024);
    across_.resize(4 * corners_.size());
    number_.resize(2 * count_ + 1024);
    is_within_.resize(2 * count_ + 1024);
  }

  /// Adds the tetrahedron (second, first, apex_, v), and links it except across from the apex. Returns its number.
  HWY_INLINE std::uint32_t add(OpenFaces::AtCorner& open, Local first, Local second) {
    const std::uint32_t t = count_++;
    const Local apex = apex_;
    const auto narrow = [](Local i) { return static_cast<std::uint16_t>(i); };
    corners_[t] = {narrow(second), narrow(first), narrow(apex), narrow(at_)};
    across_[4 * t + 3] = nobody;
    is_within_[t] = is_within(first, second) ? 1 : 0;
    is_reached_[apex] = 1;
    close_or_add(open, {first, apex, 4 * t});
    close_or_add(open, {apex, second, 4 * t + 1});
    // The face (second, apex, first) waits at its corner of least rank. The code does not branch on the corner.
    const std::uint32_t r0 = rank_[second], r1 = rank_[apex], r2 = rank_[first], rank = std::min({r0, r1, r2});
    const bool is_second = rank == r0, is_apex = rank == r1;
    if (rank == waits_for_nothing) return t;
    const OpenFace face = {is_second ? apex
                           : is_apex ? first
                                     : second,
                           is_second ? first
                           : is_apex ? second
                                     : apex,
                           4 * t + 3};
    connect(face.face, open_.close_or_add(rank, face, nobody));
    return t;
  }

  HWY_INLINE void close_or_add(OpenFaces::AtCorner& open, const OpenFace& face) {
    connect(face.face, open.close_or_add(face, nobody));
  }
  HWY_INLINE void connect(std::uint32_t face, std::uint32_t other) {
    across_[other] = face;
    across_[face] = other;
  }

  /// Gives up point v: the faces that wait at v move to another of their corners.
  void give_up(Local v) {
    const std::uint32_t at = rank_[v];
    rank_[v] = waits_for_nothing;
    OpenFaces::AtCorner open(open_, at);
    while (!open.empty()) {
      const auto [first, second, face] = open.pop();
      const std::uint32_t rank = std::min(rank_[first], rank_[second]);
      if (rank == waits_for_nothing) continue;
      open_.close_or_add(rank, rank == rank_[first] ? OpenFace{second, v, face} : OpenFace{v, first, face}, nobody);
    }
  }

  /// Adds a first tetrahedron at the current point, which has none yet. Returns false if none is found.
  bool add_first(OpenFaces::AtCorner& open);

  void link();

  const Leaves& leaves_;
  Stars* found_ = nullptr;

  OpenFaces open_;
  std::vector<std::uint32_t> rank_;
  std::vector<std::uint8_t> is_reached_, is_finished_;
  std::vector<std::uint8_t> is_settled_;  // for each point of the leaf: whether it is settled
  // Data of the tetrahedra found, which are numbered from 1:
  std::vector<Corners> corners_;
  std::vector<std::uint32_t> across_;  // for each face: its number as a face of the neighbor, or nobody
  std::uint32_t count_ = 1;
  std::vector<std::uint32_t> number_;  // number in Stars::tetrahedra, or none
  std::vector<std::uint8_t> is_within_;
  std::vector<Local> around_;

  std::size_t of_leaf_ = 0, completed_ = 0, failures_ = 0;
};

/// Tries triangles at the edge to the nearest point, the least circumradius first: a triangle whose least ball is empty
/// belongs to the triangulation. Returns false if no ball of six triangles is proven to be empty.
bool StarSearch::add_first(OpenFaces::AtCorner& open) {
  around_.clear();
  // Finished points around v are used, too.
  for_each_row(inner(block_.ranges(), 1), [&](Local from, Local end) {
    for (Local i = from; i < end; ++i)
      if (i != at_) around_.push_back(i);
  });
  if (around_.size() < 3) return false;
  std::vector<Spoke> spokes;
  for (const Local i : around_) spokes.push_back(spoke(i));
  const auto nearest =
      static_cast<std::size_t>(std::min_element(spokes.begin(), spokes.end(),
                                                [](const Spoke& a, const Spoke& b) { return a.square < b.square; }) -
                               spokes.begin());
  const Spoke p = spokes[nearest];
  // For each triangle (v, p, q): its squared circumradius, up to a common factor, and the position of q in around_.
  std::vector<std::pair<double, std::size_t>> triangles;
  for (std::size_t k = 0; k < spokes.size(); ++k) {
    if (k == nearest) continue;
    const Spoke& q = spokes[k];
    const double x = q.x - p.x, y = q.y - p.y, z = q.z - p.z;
    const Vector3<double> n = {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
    triangles.emplace_back(q.square * (x * x + y * y + z * z) / dot(n, n), k);
  }
  std::sort(triangles.begin(), triangles.end());
  constexpr std::size_t tries = 6;
  for (std::size_t k = 0; k < std::min(tries, triangles.size()); ++k)
    for (const bool is_turned : {false, true}) {
      Local first = around_[nearest], second = around_[triangles[k].second];
      if (is_turned) std::swap(first, second);
      if (!find_apex(first, second)) continue;
      // The face may not belong to the triangulation, so the sphere is tested against all points on both sides.
      std::array<Tile::Range, 3> ranges;
      if (!tile_.ranges(box_of(sphere_), ranges)) continue;
      bool is_empty = true;
      for_each_row(ranges, [&](Local from, Local end) {
        for (Local i = from; i < end && is_empty; ++i) {
          if (i == first || i == second || i == apex_ || i == at_) continue;
          const Spoke s = spoke(i);
          const double value = value_of(sphere_, s), error = sphere_.constant + sphere_.slope * s.square;
          is_empty = value < -error ||
                     (value <= error &&
                      !beyond_filter_.is_inside(point(second), point(first), point(apex_), v_, point(i), value, error));
        }
      });
      if (!is_empty) continue;
      make_room();
      is_reached_[first] = is_reached_[second] = is_reached_[at_] = 1;
      const std::uint32_t t = add(open, first, second);
      close_or_add(open, {second, first, 4 * t + 2});
      return true;
    }
  return false;
}

/// Fills in Stars::neighbors, border and unsettled. Requires: number_ is set for all tetrahedra.
void StarSearch::link() {
  found_->neighbors.resize(found_->tetrahedra.size());
  number_[nobody / 4] = none;
  for (std::uint32_t t = 1; t < count_; ++t) {
    const std::uint32_t number = number_[t];
    if (number == none) continue;
    const auto across = [&](std::size_t k) { return number_[across_[4 * t + k] / 4]; };
    const std::array<std::uint32_t, 4> others = {across(0), across(1), across(2), across(3)};
    found_->neighbors[number] = others;
    if (std::max({others[0], others[1], others[2], others[3]}) != none) continue;
    for (std::size_t k = 0; k < 4; ++k)
      if (others[k] == none) found_->border.push_back(border_face(found_->tetrahedra[number], number, k));
  }
  for (Place i = 0; i < is_settled_.size(); ++i)
    if (is_settled_[i] == 0) found_->unsettled.push_back(tile_.first_own() + i);
}

std::unique_ptr<StarFinder> make_finder(const Leaves& leaves, const Spread& spread, double alpha) {
  return std::make_unique<StarSearch>(leaves, spread, alpha);
}

}  // namespace
}  // namespace rbpa::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rbpa::space {
namespace {
HWY_EXPORT(make_finder);
}  // namespace

std::unique_ptr<StarFinder> star_finder(const Leaves& leaves, const Spread& spread, double alpha) {
  return HWY_DYNAMIC_DISPATCH(make_finder)(leaves, spread, alpha);
}

}  // namespace rbpa::space
#endif
