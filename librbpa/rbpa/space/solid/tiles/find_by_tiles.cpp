#include "rbpa/space/solid/tiles/find_by_tiles.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <utility>

#include "meshops/core/large_pages.h"
#include "rbpa/base/parallel/in_order.h"
#include "rbpa/space/solid/insertion/insertion.h"
#include "rbpa/space/solid/insertion/spatial_order.h"
#include "rbpa/space/solid/tiles/border_faces.h"
#include "rbpa/space/solid/tiles/leaves.h"
#include "rbpa/space/solid/tiles/stars.h"

namespace rbpa::space {
namespace {

/// The tetrahedra found, each once. Corners are places.
struct FoundRows {
  SolidRows rows;
  meshops::FreshVector<std::uint8_t> is_within;  ///< for each tetrahedron, whether its circumradius is at most alpha
  meshops::FreshVector<BorderFace> border;       ///< faces whose neighbor was unknown when they were found
};

/// The results of the tiles, appended one after the other.
class Collected {
 public:
  Collected(const Leaves& leaves, bool has_radii) : leaves_(leaves), has_radii_(has_radii) {
    const std::size_t expected = 7 * leaves.distinct();
    meshops::reserve_in_large_pages(found.rows.corners, expected);
    found.rows.neighbors.reserve(expected);
    found.border.reserve(leaves.distinct());
    shared_.reserve(leaves.distinct());
  }

  void append(const Stars& stars, std::size_t leaf) {
    const std::size_t base = found.rows.corners.size();
    check_number_of(base + stars.tetrahedra.size());
    auto& [corners, neighbors] = found.rows;
    corners.insert(corners.end(), stars.tetrahedra.begin(), stars.tetrahedra.end());
    neighbors.resize(corners.size());
    const auto first = static_cast<std::uint32_t>(base);
    const auto moved = [&](std::uint32_t t) { return t == Solid::none ? Solid::none : t + first; };
    for (std::size_t t = 0; t < stars.neighbors.size(); ++t) {
      const Row& row = stars.neighbors[t];
      neighbors[base + t] = {moved(row[0]), moved(row[1]), moved(row[2]), moved(row[3])};
    }
    for (const BorderFace& face : stars.border) found.border.push_back({face.corners, face.face + 4 * first});
    shared_.insert(shared_.end(), stars.shared.begin(), stars.shared.end());
    shared_end_.emplace_back(leaf, shared_.size());
    unsettled.insert(unsettled.end(), stars.unsettled.begin(), stars.unsettled.end());
    if (!has_radii_) return;
    found.is_within.insert(found.is_within.end(), stars.is_within.begin(), stars.is_within.end());
    shared_is_within_.insert(shared_is_within_.end(), stars.shared_is_within.begin(), stars.shared_is_within.end());
  }

  /// Appends the tetrahedra in Stars::shared that their leaf contributes. Requires: all leaves are appended.
  void append_shared() {
    std::vector<std::uint8_t> is_unsettled(leaves_.places(), 0);
    for (const Place i : unsettled) is_unsettled[i] = 1;
    std::size_t at = 0;
    for (const auto& [leaf, end] : shared_end_)
      for (; at < end; ++at) {
        const Row& row = shared_[at];
        if ((is_unsettled[row[0]] | is_unsettled[row[1]] | is_unsettled[row[2]] | is_unsettled[row[3]]) == 0) continue;
        Place first = Solid::none;
        for (const Place i : row)
          if (is_unsettled[i] == 0) first = std::min(first, i);
        if (first - leaves_[leaf].first >= leaves_[leaf].end - leaves_[leaf].first) continue;
        const std::size_t t = found.rows.corners.size();
        check_number_of(t + 1);
        found.rows.corners.push_back(row);
        found.rows.neighbors.push_back({Solid::none, Solid::none, Solid::none, Solid::none});
        if (has_radii_) found.is_within.push_back(shared_is_within_[at]);
        for (std::size_t k = 0; k < 4; ++k) found.border.push_back(border_face(row, static_cast<std::uint32_t>(t), k));
      }
    shared_ = {};
  }

  FoundRows found;
  std::vector<Place> unsettled;  ///< places that no tile has settled, ascending

