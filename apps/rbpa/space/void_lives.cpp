#include "space/void_lives.h"

#include <algorithm>

#include "io/interrupt.h"

namespace rbpa::app {
VoidLives::VoidLives(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                     ComplexKind walls, unsigned threads)
    : delaunay_(delaunay),
      radii_(radii),
      tree_(void_tree(points, delaunay, radii, walls, threads, until_interrupted())) {}

std::vector<VoidLife> VoidLives::of(double alpha, const Surface& boundary, std::span<const SolidVoid> voids) const {
  std::vector<VoidLife> lives;
  for (const std::uint32_t node : nodes_of(tree_, delaunay_, radii_, alpha, boundary, voids))
    lives.push_back(life(node));
  return lives;
}

std::vector<Pocket> VoidLives::pockets(double alpha) const {
  std::vector<Pocket> pockets;
  for (std::uint32_t n = 0; n < tree_.nodes.size(); ++n)
    if (tree_.nodes[n].closes > alpha) pockets.push_back({life(n), tree_.nodes[n].volume, tree_.nodes[n].mouth});
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
