#include "rbpa/tile/extract_patch.h"

#include <array>
#include <cstdint>
#include <vector>

namespace rbpa {
namespace {

using meshops::Patch;
using meshops::Site;

/// Bit 0: the tile has seen the star of a point. Bit 1: moreover, all of it is in the patch.
enum StarStatus : std::uint8_t { unseen = 0, shared = 1, settled = 3 };

constexpr int none = -1;

/// A number of a Patch, of a side or of what lies across where none does, in 16 bits.
using Across = std::uint16_t;
constexpr Across packed(int across) { return static_cast<Across>(across - Patch::nothing); }
constexpr int unpacked(Across across) { return across + Patch::nothing; }
constexpr int max_sides = 3 * (2 * static_cast<int>(Tile::max_points) + 2);
static_assert(unpacked(packed(max_sides)) == max_sides);

/// Memory for lists of unknown length: never less than before.
template <typename Element>
Element* room_for(std::vector<Element>& list, std::size_t max_size) {
  if (list.size() < max_size) list.resize(max_size);
  return list.data();
}

/// Without a branch.
template <typename Number>
Number either(Number a, Number b, bool is_a) {
  return static_cast<Number>(b ^ ((a ^ b) & (0 - std::size_t{is_a})));
}

class PatchExtraction {
 public:
  PatchExtraction(const Tile& tile, const LocalFront& front, ExtractionWorkspace& workspace, TilePatch& result)
      : tile_(tile), front_(front), workspace_(workspace), result_(result) {}

  void run(const TileCoordinates& coordinates, const Radius& radius) {
    find_owned();
    if (radius.is_infinite()) {
      number_sides([](std::size_t) { return true; });
    } else {
      filter_circumradii(coordinates, front_, radius.value(), workspace_.within);
      number_sides([&, within = workspace_.within.data()](std::size_t t) {
        if (within[t] != CircumradiusFilter::uncertain) [[likely]]
          return within[t] == CircumradiusFilter::inside;
        const Corners c = corners(t);
        return radius.admits<double>(tile_.points[c[0]], tile_.points[c[1]], tile_.points[c[2]]);
      });
    }
    settle_stars();
    connect();
    if (result_.with_outline) outline();
    list_unsettled();
  }

 private:
  using Corners = std::array<std::size_t, 3>;
  Corners corners(std::size_t t) const { return {front_.from(4 * t), front_.from(4 * t + 1), front_.from(4 * t + 2)}; }

  bool is_before(std::size_t p, std::size_t q) const {
    const Point &a = tile_.points[p], &b = tile_.points[q];
    return (a.x < b.x) | ((a.x == b.x) & (a.y < b.y));
  }

  /// The tile owns triangles whose least corner is its own. Of few, the corners must be compared: these come by
  /// themselves, as none could be foreseen among the others.
  void find_owned() {
    const std::size_t triangles = front_.triangles();
    std::uint16_t* const owned = room_for(workspace_.owned, triangles);
    std::uint16_t* const some = room_for(workspace_.others, triangles);
    const std::uint8_t* const is_owned = tile_.owned.data();
    std::size_t count = 0;
    for (std::size_t t = 1; t < triangles; ++t) {
      const auto [a, b, c] = corners(t);
      const int corners_owned = is_owned[a] + is_owned[b] + is_owned[c];
      owned[t] = corners_owned == 3;
      some[count] = static_cast<std::uint16_t>(t);
      count += (corners_owned == 1) | (corners_owned == 2);
    }
    for (std::size_t k = 0; k < count; ++k) {
      const auto [a, b, c] = corners(some[k]);
      const std::size_t lesser = either(a, b, is_before(a, b));
      owned[some[k]] = is_owned[either(lesser, c, is_before(lesser, c))];
    }
  }

