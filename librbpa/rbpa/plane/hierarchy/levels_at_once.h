// What:   builds the complex of the last radius in one pass, with faces in the order of their levels, and the counts of
//         a run from level to level.
// Law:    faces and levels are those of GrowthByTiles, which stops at every level.
// How:    patches are laid whole, as rbpa() lays them, and the thread that lays a triangle notes the triangle's level.
//         Then faces get new numbers. A site takes part on the levels of its triangles, and is closed after the last of
//         these levels if its fan is closed; an edge exists from the first level of its triangles on.
// Cost:   that of rbpa(), a comparison of the circumradius for each triangle, and a pass over faces and one over
//         halfedges; a few more unless all triangles are of the first level.
// Source: docs/explanation/plane.md, sections 16 and 17.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/fresh_vector.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/plane/grid/sites.h"
#include "rbpa/plane/hierarchy/ladder.h"
#include "rbpa/plane/levels.h"
#include "rbpa/plane/mesh/assembly.h"
#include "rbpa/plane/mesh/monitor.h"

namespace rbpa {

class LevelsAtOnce {
 public:
  /// Keeps references to all arguments.
  LevelsAtOnce(const Sites& sites, const Ladder& ladder, Threads& threads, Monitor& monitor)
      : sites_(sites), ladder_(ladder), threads_(threads), monitor_(monitor) {}

  /// Lays all triangles. Faces are in ascending order of their levels; faces of one level are in the order in which
  /// they were laid. Requires: called once; the mesh of `assembly` is empty. Throws: Cancelled.
  meshops::AssembledPatches lay(Assembly& assembly);

  /// Returns the first level, the last, and all others that add triangles; their seconds are 0. `alpha`, the radius of
  /// the whole run, becomes the radius of the last level. Requires: lay() was called.
  std::vector<Level> levels(double alpha) const;

 private:
  /// The numbers of items that a level adds.
  struct Growth {
    std::size_t triangles = 0, edges = 0;
    std::size_t sites = 0;   ///< sites with a triangle of the level
    std::size_t closed = 0;  ///< sites whose last triangle is of the level
  };
  static constexpr std::uint16_t none = Ladder::never;

  meshops::AssembledPatches lay(meshops::PatchAssembler assembler);
  /// Returns the new number of each face; `later` becomes the faces that are not of the first level, in their new
  /// order.
  meshops::FreshVector<std::uint32_t> new_numbers(std::size_t faces, std::vector<std::uint32_t>& later);
  void count_later(const meshops::AssembledPatches& assembled, std::span<const std::uint32_t> later);
  void renumber(std::span<const std::uint32_t> number, Mesh& mesh);
  void count_closed(const meshops::AssembledPatches& assembled);

  const Sites& sites_;
  const Ladder& ladder_;
  Threads& threads_;
  Monitor& monitor_;
  meshops::FreshVector<std::uint16_t> level_;  // for each face, in the order in which faces were laid, its level
  std::vector<std::uint16_t> seen_;            // for each site, the last counted level with a triangle there, or none
  std::vector<Growth> growth_;                 // for each level
};

}  // namespace rbpa
