#include "rbpa/plane/tile/extract_patch.h"

#include <array>
#include <span>

namespace rbpa {
namespace {

using meshops::Patch;
using meshops::Site;

/// The status of the star of a point. Bit 0: the tile has seen the star. Bit 1: the patch also has all triangles of the
/// star.
enum StarStatus : std::uint8_t { unseen = 0, shared = 1, settled = 3 };

constexpr int no_side = -1;

/// An entry of Patch::across in 16 bits: the number of a side, or a negative number that stands for no side.
using Across = std::uint16_t;
constexpr Across encoded(int across) { return static_cast<Across>(across - Patch::nothing); }
constexpr int decoded(Across across) { return across + Patch::nothing; }
constexpr int max_sides = 3 * (2 * static_cast<int>(Tile::max_points) + 2);
static_assert(decoded(encoded(max_sides)) == max_sides);

/// Returns room for at least `max_size` elements in `memory`, which never shrinks.
template <typename Element>
Element* room_for(std::vector<Element>& memory, std::size_t max_size) {
  if (memory.size() < max_size) memory.resize(max_size);
  return memory.data();
}

/// A list that is written without branches: its next entry is always written, and counted only if it belongs to the
/// list.
template <typename Element>
class CountedList {
 public:
  CountedList(std::vector<Element>& memory, std::size_t max_size) : first_(room_for(memory, max_size)) {}

  void add(Element element, bool is_one) {
    first_[size_] = element;
    size_ += is_one;
  }
  const Element* begin() const { return first_; }
  const Element* end() const { return first_ + size_; }

 private:
  Element* first_;
  std::size_t size_ = 0;
};

/// Returns a if `is_a`, otherwise b, without a branch.
template <typename Number>
Number either(Number a, Number b, bool is_a) {
  return static_cast<Number>(b ^ ((a ^ b) & (0 - std::size_t{is_a})));
}

class PatchExtraction {
 public:
  PatchExtraction(const Tile& tile, const LocalFront& front, ExtractionWorkspace& workspace, TilePatch& result)
      : tile_(tile), front_(front), workspace_(workspace), result_(result) {}

  /// Extracts the patch:
  /// 1. mark the triangles that the tile owns;
  /// 2. filter by circumradius, and number the sides of the triangles that the patch keeps;
  /// 3. find the settled stars;
  /// 4. write the entry across each side, and list marginal triangles;
  /// 5. if wanted, order the outline;
  /// 6. list the surroundings of stars that are not settled, for the remainder.
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
  using Index = LocalFront::Index;
  using Corners = std::array<std::size_t, 3>;
  Corners corners(std::size_t t) const { return {front_.from(4 * t), front_.from(4 * t + 1), front_.from(4 * t + 2)}; }

  bool is_before(std::size_t p, std::size_t q) const {
    const Point &a = tile_.points[p], &b = tile_.points[q];
    return (a.x < b.x) | ((a.x == b.x) & (a.y < b.y));
  }

  /// Marks the triangles whose least corner the tile owns. The few that need a comparison of corners are processed
  /// separately, as branches among the others would be unpredictable.
  void find_owned() {
    const std::size_t triangles = front_.triangles();
    std::uint16_t* const owned = room_for(workspace_.owned, triangles);
    CountedList<Index> some(workspace_.others, triangles);
    const std::uint8_t* const is_owned = tile_.owned.data();
    for (std::size_t t = 1; t < triangles; ++t) {
      const auto [a, b, c] = corners(t);
      const int corners_owned = is_owned[a] + is_owned[b] + is_owned[c];
      owned[t] = corners_owned == 3;
      some.add(static_cast<Index>(t), (corners_owned == 1) | (corners_owned == 2));
    }
    for (const Index t : some) {
      const auto [a, b, c] = corners(t);
      const std::size_t lesser = either(a, b, is_before(a, b));
      owned[t] = is_owned[either(lesser, c, is_before(lesser, c))];
    }
  }