  /// Which triangles the patch keeps, and what is told of each side to the one across.
  template <typename IsWithin>
  void number_sides(IsWithin is_within) {
    const std::size_t triangles = front_.triangles();
    Across* const number = room_for(workspace_.number, 4 * triangles);
    const std::uint16_t* const owned = workspace_.owned.data();
    std::uint16_t* const kept = room_for(workspace_.kept, triangles);
    std::uint16_t* const others = room_for(workspace_.others, triangles);
    result_.patch.triangles.resize(triangles);
    auto* const patch = result_.patch.triangles.data();
    const std::uint32_t* const site = tile_.site.data();
    std::size_t count = 0, other = 0;
    number[LocalFront::none] = packed(Patch::open);
    number[LocalFront::nothing] = packed(Patch::nothing);
    for (std::size_t t = 1; t < triangles; ++t) {
      const Corners corner = corners(t);
      const bool small = is_within(t), is_kept = small & (owned[t] != 0);
      const Across apart = packed(small ? Patch::open : Patch::nothing);
      patch[count] = {site[corner[0]], site[corner[1]], site[corner[2]]};
      kept[count] = others[other] = static_cast<std::uint16_t>(t);
      const auto first = either(packed(static_cast<int>(3 * count)), apart, is_kept);
      number[4 * t] = first;
      number[4 * t + 1] = static_cast<Across>(first + is_kept);
      number[4 * t + 2] = static_cast<Across>(first + 2 * is_kept);
      count += is_kept;
      other += !is_kept;
    }
    kept_ = count;
    others_ = other;
    result_.patch.triangles.resize(kept_);
  }

  /// Which stars are settled, and which are for other tiles to settle.
  void settle_stars() {
    const std::size_t points = tile_.points.size();
    workspace_.elsewhere.assign(points, 0);
    std::uint16_t* const elsewhere = workspace_.elsewhere.data();
    for (std::size_t k = 0; k < others_; ++k) {
      const std::size_t t = workspace_.others[k];
      for (const std::size_t v : corners(t)) elsewhere[v] += workspace_.number[4 * t] == packed(Patch::open);
    }
    std::uint8_t* const star = room_for(workspace_.star, points);
    auto* const shared = room_for(workspace_.shared, points);
    result_.settled.resize(points);
    std::uint32_t* const done = result_.settled.data();
    const std::uint32_t* const site = tile_.site.data();
    const std::uint8_t* const owned = tile_.owned.data();
    std::size_t settled_count = 0, shared_count = 0;
    for (std::size_t v = 0; v < points; ++v) {
      const bool is_owned = owned[v] != 0, is_touched = front_.is_touched(v), is_on_front = front_.is_on_front(v);
      const bool is_seen = is_owned & is_touched & !is_on_front;
      const bool is_settled = is_seen & (elsewhere[v] == 0);
      done[settled_count] = site[v];
      settled_count += is_settled;
      shared[shared_count] = {site[v], elsewhere[v]};
      shared_count += is_seen ^ is_settled;
      star[v] = static_cast<std::uint8_t>(is_seen * StarStatus::shared +
                                          is_settled * (StarStatus::settled - StarStatus::shared));
    }
    result_.settled.resize(settled_count);
    result_.shared.assign(shared, shared + shared_count);
  }

  /// What lies across of sides; which triangles are marginal: something lies at their sides or corners that is not in the patch.
  void connect() {
    const std::size_t points = tile_.points.size();
    result_.patch.across.resize(kept_);
    workspace_.last.assign(points + 1, none);
    auto* const across = result_.patch.across.data();
    std::uint16_t* const marginal = room_for(workspace_.marginal, kept_);
    int* const last = workspace_.last.data();
    const std::uint16_t* const kept = workspace_.kept.data();
    const Across* const number = workspace_.number.data();
    const std::uint8_t* const star = workspace_.star.data();
    std::size_t count = 0;
    int side = 0;
    for (std::size_t k = 0; k < kept_; ++k) {
      const std::size_t t = kept[k];
      const Corners corner = corners(t);
      std::array<int, 3> beyond;
      for (std::size_t i = 0; i < 3; ++i, ++side) {
        beyond[i] = unpacked(number[front_.across(4 * t + i)]);
        last[either<std::size_t>(corner[i] + 1, 0, side < beyond[i])] = side;
      }
      across[k] = beyond;
      marginal[count] = static_cast<std::uint16_t>(k);
      const bool is_settled = (star[corner[0]] & star[corner[1]] & star[corner[2]]) == StarStatus::settled;
      const bool is_at_rim = (beyond[0] | beyond[1] | beyond[2]) < 0;
      count += !is_settled | is_at_rim;
    }
    marginal_ = count;
  }

