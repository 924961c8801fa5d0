// What:   the levels of a front: which sites go on from one to the next, and at which one a face came.
// Law:    a transfer reads the sites that the one before carried, and those added or reopened since: no others.
// Source: Restricted BPA, section 6; it is an operation on the mesh alone.
#pragma once

#include <cstddef>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/patch/site_vertices.h"

namespace meshops {

/// What goes on from one level to the next.
struct LevelTransfer {
  std::vector<Site> carried;    ///< sites that are free or on the boundary, in ascending order
  std::size_t left_behind = 0;  ///< sites that have turned inner since the transfer before
  std::size_t reactivated = 0;  ///< frozen halfedges that are active again
};

namespace detail {

class MESHOPS_API Levels {
 public:
  /// The number of transfers so far.
  std::size_t count() const { return faces_before_.size(); }
  /// What count() was when a face came. Cost: its logarithm.
  std::size_t level(Face f) const;
  /// A site that had turned inner is on the boundary again, or free.
  void reopen(Site s) { reopened_.push_back(s); }
  /// Begins the next level. `on_boundary` has the sites there, in any order and some several times; of faces there are so many,
  /// dead ones included. Returns: the transfer, but for the halfedges.
  LevelTransfer begin_next(const SiteVertices& vertices, std::vector<Site> on_boundary, std::size_t faces);
  /// Frees the memory of what only transfers need.
  void clear_sites();

 private:
  std::vector<Site> carried_;              // by the last transfer
  std::size_t carried_before_ = 0;         // the number of sites then; later ones have been added since
  std::vector<Site> reopened_;             // since then
  std::vector<std::size_t> faces_before_;  // of each transfer, dead ones included
};

}  // namespace detail
}  // namespace meshops
