#include "cli/void_lives.h"

#include <algorithm>
#include <map>
#include <utility>

#include "io/interrupt.h"

namespace rbpa::app {
namespace {

using Corners = std::array<std::uint32_t, 3>;

/// The least corner first, turned as it was.
Corners from_least(Corners corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// The face across from corner k of a positively oriented tetrahedron, counter-clockwise seen from outside.
Corners outward(const std::array<std::uint32_t, 4>& t, std::size_t k) {
  const Corners face = {t[(k + 1) % 4], t[(k + 2) % 4], t[(k + 3) % 4]};
  return from_least(k % 2 == 0 ? face : Corners{face[0], face[2], face[1]});
}

}  // namespace

VoidLives::VoidLives(std::span<const Point3> points, VoidWalls walls, unsigned threads,
                     const std::function<bool(const Progress&)>& progress)
    : filtration_(solid_filtration(points, {.threads = threads, .progress = progress})),
      tree_(void_tree(points, filtration_, walls, until_interrupted())) {}

std::vector<VoidLife> VoidLives::of(double alpha, const Surface& boundary, std::span<const SolidVoid> voids) const {
  // One face of each void, turned outwards from the tetrahedron in it: boundaries are seen from within voids.
  std::map<Corners, std::size_t> void_at;
  for (std::size_t i = 0; i < voids.size(); ++i) {
    const auto& [a, b, c] = boundary.triangles[voids[i].triangles.front()];
    void_at.emplace(from_least({a, c, b}), i);
  }
  std::vector<VoidLife> lives(voids.size());
  for (std::uint32_t t = 0; t < filtration_.tetrahedron_alpha.size(); ++t) {
    if (filtration_.tetrahedron_alpha[t] <= alpha) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto found = void_at.find(outward(filtration_.delaunay.simplices[t], k));
      if (found != void_at.end()) lives[found->second] = life(tree_.void_at(alpha, t));
    }
  }
  return lives;
}

std::vector<Pocket> VoidLives::pockets(double alpha) const {
  std::vector<Pocket> pockets;
  for (std::uint32_t n = 0; n < tree_.nodes.size(); ++n)
    if (tree_.nodes[n].closes > alpha)
      pockets.push_back({life(n), tree_.nodes[n].volume, filtration_.triangles[tree_.nodes[n].mouth]});
  std::stable_sort(pockets.begin(), pockets.end(),
                   [](const Pocket& a, const Pocket& b) { return a.volume > b.volume; });
  return pockets;
}

VoidLife VoidLives::life(std::uint32_t node) const {
  VoidLife life{tree_.nodes[node].closes, tree_.nodes[node].filled, 0};
  for (std::uint32_t n = tree_.nodes[node].parent; n != VoidTree::none; n = tree_.nodes[n].parent) ++life.depth;
  return life;
}

}  // namespace rbpa::app
