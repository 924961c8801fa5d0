#include "rbpa/hierarchy/level_patch.h"

#include <algorithm>

#include "rbpa/hierarchy/circumradius.h"

namespace rbpa {
namespace {

/// The first level whose radius admits the triangle.
template <typename Real, typename SomeLadder>
int first_level(const Point& a, const Point& b, const Point& c, const SomeLadder& ladder) {
  if (ladder.radius(0).template admits<Real>(a, b, c)) return 0;
  int level = std::clamp(ladder.first_reaching(circumradius<Real>(a, b, c)), 1, ladder.end());
  while (!ladder.is_last(level) && !ladder.radius(level).template admits<Real>(a, b, c)) ++level;
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

template <typename LevelOf>
void LevelPatch::part(const meshops::Patch& patch, LevelOf level_of) {
  later.clear();
  waiting.clear();
  for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
    const int level = level_of(patch.triangles[t]);
    if (level == 0) continue;
    later.push_back({patch.triangles[t], level});
    waiting.push_back(t);
  }
  if (waiting.empty()) return;
  first = patch;
  // From the last on, so that no triangle which waits is put in the place of another.
  for (auto t = waiting.rbegin(); t != waiting.rend(); ++t) take_out(first, *t);
}

void LevelPatch::part(const meshops::Patch& patch, std::span<const Point> points, const ScaledLadder& ladder) {
  part(patch, [&](const auto& t) { return first_level<double>(points[t[0]], points[t[1]], points[t[2]], ladder); });
}

void LevelPatch::part(const meshops::Patch& patch, const Sites& sites, const Ladder& ladder) {
  part(patch,
       [&](const auto& t) { return first_level<long double>(sites.at(t[0]), sites.at(t[1]), sites.at(t[2]), ladder); });
}

}  // namespace rbpa