  /// Determines the triangles of the patch, and for each side the entry by which a neighbor's Patch::across names it.
  template <typename IsWithin>
  void number_sides(IsWithin is_within) {
    const std::size_t triangles = front_.triangles();
    Across* const number = room_for(workspace_.number, 4 * triangles);
    const std::uint16_t* const owned = workspace_.owned.data();
    CountedList<Index> kept(workspace_.kept, triangles), others(workspace_.others, triangles);
    result_.patch.triangles.resize(triangles);
    auto* const patch = result_.patch.triangles.data();
    const std::uint32_t* const site = tile_.site.data();
    std::size_t count = 0;
    number[LocalFront::none] = encoded(Patch::open);
    number[LocalFront::nothing] = encoded(Patch::nothing);
    for (std::size_t t = 1; t < triangles; ++t) {
      const Corners corner = corners(t);
      const bool is_small = is_within(t), is_kept = is_small & (owned[t] != 0);
      const Across apart = encoded(is_small ? Patch::open : Patch::nothing);
      patch[count] = {site[corner[0]], site[corner[1]], site[corner[2]]};
      kept.add(static_cast<Index>(t), is_kept);
      others.add(static_cast<Index>(t), !is_kept);
      const auto first = either(encoded(static_cast<int>(3 * count)), apart, is_kept);
      number[4 * t] = first;
      number[4 * t + 1] = static_cast<Across>(first + is_kept);
      number[4 * t + 2] = static_cast<Across>(first + 2 * is_kept);
      count += is_kept;
    }
    kept_ = {kept.begin(), kept.end()};
    others_ = {others.begin(), others.end()};
    result_.patch.triangles.resize(count);
  }

  /// Determines the settled stars, and the stars that the tile has seen but that have triangles of other tiles.
  void settle_stars() {
    const std::size_t points = tile_.points.size();
    workspace_.elsewhere.assign(points, 0);
    std::uint16_t* const elsewhere = workspace_.elsewhere.data();
    for (const Index t : others_)
      for (const std::size_t v : corners(t)) elsewhere[v] += workspace_.number[4 * t] == encoded(Patch::open);
    std::uint8_t* const star = room_for(workspace_.star, points);
    CountedList<std::uint32_t> settled(workspace_.settled, points);
    CountedList<TilePatch::SharedStar> shared(workspace_.shared, points);
    const std::uint32_t* const site = tile_.site.data();
    const std::uint8_t* const owned = tile_.owned.data();
    for (std::size_t v = 0; v < points; ++v) {
      const bool is_owned = owned[v] != 0, is_touched = front_.is_touched(v), is_on_front = front_.is_on_front(v);
      const bool is_seen = is_owned & is_touched & !is_on_front;
      const bool is_settled = is_seen & (elsewhere[v] == 0);
      settled.add(site[v], is_settled);
      shared.add({site[v], elsewhere[v]}, is_seen ^ is_settled);
      star[v] = static_cast<std::uint8_t>(is_seen * StarStatus::shared | is_settled * StarStatus::settled);
    }
    result_.settled.assign(settled.begin(), settled.end());
    result_.shared.assign(shared.begin(), shared.end());
  }

  /// Determines the entries across sides, and the marginal triangles: triangles of the patch with a side across which
  /// the patch has no triangle, or a corner whose star is not settled.
  void connect() {
    const std::size_t points = tile_.points.size();
    result_.patch.across.resize(kept_.size());
    workspace_.last.assign(points + 1, no_side);
    auto* const across = result_.patch.across.data();
    CountedList<Index> marginal(workspace_.marginal, kept_.size());
    int* const last = workspace_.last.data();
    const Across* const number = workspace_.number.data();
    const std::uint8_t* const star = workspace_.star.data();
    int side = 0;
    for (std::size_t k = 0; k < kept_.size(); ++k) {
      const std::size_t t = kept_[k];
      const Corners corner = corners(t);
      std::array<int, 3> beyond;
      for (std::size_t i = 0; i < 3; ++i, ++side) {
        beyond[i] = decoded(number[front_.across(4 * t + i)]);
        last[either<std::size_t>(corner[i] + 1, 0, side < beyond[i])] = side;
      }
      across[k] = beyond;
      const bool is_settled = (star[corner[0]] & star[corner[1]] & star[corner[2]]) == StarStatus::settled;
      const bool is_at_rim = (beyond[0] | beyond[1] | beyond[2]) < 0;
      marginal.add(static_cast<Index>(k), !is_settled | is_at_rim);
    }
    marginal_ = {marginal.begin(), marginal.end()};
  }

