#include "rbpa/covering.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/steps.h"
#include "rbpa/plane/filtration/ascending.h"
#include "rbpa/plane/filtration/filtered_triangles.h"
#include "rbpa/plane/filtration/part_sizes.h"
#include "rbpa/plane/filtration/solid_parts.h"

namespace rbpa {

namespace {

std::optional<double> smallest(const Triangulation& delaunay, bool is_checked, const Filtration& filtration,
                               const Covering& covering, const std::function<bool()>& go_on) {
  require_same(filtration, delaunay, "smallest_covering");
  meshops::require(covering.share > 0 && covering.share <= 1, "smallest_covering: a share is above 0 and at most 1");
  if (covering.share == 1) return smallest_covering(filtration, covering.max_components);
  const std::size_t distinct = filtration.distinct;
  if (!covering.max_components) {
    const auto step = std::find_if(filtration.steps.begin(), filtration.steps.end(), [&](const FiltrationStep& s) {
      return is_share(s.covered, distinct, covering.share);
    });
    if (step == filtration.steps.end()) return std::nullopt;
    return step->alpha;
  }

  Steps pulse(go_on);
  const std::vector<double>& alpha = filtration.triangle_alpha;
  const std::vector<std::uint32_t> faces = ascending(filtration, pulse);
  const std::size_t points = delaunay.distinct + delaunay.duplicates.size();
  if (!is_checked) require_linked(delaunay, points, go_on);
  const OwnedTriangles triangles = in_order(delaunay, faces);
  SolidParts parts(triangles, points);
  // So many triangles, joined by edges, have at most two vertices more.
  PartSizes sizes(static_cast<std::uint32_t>(faces.size()) + 2);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    pulse();
    parts.add_next([&](std::uint32_t size) { sizes.remove(size); }, [&](std::uint32_t size) { sizes.add(size); });
    if (i + 1 < faces.size() && alpha[faces[i + 1]] == alpha[faces[i]]) continue;
    const std::size_t taken_away = sizes.sum() - sizes.largest(*covering.max_components);
    if (taken_away <= parts.covered() && is_share(parts.covered() - taken_away, distinct, covering.share))
      return alpha[faces[i]];
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> smallest_covering(const Delaunay& delaunay, const Filtration& filtration,
                                        const Covering& covering, const std::function<bool()>& go_on) {
  return smallest(delaunay.triangulation(), true, filtration, covering, go_on);
}

std::optional<double> smallest_covering(const Triangulation& delaunay, const Filtration& filtration,
                                        const Covering& covering, const std::function<bool()>& go_on) {
  return smallest(delaunay, false, filtration, covering, go_on);
}

}  // namespace rbpa
