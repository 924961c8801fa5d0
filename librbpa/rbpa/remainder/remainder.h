// What:   what is missing when all tiles have told what they can: found at once, from the points that matter for it.
// Law:    the triangles of the tiles and those of complete() are the solid alpha complex, each once.
// How:    a star is complete when every triangle of the complex around its site is told. What is missing has no
//         complete corner, and is in the Delaunay triangulation of those sites and their neighbours.
// Cost:   linear in what tiles tell beside their patches; O(r log r) for the r sites that are not done: at worst all.
// Source: docs/remainder.md.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "meshops/front/patch.h"
#include "rbpa/parallel/threads.h"
#include "rbpa/predicate/radius.h"
#include "rbpa/tile/triangulate.h"

namespace rbpa {

class Remainder {
 public:
  /// No tile has told anything. Keeps references.
  Remainder(std::span<const Point> points, const Radius& radius)
      : points_(points), radius_(radius), missing_(points.size(), unseen) {}

  /// Takes in what a tile tells, in any order.
  void add(const TileTriangles& tile);

  /// After all tiles: every triangle of the complex at the site is told.
  bool is_complete(std::uint32_t site) const { return missing_[site] == 0; }

  /// After all tiles: the sites that are not complete or beside one that is not, ascending.
  std::vector<std::uint32_t> not_done() const;

  /// After all tiles: the triangles of the complex that none has told, on the sites. Replaces `patch` and its outline. Calls working()
  /// now and then, in any thread and one at a time; it may throw to end it.
  void complete(meshops::Patch& patch, meshops::Outline& outline, Threads& threads,
                const std::function<void()>& working) const;

 private:
  using Corners = std::array<meshops::Site, 3>;
  static constexpr int unseen = 1 << 30;

  std::vector<Corners> told_among_incomplete() const;

  std::span<const Point> points_;
  const Radius& radius_;
  std::vector<int> missing_;  // of each site, how many triangles; `unseen` more while nobody has seen the whole star
  std::vector<std::array<std::uint32_t, 2>>
      beside_;                   // of sites whose stars are seen, neighbours that may be incomplete
  std::vector<Corners> unsure_;  // triangles that are told and may have no complete corner
};

}  // namespace rbpa
