#include "rbpa/void_tree.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <tuple>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/steps.h"
#include "rbpa/space/persistence/pairing.h"
#include "rbpa/space/persistence/sorted_by_alpha.h"
#include "rbpa/space/persistence/voids.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa {
namespace {

constexpr std::uint32_t none = VoidTree::none;

/// Of each triangle, the radius from which on it parts voids.
std::vector<double> radii_of_walls(const SolidFiltration& filtration, VoidWalls walls) {
  if (walls == VoidWalls::full) return filtration.triangle_alpha;
  std::vector<double> alpha(filtration.triangles.size(), std::numeric_limits<double>::infinity());
  for (std::size_t t = 0; t < filtration.triangles_of.size(); ++t)
    for (const std::uint32_t triangle : filtration.triangles_of[t])
      alpha[triangle] = std::min(alpha[triangle], filtration.tetrahedron_alpha[t]);
  return alpha;
}

/// Backwards in alpha, each tetrahedron adds its volume to what its basin is in by then, and each void that closes has what it has by then.
void find_volumes(std::span<const Point3> points, const SolidFiltration& filtration, Steps& step, VoidTree& tree) {
  const auto order = space::sorted_by_alpha(filtration.tetrahedron_alpha, step);
  meshops::DisjointSets sets(tree.nodes.size());
  std::vector<double> sum(tree.nodes.size(), 0);
  std::size_t left = order.size();
  for (std::size_t last = tree.nodes.size(), first; last > 0; last = first) {  // those that close at one radius
    const double alpha = tree.nodes[last - 1].closes;
    for (; left > 0 && filtration.tetrahedron_alpha[order[left - 1]] > alpha; --left) {
      step();
      const std::uint32_t t = order[left - 1];
      if (tree.node_of[t] != none)
        sum[sets.find(tree.node_of[t])] += space::volume<double>(points, filtration.delaunay.simplices[t]);
    }
    for (first = last; first > 0 && tree.nodes[first - 1].closes == alpha; --first)
      tree.nodes[first - 1].volume = sum[sets.find(static_cast<std::uint32_t>(first - 1))];
    for (std::size_t i = first; i < last; ++i) {
      if (tree.nodes[i].parent == none) continue;
      const std::uint32_t set = sets.find(static_cast<std::uint32_t>(i)), other = sets.find(tree.nodes[i].parent);
      const double both = sum[set] + sum[other];
      sum[sets.link(set, other)] = both;
    }
  }
}

}  // namespace

VoidTree void_tree(std::span<const Point3> points, const SolidFiltration& filtration, VoidWalls walls,
                   const std::function<bool()>& go_on) {
  space::check_filtration("void_tree", points, filtration);
  Steps step(go_on);
  const std::vector<double> wall = radii_of_walls(filtration, walls);
  space::PersistentVoids found = space::find_voids(filtration, wall, step);
  // What is filled as it closes is a part of what it is parted from.
  std::vector<std::uint32_t> part_of(filtration.triangles_of.size());
  std::iota(part_of.begin(), part_of.end(), std::uint32_t{0});
  for (auto at = found.all.rbegin(); at != found.all.rend(); ++at)  // that from which others are parted comes first
    if (wall[at->triangle] == filtration.tetrahedron_alpha[at->tetrahedron])
      part_of[at->tetrahedron] = at->parted_from == none ? none : part_of[at->parted_from];
  std::erase_if(found.all, [&](const space::PersistentVoid& v) { return part_of[v.tetrahedron] != v.tetrahedron; });
  const auto is_before = [&](const space::PersistentVoid& a, const space::PersistentVoid& b) {
    const auto key = [&](const space::PersistentVoid& v) { return std::tuple(wall[v.triangle], v.triangle); };
    return key(a) < key(b);
  };
  sort(found.all, step, is_before);

  VoidTree tree;
  std::vector<std::uint32_t> node(filtration.triangles_of.size(), none);  // of each tetrahedron that is the last of one
  for (std::uint32_t i = 0; i < found.all.size(); ++i) node[found.all[i].tetrahedron] = i;
  const auto node_of = [&](std::uint32_t last) {
    return last == none || part_of[last] == none ? none : node[part_of[last]];
  };
  for (const space::PersistentVoid& v : found.all)
    tree.nodes.push_back({.closes = wall[v.triangle],
                          .filled = filtration.tetrahedron_alpha[v.tetrahedron],
                          .volume = 0,
                          .mouth = v.triangle,
                          .last = v.tetrahedron,
                          .parent = node_of(v.parted_from)});
  tree.node_of.resize(node.size());
  for (std::size_t t = 0; t < node.size(); ++t) tree.node_of[t] = node_of(found.basin[t]);
  find_volumes(points, filtration, step, tree);
  return tree;
}

}  // namespace rbpa
