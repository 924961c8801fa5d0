#include "rbpa/plane/hierarchy/level_patch.h"

#include <cstddef>
#include <utility>

namespace rbpa {
namespace {

/// Returns the new number of the side `beyond`, or Patch::nothing if the triangle of that side waits; returns a
/// negative `beyond` unchanged. number[t] is the new number of the first side of triangle t.
int renumbered(int beyond, const std::vector<int>& number) {
  if (beyond < 0) return beyond;
  const int of_triangle = number[static_cast<std::size_t>(beyond) / 3];
  return of_triangle < 0 ? meshops::Patch::nothing : of_triangle + beyond % 3;
}

}  // namespace

void LevelPatch::split(const meshops::Patch& patch, const SiteLevels& levels) {
  first.clear();
  later.clear();
  number.resize(patch.triangles.size());
  int sides = 0;
  for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
    const int level = levels.of(patch.triangles[t]);
    number[t] = level == 0 ? std::exchange(sides, sides + 3) : meshops::Patch::nothing;
    if (level != 0) later.push_back({patch.triangles[t], level});
  }
  if (later.empty()) return;
  for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
    if (number[t] < 0) continue;
    const auto [a, b, c] = patch.across[t];
    first.triangles.push_back(patch.triangles[t]);
    first.across.push_back({renumbered(a, number), renumbered(b, number), renumbered(c, number)});
  }
}

}  // namespace rbpa
