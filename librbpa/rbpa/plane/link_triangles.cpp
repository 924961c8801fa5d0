#include "rbpa/plane/link_triangles.h"

#include <algorithm>
#include <tuple>

#include "rbpa/base/run/steps.h"
#include "rbpa/base/triangle_arrays.h"

namespace rbpa {
namespace {

/// A side of a triangle, listed at its end with the lower index, which is called the point.
struct SideAt {
  std::uint32_t other;  // the other end
  bool comes;           // whether the side runs to the point
  std::uint8_t across;  // the corner of the triangle across from the side
  std::uint32_t triangle;
};

}  // namespace

std::vector<Triangle> link_triangles(std::span<const Triangle> triangles, std::size_t points, const GoOn& go_on) {
  Steps step(go_on);
  // Sides are matched at their lower end. The lower end of two sides of a triangle is its lowest corner, corner 0;
  // triangles with the same corner 0 follow each other. The third side is across from corner 0: the triangles whose
  // third side has the same lower end form a linked list, from first[end] on, whose links stand in neighbors[t][0]
  // until the neighbor is written there.
  std::vector<Triangle> neighbors(triangles.size());
  std::vector<std::uint32_t> first(points, no_index);
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    step();
    std::uint32_t& head = first[std::min(triangles[t][1], triangles[t][2])];
    neighbors[t][0] = head;
    head = t;
  }
  std::vector<SideAt> sides;
  std::uint32_t t = 0;
  for (std::uint32_t p = 0; p < points; ++p) {
    step();
    sides.clear();
    for (; t < triangles.size() && triangles[t][0] == p; ++t) {
      sides.push_back({triangles[t][1], false, 2, t});
      sides.push_back({triangles[t][2], true, 1, t});
    }
    for (std::uint32_t at = first[p]; at != no_index; at = neighbors[at][0]) {
      const bool comes = triangles[at][2] == p;
      sides.push_back({triangles[at][comes ? 1 : 2], comes, 0, at});
    }
    step(sides.size());
    std::sort(sides.begin(), sides.end(),
              [](const SideAt& a, const SideAt& b) { return std::tie(a.other, a.comes) < std::tie(b.other, b.comes); });
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const bool are_two = i + 1 < sides.size() && sides[i].other == sides[i + 1].other;
      neighbors[sides[i].triangle][sides[i].across] = are_two ? sides[i + 1].triangle : no_index;
      if (!are_two) continue;
      neighbors[sides[i + 1].triangle][sides[i + 1].across] = sides[i].triangle;
      ++i;
    }
  }
  return neighbors;
}

}  // namespace rbpa