 private:
  const Leaves& leaves_;
  bool has_radii_;
  meshops::FreshVector<Row> shared_;
  std::vector<std::uint8_t> shared_is_within_;
  std::vector<std::pair<std::size_t, std::size_t>> shared_end_;  // a leaf, and its end in shared_
};

/// Removes the tetrahedra whose circumradius is above alpha.
void leave_out(FoundRows& found) {
  auto& [corners, neighbors] = found.rows;
  meshops::FreshVector<std::uint32_t> number(corners.size());
  std::uint32_t count = 0;
  for (std::size_t t = 0; t < corners.size(); ++t) number[t] = found.is_within[t] != 0 ? count++ : Solid::none;
  for (std::size_t t = 0; t < corners.size(); ++t) {
    if (number[t] == Solid::none) continue;
    Row row = neighbors[t];
    for (std::uint32_t& neighbor : row) neighbor = neighbor == Solid::none ? Solid::none : number[neighbor];
    corners[number[t]] = corners[t];
    neighbors[number[t]] = row;
  }
  corners.resize(count);
  neighbors.resize(count);
}

constexpr std::uint32_t none = Solid::none;

/// Faces with a tetrahedron on one side only, in buckets by first corner. Corners are positions in `unsettled`.
class OpenSides {
 public:
  /// Collects the border faces that have no neighbor and only unsettled corners.
  OpenSides(const std::vector<Place>& unsettled, std::size_t places, const FoundRows& found)
      : end_(unsettled.size() + 1, 0) {
    std::vector<std::uint32_t> number(places, none);
    for (std::uint32_t i = 0; i < unsettled.size(); ++i) number[unsettled[i]] = i;
    std::vector<std::uint32_t> first;
    std::vector<Side> sides;
    for (const BorderFace& border : found.border) {
      const std::uint32_t t = border.face / 4, k = border.face % 4;
      if (found.rows.neighbors[t][k] != none) continue;
      const std::uint32_t a = number[border.corners[0]], b = number[border.corners[1]], c = number[border.corners[2]];
      if (a == none || b == none || c == none) continue;
      first.push_back(a);
      sides.push_back({b, c, border.face, is_ascending_outside(found.rows.corners[t], k)});
      ++end_[a + 1];
    }
    for (std::size_t i = 1; i < end_.size(); ++i) end_[i] += end_[i - 1];
    sides_.resize(sides.size());
    for (std::size_t i = 0; i < sides.size(); ++i)
      sides_[end_[first[i]]++] = sides[i];  // end_[i] moves from the beginning of bucket i to its end
  }

  bool empty() const { return sides_.empty(); }

  /// Returns the border face that equals the face across from corner k of the tetrahedron `corners`, if the known
  /// tetrahedron of the border face is on the other side; otherwise none.
  std::uint32_t face_of(const Row& corners, std::size_t k) const {
    const BorderFace face = border_face(corners, 0, k);
    const std::uint32_t first = face.corners[0];
    for (std::uint32_t i = first == 0 ? 0 : end_[first - 1]; i < end_[first]; ++i) {
      const Side& side = sides_[i];
      if (side.middle == face.corners[1] && side.greatest == face.corners[2] &&
          side.is_ascending != is_ascending_outside(corners, k))
        return side.face;
    }
    return none;
  }