  void outline() {
    CountedList<int> outer(workspace_.outer, 3 * marginal_.size());
    for (const Index k : marginal_)
      for (std::size_t i = 0; i < 3; ++i) {
        const bool is_outer = result_.patch.across[k][i] < 0;
        outer.add(static_cast<int>(3 * k + i), is_outer);
        workspace_.last[either<std::size_t>(front_.from(4 * std::size_t{kept_[k]} + i) + 1, 0, is_outer)] = no_side;
      }
    find_holes({outer.begin(), outer.end()});
    CountedList<int> inside(workspace_.outer, workspace_.last.size());
    for (std::size_t v = 1; v < workspace_.last.size(); ++v)
      inside.add(workspace_.last[v], workspace_.last[v] != no_side);
    result_.outline.inside.assign(inside.begin(), inside.end());
  }

  /// Divides the sides across which the patch has no triangle into holes and rim, and finds the next hole of each hole.
  /// At most sites, a single outer side ends. If that side is a hole, it is the next hole of the hole that begins at
  /// the site.
  void find_holes(std::span<const int> outer) {
    constexpr int several = -2;
    meshops::Outline& outline = result_.outline;
    outline.rim.resize(outer.size() + 1);
    outline.holes.resize(outer.size() + 1);
    workspace_.ending.assign(tile_.points.size(), no_side);
    int* const ending = workspace_.ending.data();
    std::size_t open_sides = 0;
    for (std::size_t k = 0; k < outer.size(); ++k) {
      int& at_end = ending[front_.to(on_front(outer[k]))];
      at_end = at_end == no_side ? outer[k] : several;
      outline.rim[open_sides] = outline.holes[k - open_sides] = outer[k];
      open_sides += across(outer[k]) == Patch::open;
    }
    outline.rim.resize(open_sides);
    outline.holes.resize(outer.size() - open_sides);
    outline.next_hole.resize(outer.size() - open_sides);
    for (std::size_t k = 0; k < outline.holes.size(); ++k) {
      const int hole = outline.holes[k], only = ending[front_.from(on_front(hole))];
      if (only == several) [[unlikely]]
        outline.next_hole[k] = meshops::next_hole(result_.patch, hole);
      else
        outline.next_hole[k] = across(only) == Patch::nothing ? only : no_side;
    }
  }

  /// Returns the number that a side of the patch has on the tile's front.
  std::size_t on_front(int side) const {
    const auto s = static_cast<std::size_t>(side);
    return 4 * std::size_t{kept_[s / 3]} + s % 3;
  }
  int across(int side) const {
    const auto s = static_cast<std::size_t>(side);
    return result_.patch.across[s / 3][s % 3];
  }

  /// Lists the data for the remainder: the pairs of a site whose star is seen and a neighbor whose star is not settled,
  /// the corners that are ghosts, and the triangles without a settled corner.
  void list_unsettled() {
    const std::uint8_t* const star = workspace_.star.data();
    CountedList<TilePatch::Neighbors> neighbors(workspace_.unsettled_neighbors,
                                                3 * (marginal_.size() + others_.size()));
    CountedList<std::uint32_t> ghosts(workspace_.ghost_corners, 3 * marginal_.size());
    const auto list_neighbors = [&](const Corners& corner) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t p = corner[i], q = corner[(i + 1) % 3];
        neighbors.add({tile_.site[p], tile_.site[q]},
                      (star[p] != StarStatus::unseen) & (star[q] != StarStatus::settled));
      }
    };
    result_.loose_triangles.clear();
    for (const Index k : marginal_) {
      const Corners corner = corners(kept_[k]);
      list_neighbors(corner);
      for (const std::size_t p : corner) ghosts.add(tile_.site[p], tile_.owned[p] == 0);
      if (((star[corner[0]] | star[corner[1]] | star[corner[2]]) & ~StarStatus::shared) == 0)
        result_.loose_triangles.push_back(k);
    }
    for (const Index t : others_) list_neighbors(corners(t));
    result_.unsettled_neighbors.assign(neighbors.begin(), neighbors.end());
    result_.ghost_corners.assign(ghosts.begin(), ghosts.end());
  }

  const Tile& tile_;
  const LocalFront& front_;
  ExtractionWorkspace& workspace_;
  TilePatch& result_;
  // The numbers of triangles: those of the patch, the others, and the marginal ones of the patch.
  std::span<const Index> kept_, others_, marginal_;
};

}  // namespace

void extract_patch(const Tile& tile, const TileCoordinates& coordinates, const LocalFront& front, const Radius& alpha,
                   ExtractionWorkspace& workspace, TilePatch& result) {
  PatchExtraction(tile, front, workspace, result).run(coordinates, alpha);
}

}  // namespace rbpa
