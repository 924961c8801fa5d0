// What:   the complex of the last radius, laid at once, its faces in the order of their levels; and what a run from level to
//         level would count.
// Law:    faces and levels are those of GrowthByTiles, which stops at every level.
// How:    patches are laid whole, as rbpa() lays them, and the level of each triangle is noted in the thread that lays it. Then
//         faces get new numbers. A site takes part on the levels of its triangles and is done on the last of them if its
//         fan is closed; an edge is there from the first of the levels of its triangles on.
// Cost:   that of rbpa(), a comparison of the circumradius for each triangle, and, where not all are of the first level, two
//         passes over the mesh.
// Source: docs/hrbpa.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/hrbpa.h"
#include "rbpa/plane/grid/sites.h"
#include "rbpa/plane/hierarchy/ladder.h"
#include "rbpa/plane/mesh/assembly.h"
#include "rbpa/plane/mesh/monitor.h"

namespace rbpa {

class LevelsAtOnce {
 public:
  /// Keeps references.
  LevelsAtOnce(const Sites& sites, const Ladder& ladder, Threads& threads, Monitor& monitor)
      : sites_(sites), ladder_(ladder), threads_(threads), monitor_(monitor) {}

  /// Once. All triangles, their faces in the order of their levels.
  meshops::AssembledPatches lay(Assembly& assembly);

  /// After lay(): the levels, the last with the radius `alpha`; their seconds are 0.
  std::vector<Level> levels(double alpha) const;

 private:
  /// What a level adds.
  struct Growth {
    std::size_t triangles = 0, edges = 0;
    std::size_t sites = 0;   ///< with a triangle of the level
    std::size_t closed = 0;  ///< sites whose last triangle is of the level
  };
  static constexpr std::uint16_t none = Ladder::never;

  meshops::AssembledPatches lay(meshops::PatchAssembler assembler);
  /// The number that each face gets; `later` becomes the faces that are not of the first level, in their new order.
  meshops::FreshVector<std::uint32_t> new_numbers(std::size_t faces, std::vector<std::uint32_t>& later);
  void count_later(const meshops::AssembledPatches& assembled, std::span<const std::uint32_t> later);
  void renumber(std::span<const std::uint32_t> number, Mesh& mesh);
  void count_closed(const meshops::AssembledPatches& assembled);

  const Sites& sites_;
  const Ladder& ladder_;
  Threads& threads_;
  Monitor& monitor_;
  meshops::FreshVector<std::uint16_t> level_;  // of each face as it was laid
  std::vector<std::uint16_t> seen_;  // of each site, the last level so far on which it has a triangle, or none
  std::vector<Growth> growth_;       // of each level
};

}  // namespace rbpa
