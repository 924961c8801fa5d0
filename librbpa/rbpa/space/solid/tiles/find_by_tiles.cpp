#include "rbpa/space/solid/tiles/find_by_tiles.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <utility>

#include "meshops/core/large_pages.h"
#include "rbpa/base/parallel/in_order.h"
#include "rbpa/space/solid/tiles/leaves.h"
#include "rbpa/space/solid/tiles/stars.h"
#include "rbpa/space/solid/tiles/unsettled.h"

namespace rbpa::space {
namespace {

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
