#include "rbpa/fill/front/triangulate_outline.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>

#include "meshops/core/contract.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/constrained/insert_segments.h"

namespace rbpa {
namespace {

/// Returns the triangles on the left of `edges`, and all triangles that a walk from these reaches without crossing a
/// fixed side. `edges` are sorted.
std::vector<Triangle> left_of(std::span<const Segment> edges, const FixedTriangles& of, Steps& step) {
  std::vector<bool> seen(of.triangles.size(), false);
  std::vector<std::uint32_t> found;
  const auto visit = [&](std::uint32_t t) {
    if (seen[t]) return;
    seen[t] = true;
    found.push_back(t);
  };
  const auto is_fixed = [&](std::uint32_t t, std::uint32_t k) { return (of.fixed[t] >> k & 1) != 0; };
  for (std::uint32_t t = 0; t < of.triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (!is_fixed(t, k)) continue;
      step();
      const Segment edge{of.triangles[t][(k + 1) % 3], of.triangles[t][(k + 2) % 3]};
      if (std::binary_search(edges.begin(), edges.end(), edge)) visit(t);
    }
  std::vector<Triangle> result;
  for (std::size_t i = 0; i < found.size(); ++i) {
    step();
    result.push_back(of.triangles[found[i]]);
    for (std::uint32_t k = 0; k < 3; ++k)
      if (const std::uint32_t next = of.neighbors[found[i]][k]; !is_fixed(found[i], k) && next != no_index) visit(next);
  }
  return result;
}

}  // namespace

std::vector<Triangle> triangulate(const Outline& outline, const GoOn& go_on) {
  if (outline.rings.empty()) return {};
  Steps step(go_on);
  std::vector<Segment> edges;
  for (const OutlineRing& ring : outline.rings)
    for (std::size_t i = 0; i < ring.sites.size(); ++i)
      edges.push_back({ring.sites[i], ring.sites[(i + 1) % ring.sites.size()]});
  sort(edges, step, std::less<>());
  AlphaComplex whole =
      alpha_complex(outline.places, std::numeric_limits<double>::infinity(),
                    {.neighbors = true, .threads = 1, .progress = [&](const auto&) { return !go_on || go_on(); }});
  FixedTriangles triangles{std::move(whole.triangles), std::move(whole.neighbors), {}};
  triangles.fixed.assign(triangles.triangles.size(), 0);
  meshops::require(!insert_segments(outline.places, edges, triangles, step), "fill: found rings that cross");
  return left_of(edges, triangles, step);
}

}  // namespace rbpa
