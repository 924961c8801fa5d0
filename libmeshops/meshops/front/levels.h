// What:   the result of Front::next_level(), the transfer that ends one level of a front and begins the next.
// Law:    a transfer reads only sites that the previous transfer carried, that were added or reopened since, or that
//         are on the boundary.
// Source: Restricted BPA, section 6; a transfer is an operation on the mesh alone.
#pragma once

#include <cstddef>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/patch/site_vertices.h"

namespace meshops {

/// Result of a transfer from one level to the next.
struct LevelTransfer {
  std::vector<Site> carried;    ///< free sites and sites on the boundary, ascending
  std::size_t left_behind = 0;  ///< number of sites that became inner since the previous transfer (or the start)
  std::size_t reactivated = 0;  ///< number of frozen halfedges that became active again
};

namespace detail {

class MESHOPS_API Levels {
 public:
  /// Returns the number of transfers.
  std::size_t count() const { return faces_before_.size(); }
  /// Returns the value of count() when the face was inserted. Cost: the logarithm of count().
  std::size_t level(Face f) const;
  /// Notes that a site that had become inner is on the boundary again, or free.
  void reopen(Site s) { reopened_.push_back(s); }
  /// Begins the next level. `on_boundary` has the sites on the boundary, in any order and with repetitions; `faces` is
  /// the number of faces, including deleted faces. Returns: the transfer, in which `reactivated` is still 0.
  LevelTransfer begin_next(const SiteVertices& vertices, std::vector<Site> on_boundary, std::size_t faces);
  /// Frees the memory that only further transfers would need.
  void clear_sites();

 private:
  std::vector<Site> carried_;              // sites that the previous transfer carried
  std::size_t carried_before_ = 0;         // number of sites at the previous transfer; later sites were added since
  std::vector<Site> reopened_;             // sites that were reopened since the previous transfer
  std::vector<std::size_t> faces_before_;  // for each transfer, the number of faces then, including deleted faces
};

}  // namespace detail
}  // namespace meshops
