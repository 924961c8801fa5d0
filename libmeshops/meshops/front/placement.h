// What: where a patch goes in the mesh: what Front::place() decides and Front::fill() writes.
// Why:  only the rim of a patch has to do with other patches. What is left, nearly all, can be written by another thread
//       while the next patch is placed.
#pragma once

#include <bitset>
#include <cstddef>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/front/patch.h"

namespace meshops {

class MESHOPS_API Placement {
 public:
  /// What a patch is, apart from all others; replaces what was here. Reads nothing but the patch.
  /// Requires: `across` for each triangle. Throws ContractViolation. Cost: linear in the patch.
  void survey(const Patch& patch);

 private:
  friend class Front;

  bool is_at_rim(Site s) const;

  std::size_t inner_edges_ = 0;
  std::vector<int> rim_;         // the sides at which nothing of the patch lies, ascending
  std::vector<Site> rim_sites_;  // their ends, ascending
  std::bitset<4096> near_rim_;   // by the last digits of a site: most sites are told from those of the rim by it
  int first_face_ = 0, first_edge_ = 0;
  std::vector<Halfedge> at_rim_;  // of each side in rim_
  std::vector<Halfedge> side_;    // of each side, while it is written
};

}  // namespace meshops
