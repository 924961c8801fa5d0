// What: sorts faces by radius, as a filtration orders them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "rbpa/base/run/steps.h"

namespace rbpa {

/// Returns the numbers of the faces, sorted by radius, then by number.
inline std::vector<std::uint32_t> ascending(std::span<const double> radii, Steps& step) {
  std::vector<std::pair<double, std::uint32_t>> sorted(radii.size());
  for (std::uint32_t face = 0; face < sorted.size(); ++face) sorted[face] = {radii[face], face};
  sort(sorted, step, [](const auto& a, const auto& b) { return a < b; });
  std::vector<std::uint32_t> faces(sorted.size());
  for (std::size_t i = 0; i < faces.size(); ++i) faces[i] = sorted[i].second;
  return faces;
}

}  // namespace rbpa
