// What: all Delaunay triangles, of tiles and remainder, handed to the front level by level.
// Law:  after insert() of a level, every triangle within its radius is in the mesh, if those of the levels before were.
// How:  they are found once, without a radius. What is known across each edge goes with the triangles, so that one is
//       put beside its neighbours without a search.
// Cost: linear in the triangles, and in the levels.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "meshops/front/front.h"
#include "rbpa/hierarchy/apexes.h"
#include "rbpa/hierarchy/ladder.h"
#include "rbpa/search/point_grid.h"

namespace rbpa {

class LocalTriangles {
 public:
  /// Begins with no triangle. Keeps references.
  LocalTriangles(std::span<const Point> points, const Ladder<double>& ladder);

  /// Takes in some of the triangles, found without a radius.
  void add(const meshops::Patch& patch);
  /// Ends the adding: all triangles are there. Puts them in the order of their levels.
  void sort();

  /// One of the triangles that insert() of this level, the last, put into the mesh is at the site.
  bool has_triangle(meshops::Site s, int level) const { return seen_[static_cast<std::size_t>(s)] == level + 1; }

  /// The first level from `level` on that has a triangle; Ladder::never without.
  int next(int level) const;

  /// Puts the triangles of a level into the mesh. Their boundary halfedges are frozen, and the apexes beyond remembered.
  /// Calls inserted() now and then.
  /// Returns: at how many sites there is a triangle of the level.
  template <typename Inserted>
  std::size_t insert(int level, meshops::Front& front, Apexes<double>& apexes, Inserted inserted) {
    std::size_t sites = 0;
    const std::uint32_t first = first_of_level(level), last = first_of_level(level + 1);
    if (front.faces() == 0) {
      for (std::uint32_t i = first; i < last; i += at_once) {
        sites += lay({order_.data() + i, std::min<std::size_t>(at_once, last - i)}, level, front);
        inserted();
      }
      front.join();
      remember_frozen(first, front, apexes);
      return sites;
    }
    for (std::uint32_t i = first; i < last; ++i) {
      if (i + ahead < last) prefetch(order_[i + ahead]);
      sites += insert(order_[i], level, front, apexes);
      if (i % at_once == 0) inserted();
    }
    return sites;
  }

 private:
  static constexpr int none = -1;
  static constexpr std::uint32_t at_once = 8192;  // triangles of a patch
  static constexpr std::uint32_t ahead = 12;

  int level_of(const std::array<meshops::Site, 3>& corners) const;
  meshops::Site from(int side) const {
    return corners_[static_cast<std::size_t>(side) / 3][static_cast<std::size_t>(side) % 3];
  }
  meshops::Site to(int side) const {
    return corners_[static_cast<std::size_t>(side) / 3][(static_cast<std::size_t>(side) + 1) % 3];
  }
  std::uint32_t first_of_level(int level) const;
  std::size_t count_sites(std::uint32_t triangle, int level);
  std::size_t lay(std::span<const std::uint32_t> triangles, int level, meshops::Front& front);
  std::uint32_t apex_beyond(int side) const;
  void remember(const meshops::Front& front, meshops::Halfedge h, int beyond, Apexes<double>& apexes) const;
  void remember_frozen(std::uint32_t first, meshops::Front& front, Apexes<double>& apexes) const;
  void prefetch(std::uint32_t triangle) const {
    __builtin_prefetch(&across_[triangle]);
    __builtin_prefetch(&corners_[triangle]);
    __builtin_prefetch(&face_[triangle]);
  }
  std::size_t insert(std::uint32_t triangle, int level, meshops::Front& front, Apexes<double>& apexes);

  std::span<const Point> points_;
  const Ladder<double>& ladder_;
  meshops::FreshVector<std::array<meshops::Site, 3>> corners_;
  meshops::FreshVector<std::array<int, 3>> across_;  // of each side, the side beyond it; none on the hull
  meshops::FreshVector<std::uint16_t> level_;
  meshops::Seams<int> seams_;                  // sides, each at the site that it leaves
  meshops::FreshVector<std::uint32_t> order_;  // triangles by level
  std::vector<std::uint32_t> start_;           // of each level the first of them
  meshops::FreshVector<meshops::Face> face_;   // of each triangle that is in the mesh
  meshops::Patch patch_;
  std::vector<std::uint16_t> seen_;  // of each site, one more than the last level that had a triangle there
};

}  // namespace rbpa
