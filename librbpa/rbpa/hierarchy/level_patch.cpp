#include "rbpa/hierarchy/level_patch.h"

#include <algorithm>

#include "rbpa/hierarchy/circumradius.h"

namespace rbpa {

int level_of(const Point& a, const Point& b, const Point& c, const Ladder<double>& ladder) {
  int level = std::min(ladder.first_reaching(circumradius<double>(a, b, c)), ladder.end());
  while (!ladder.is_last(level) && !ladder.radius(level).admits<double>(a, b, c)) ++level;
  return level;
}

void LevelPatch::part(const meshops::Patch& patch, std::span<const Point> points, const Ladder<double>& ladder) {
  first.clear();
  later.clear();
  number.resize(patch.triangles.size());
  const Radius least = ladder.radius(0);
  for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
    const auto& corners = patch.triangles[t];
    const Point &a = points[static_cast<std::size_t>(corners[0])], &b = points[static_cast<std::size_t>(corners[1])],
                &c = points[static_cast<std::size_t>(corners[2])];
    if (least.admits<double>(a, b, c)) {
      number[t] = 3 * static_cast<int>(first.triangles.size());
      first.triangles.push_back(corners);
    } else {
      // What lies beyond a side of it knows by this that no other patch has a triangle there.
      number[t] = meshops::Patch::nothing;
      later.push_back({corners, level_of(a, b, c, ladder)});
    }
  }
  for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
    if (number[t] < 0) continue;
    auto& across = first.across.emplace_back(patch.across[t]);
    for (int& side : across) {
      if (side < 0) continue;
      const int other = number[static_cast<std::size_t>(side) / 3];
      side = other < 0 ? other : other + side % 3;
    }
  }
}

}  // namespace rbpa
