// What: faces in the order in which a filtration has them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "rbpa/base/steps.h"
#include "rbpa/filtration.h"

namespace rbpa {

/// By alpha; equal alphas come in any order.
inline std::vector<std::uint32_t> ascending(const Filtration& filtration, Steps& pulse) {
  const std::vector<double>& alpha = filtration.triangle_alpha;
  std::vector<std::uint32_t> faces(alpha.size());
  std::iota(faces.begin(), faces.end(), 0u);
  std::sort(faces.begin(), faces.end(), [&](std::uint32_t a, std::uint32_t b) {
    pulse();
    return alpha[a] < alpha[b];
  });
  return faces;
}

}  // namespace rbpa
