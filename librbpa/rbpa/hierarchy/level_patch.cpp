#include "rbpa/hierarchy/level_patch.h"

#include <algorithm>

#include "rbpa/hierarchy/circumradius.h"

namespace rbpa {
namespace {

/// The first level after the first whose radius admits the triangle.
int later_level(const Point& a, const Point& b, const Point& c, const Ladder<double>& ladder) {
  int level = std::clamp(ladder.first_reaching(circumradius<double>(a, b, c)), 1, ladder.end());
  while (!ladder.is_last(level) && !ladder.radius(level).admits<double>(a, b, c)) ++level;
  return level;
}

int& across(meshops::Patch& patch, int side) {
  return patch.across[static_cast<std::size_t>(side) / 3][static_cast<std::size_t>(side) % 3];
}

/// Takes a triangle out of a patch and puts the last one in its place. No other patch has a triangle where it was.
void take_out(meshops::Patch& patch, std::size_t triangle) {
  for (const int beyond : patch.across[triangle])
    if (beyond >= 0) across(patch, beyond) = meshops::Patch::nothing;
  patch.triangles[triangle] = patch.triangles.back();
  patch.across[triangle] = patch.across.back();
  patch.triangles.pop_back();
  patch.across.pop_back();
  if (triangle == patch.triangles.size()) return;
  int side = 3 * static_cast<int>(triangle);
  for (const int beyond : patch.across[triangle]) {
    if (beyond >= 0) across(patch, beyond) = side;
    ++side;
  }
}

}  // namespace

void LevelPatch::part(const meshops::Patch& patch, std::span<const Point> points, const Ladder<double>& ladder) {
  later.clear();
  waiting.clear();
  const Radius least = ladder.radius(0);
  for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
    const auto& corners = patch.triangles[t];
    const Point &a = points[corners[0]], &b = points[corners[1]], &c = points[corners[2]];
    if (least.admits<double>(a, b, c)) continue;
    later.push_back({corners, later_level(a, b, c, ladder)});
    waiting.push_back(t);
  }
  if (waiting.empty()) return;
  first = patch;
  // From the last on, so that no triangle which waits is put in the place of another.
  for (auto t = waiting.rbegin(); t != waiting.rend(); ++t) take_out(first, *t);
}

}  // namespace rbpa
