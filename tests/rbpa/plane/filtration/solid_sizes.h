// What: the numbers of vertices of the solid components of a mesh, found by walking from vertex to vertex.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "meshops/core/connectivity.h"
#include "rbpa/rbpa.h"

namespace rbpa_test {

/// Returns the numbers, the largest first.
inline std::vector<std::size_t> solid_sizes(const rbpa::Mesh& mesh) {
  std::vector<std::size_t> sizes;
  std::vector<bool> seen(mesh.n_vertices());
  for (std::size_t first = 0; first < seen.size(); ++first) {
    if (seen[first]) continue;
    std::vector<std::size_t> waiting{first};
    seen[first] = true;
    for (std::size_t i = 0; i < waiting.size(); ++i)
      for (const auto v : mesh.vv_range(meshops::Vertex(static_cast<int>(waiting[i])))) {
        const auto at = static_cast<std::size_t>(v.idx());
        if (!seen[at]) waiting.push_back(at);
        seen[at] = true;
      }
    sizes.push_back(waiting.size());
  }
  std::sort(sizes.begin(), sizes.end(), std::greater());
  return sizes;
}

}  // namespace rbpa_test