  void outline() {
    int* const outer = room_for(workspace_.outer, 3 * marginal_);
    std::size_t count = 0, inside = 0;
    for (std::size_t m = 0; m < marginal_; ++m) {
      const std::size_t k = workspace_.marginal[m], t = workspace_.kept[k];
      for (std::size_t i = 0; i < 3; ++i) {
        const bool is_outer = result_.patch.across[k][i] < 0;
        outer[count] = static_cast<int>(3 * k + i);
        count += is_outer;
        workspace_.last[either<std::size_t>(front_.from(4 * t + i) + 1, 0, is_outer)] = none;
      }
    }
    find_holes(outer, count);
    const int* const last = workspace_.last.data();
    result_.outline.inside.resize(workspace_.last.size());
    for (std::size_t v = 1; v < workspace_.last.size(); ++v) {
      result_.outline.inside[inside] = last[v];
      inside += last[v] != none;
    }
    result_.outline.inside.resize(inside);
  }

  /// Tells holes from other sides at which nothing of the patch lies. Most often a single one of them ends at a site, and
  /// if that is a hole, it is the next of the one that begins there.
  void find_holes(const int* outer, std::size_t count) {
    constexpr int several = -2;
    meshops::Outline& outline = result_.outline;
    outline.rim.resize(count + 1);
    outline.holes.resize(count + 1);
    workspace_.ending.assign(tile_.points.size(), none);
    int* const ending = workspace_.ending.data();
    std::size_t open_sides = 0;
    for (std::size_t k = 0; k < count; ++k) {
      int& at_end = ending[front_.to(on_front(outer[k]))];
      at_end = at_end == none ? outer[k] : several;
      outline.rim[open_sides] = outline.holes[k - open_sides] = outer[k];
      open_sides += across(outer[k]) == Patch::open;
    }
    outline.rim.resize(open_sides);
    outline.holes.resize(count - open_sides);
    outline.next_hole.resize(count - open_sides);
    for (std::size_t k = 0; k < outline.holes.size(); ++k) {
      const int hole = outline.holes[k], only = ending[front_.from(on_front(hole))];
      if (only == several) [[unlikely]]
        outline.next_hole[k] = meshops::next_hole(result_.patch, hole);
      else
        outline.next_hole[k] = across(only) == Patch::nothing ? only : none;
    }
  }

  /// A side of the patch as one of the tile's front.
  std::size_t on_front(int side) const {
    const auto s = static_cast<std::size_t>(side);
    return 4 * std::size_t{workspace_.kept[s / 3]} + s % 3;
  }
  int across(int side) const {
    const auto s = static_cast<std::size_t>(side);
    return result_.patch.across[s / 3][s % 3];
  }

  /// What is around stars that are not settled: for the remainder.
  void list_unsettled() {
    const std::uint8_t* const star = workspace_.star.data();
    auto* const neighbors = room_for(workspace_.unsettled_neighbors, 3 * (marginal_ + others_));
    auto* const ghost_corners = room_for(workspace_.ghost_corners, 3 * marginal_);
    std::size_t pairs = 0, ghosts = 0;
    const auto list_neighbors = [&](const Corners& corner) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t p = corner[i], q = corner[(i + 1) % 3];
        neighbors[pairs] = {tile_.site[p], tile_.site[q]};
        pairs += (star[p] != StarStatus::unseen) & (star[q] != StarStatus::settled);
      }
    };
    result_.loose_triangles.clear();
    for (std::size_t m = 0; m < marginal_; ++m) {
      const std::size_t k = workspace_.marginal[m];
      const Corners corner = corners(workspace_.kept[k]);
      list_neighbors(corner);
      for (const std::size_t p : corner) {
        ghost_corners[ghosts] = tile_.site[p];
        ghosts += tile_.owned[p] == 0;
      }
      if (((star[corner[0]] | star[corner[1]] | star[corner[2]]) & ~StarStatus::shared) == 0)
        result_.loose_triangles.push_back(static_cast<std::uint32_t>(k));
    }
    for (std::size_t k = 0; k < others_; ++k) list_neighbors(corners(workspace_.others[k]));
    result_.unsettled_neighbors.assign(neighbors, neighbors + pairs);
    result_.ghost_corners.assign(ghost_corners, ghost_corners + ghosts);
  }

  const Tile& tile_;
  const LocalFront& front_;
  ExtractionWorkspace& workspace_;
  TilePatch& result_;
  std::size_t kept_ = 0, others_ = 0, marginal_ = 0;
};

}  // namespace

void extract_patch(const Tile& tile, const TileCoordinates& coordinates, const LocalFront& front, const Radius& alpha,
                   ExtractionWorkspace& workspace, TilePatch& result) {
  PatchExtraction(tile, front, workspace, result).run(coordinates, alpha);
}

}  // namespace rbpa