 private:
  struct Side {
    std::uint32_t middle, greatest, face;
    bool is_ascending;  ///< is_ascending_outside() of the tetrahedron at the face
  };
  std::vector<Side> sides_;
  std::vector<std::uint32_t> end_;  // for each first corner, the end of its bucket in sides_
};

/// Appends the tetrahedra whose corners are all in `unsettled` to `found`, with neighbors: tiles have not found these.
/// Each is also in the Delaunay triangulation of the unsettled points. To exclude the other tetrahedra of this
/// triangulation, the search starts across the faces that have a known tetrahedron on one side only, continues to
/// neighbors, and never crosses a face of this kind. Requires: `unsettled` has all unsettled places, ascending; `found`
/// has all tetrahedra with a settled corner, linked; the points of `leaves` and `alpha` are scaled by `spread`. Throws
/// InvalidInput for too many tetrahedra.
void add_remainder(const Leaves& leaves, const Spread& spread, double alpha, const std::vector<Place>& unsettled,
                   FoundRows& found) {
  const OpenSides open(unsettled, leaves.places(), found);
  const bool are_all = found.rows.corners.empty();
  if (open.empty() && !are_all) return;
  std::vector<Point3> points;
  points.reserve(unsettled.size());
  for (const Place i : unsettled) points.push_back(leaves.point(i));
  Threads one(1);
  const SpatialOrder sorted = spatial_order(points, points, one, {});
  Insertion triangulation(points, points, spread, sorted, one);
  if (!triangulation.insert_all({})) return;

  const auto tetrahedra = triangulation.tetrahedra();
  const auto corners_of = [&](std::uint32_t t) {
    Row row;
    for (std::size_t k = 0; k < 4; ++k) row[k] = triangulation.index()[tetrahedra[t].corner[k]];
    return row;
  };
  // 1. Add the tetrahedra at open sides. Step 2 does not cross the faces at open sides.
  const Row nothing = {none, none, none, none};
  std::vector<Row> open_sides(tetrahedra.size(), nothing);
  std::vector<std::uint32_t> number(tetrahedra.size(), none), added;
  auto next = static_cast<std::uint32_t>(found.rows.corners.size());
  const auto add = [&](std::uint32_t t) {
    if (number[t] != none || tetrahedra[t].is_ghost()) return;
    number[t] = next++;
    added.push_back(t);
  };
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t) {
    if (triangulation.is_deleted(t) || tetrahedra[t].is_ghost()) continue;
    const Row corners = corners_of(t);
    if (are_all) add(t);
    for (std::size_t k = 0; k < 4; ++k)
      if ((open_sides[t][k] = open.face_of(corners, k)) != none) add(t);
  }
  // 2. Add neighbors of added tetrahedra until there are no more.
  for (std::size_t i = 0; i < added.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k)
      if (open_sides[added[i]][k] == none) add(tetrahedra[added[i]].neighbor[k] / 4);
  // 3. Append the added tetrahedra to `found`, with their neighbors.
  for (const std::uint32_t t : added) {
    Row row = corners_of(t), neighbors = nothing;
    for (std::size_t k = 0; k < 4; ++k) {
      row[k] = unsettled[row[k]];
      const std::uint32_t face = open_sides[t][k];
      neighbors[k] = face == none ? number[tetrahedra[t].neighbor[k] / 4] : face / 4;
      if (face != none) found.rows.neighbors[face / 4][face % 4] = number[t];
    }
    found.rows.corners.push_back(row);
    found.rows.neighbors.push_back(neighbors);
    found.is_within.push_back(std::isinf(alpha) || triangulation.is_within(t, alpha, alpha) ? 1 : 0);
  }
}

}  // namespace

bool find_by_tiles(std::span<const Point3> points, const Spread& spread, double alpha, Threads& threads,
                   const std::function<void(std::size_t, std::size_t)>& step, TiledSolid& solid,
                   const TileLimits& limits) {
  Leaves leaves(points, limits.points_in_leaf, threads);
  if (leaves.crowding() > limits.most_crowding) return false;
  Collected all(leaves, !std::isinf(alpha));
  struct Workspace {
    std::unique_ptr<StarFinder> finder;
    Stars stars;
  };
  std::atomic<bool> gave_up = false;
  std::size_t done = 0, exact = 0;
  in_order<Workspace>(
      threads, leaves.size(),
      [&](std::size_t i, Workspace& w) {
        if (gave_up) return;
        if (!w.finder) w.finder = star_finder(leaves, spread, alpha);
        w.finder->find(i, w.stars);
      },
      [&](std::size_t i, Workspace& w) {
        if (gave_up) return;
        all.append(w.stars, i);
        done += leaves[i].end - leaves[i].first;
        exact += w.stars.exact;
        const auto points_done = static_cast<double>(done);
        const double most = i + 1 < leaves.size() / 4 ? limits.most_unsettled_at_first : limits.most_unsettled;
        if (static_cast<double>(all.unsettled.size()) > most * points_done ||
            static_cast<double>(exact) > limits.most_exact * points_done)
          gave_up = true;
        if (step) step(done, leaves.distinct());
      },
      [](std::size_t, Workspace&) {});
  if (gave_up) return false;
  all.append_shared();
  auto& found = all.found;
  link_border_faces(found.border, leaves.places(), found.rows.neighbors);
  add_remainder(leaves, spread, alpha, all.unsettled, found);
  if (!std::isinf(alpha)) leave_out(found);
  solid = {std::move(found.rows), {}, leaves.duplicates(), leaves.distinct()};
  solid.index = leaves.release_index();
  return true;
}

}  // namespace rbpa::space
