#include "rbpa/plane/boundary_curves.h"

#include "rbpa/base/arrays/boundary_walk.h"

namespace rbpa {

std::vector<std::vector<std::uint32_t>> boundary_curves(const TriangleArrays& of, const GoOn& go_on) {
  BoundaryWalk walk(of);
  std::vector<std::vector<std::uint32_t>> curves;
  for (std::uint32_t t = 0; t < of.triangles.size(); ++t) {
    if (t % 16384 == 0) stop_if_cancelled(go_on);
    for (std::size_t across = 0; across < 3; ++across)
      if (walk.is_new({t, across})) curves.push_back(walk.curve_from({t, across}));
  }
  return curves;
}

}  // namespace rbpa
