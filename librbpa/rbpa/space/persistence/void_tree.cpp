#include "rbpa/space/persistence/void_tree.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/arrays/simplices_at.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/radii/sorted_by_alpha.h"
#include "rbpa/base/run/input.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/space/persistence/pairing/radius_rule.h"
#include "rbpa/space/persistence/pairing/values_of_faces.h"
#include "rbpa/space/persistence/pairing/void_pairs.h"
#include "rbpa/space/predicate/outer_faces.h"
#include "rbpa/space/predicate/vector3.h"
#include "rbpa/space/solid/boundary/check_triangulation.h"

namespace rbpa {
namespace {

/// Returns, for each triangle, the least radius of its tetrahedra.
std::vector<double> first_radii(std::span<const double> radii, const space::NumberedTriangles& triangles) {
  std::vector<double> first(triangles.corners.size(), std::numeric_limits<double>::infinity());
  for (std::size_t t = 0; t < radii.size(); ++t)
    for (const std::uint32_t triangle : triangles.of[t]) first[triangle] = std::min(first[triangle], radii[t]);
  return first;
}

/// Computes the volumes of voids in descending alpha. Each tetrahedron adds its volume to the void that contains its
/// basin (void_pairs.h). The volume of a void is the sum at the radius at which the void closes.
void find_volumes(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii, Steps& step,
                  VoidTree& tree) {
  std::vector<double> volumes(radii.size());
  for (std::size_t t = 0; t < volumes.size(); ++t) volumes[t] = space::volume<double>(points, delaunay.simplices[t]);
  auto order = sorted_by_alpha(radii, step);
  sort_equal_by_volume<double>(order, radii, volumes, step);
  meshops::DisjointSets sets(tree.nodes.size());
  std::vector<double> sum(tree.nodes.size(), 0);
  std::size_t left = order.size();
  for (std::size_t last = tree.nodes.size(), first; last > 0; last = first) {  // voids that close at one radius
    const double alpha = tree.nodes[last - 1].closes;
    for (; left > 0 && radii[order[left - 1]] > alpha; --left) {
      step();
      const std::uint32_t t = order[left - 1];
      if (tree.node_of[t] != VoidTree::none) sum[sets.find(tree.node_of[t])] += volumes[t];
    }
    for (first = last; first > 0 && tree.nodes[first - 1].closes == alpha; --first)
      tree.nodes[first - 1].volume = sum[sets.find(static_cast<std::uint32_t>(first - 1))];
    for (std::size_t i = first; i < last; ++i) {
      if (tree.nodes[i].parent == VoidTree::none) continue;
      const std::uint32_t set = sets.find(static_cast<std::uint32_t>(i)), other = sets.find(tree.nodes[i].parent);
      const double both = sum[set] + sum[other];
      sum[sets.link(set, other)] = both;
    }
  }
}

}  // namespace

VoidTree void_tree(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                   ComplexKind walls, unsigned wanted, const GoOn& go_on) {
  space::check_triangulation("void_tree", points, delaunay, radii);
  Steps step(go_on);
  Threads threads = threads_for(points.size(), wanted);
  const space::NumberedTriangles triangles = space::number_triangles(delaunay, step);
  const std::vector<double> wall =
      walls == ComplexKind::solid
          ? first_radii(radii, triangles)
          : space::values_of_triangles(space::RadiusRule(points), delaunay, radii, triangles, threads, go_on);
  space::PersistentVoids found = space::find_voids(delaunay, radii, triangles.of, wall, step);
  // A void that is filled at the radius at which it closes belongs to the void from which it separates.
  std::vector<std::uint32_t> part_of(radii.size());
  std::iota(part_of.begin(), part_of.end(), std::uint32_t{0});
  for (auto at = found.all.rbegin(); at != found.all.rend(); ++at)  // a void comes before voids that separate from it
    if (wall[at->triangle] == radii[at->tetrahedron])
      part_of[at->tetrahedron] = at->parted_from == VoidTree::none ? VoidTree::none : part_of[at->parted_from];
  std::erase_if(found.all, [&](const space::PersistentVoid& v) { return part_of[v.tetrahedron] != v.tetrahedron; });
  const auto is_before = [&](const space::PersistentVoid& a, const space::PersistentVoid& b) {
    const auto key = [&](const space::PersistentVoid& v) { return std::tuple(wall[v.triangle], v.triangle); };
    return key(a) < key(b);
  };
  sort(found.all, step, is_before);

  VoidTree tree;
  std::vector<std::uint32_t> node(radii.size(), VoidTree::none);  // for each tetrahedron that is the last of a void
  for (std::uint32_t i = 0; i < found.all.size(); ++i) node[found.all[i].tetrahedron] = i;
  const auto node_of = [&](std::uint32_t last) {
    return last == VoidTree::none || part_of[last] == VoidTree::none ? VoidTree::none : node[part_of[last]];
  };
  for (const space::PersistentVoid& v : found.all)
    tree.nodes.push_back({.closes = wall[v.triangle],
                          .filled = radii[v.tetrahedron],
                          .volume = 0,
                          .mouth = triangles.corners[v.triangle],
                          .last = v.tetrahedron,
                          .parent = node_of(v.parted_from)});
  tree.node_of.resize(node.size());
  for (std::size_t t = 0; t < node.size(); ++t) {
    std::uint32_t& of = tree.node_of[t] = node_of(found.basin[t]);
    // At radii below the closing radius of its void, a basin is part of the parent void.
    while (of != VoidTree::none && tree.nodes[of].closes >= radii[t]) of = tree.nodes[of].parent;
  }
  find_volumes(points, delaunay, radii, step, tree);
  return tree;
}

std::vector<std::uint32_t> nodes_of(const VoidTree& tree, const Solid& delaunay, std::span<const double> radii,
                                    double alpha, const Surface& boundary, std::span<const SolidVoid> voids) {
  meshops::require(
      radii.size() == delaunay.simplices.size() && radii.size() == tree.node_of.size(),
      "nodes_of: the tetrahedra, radii and tree.node_of differ in number, expected those that made the tree");
  // One triangle of each void, reversed: counter-clockwise seen from outside of the tetrahedron in the void.
  std::map<Triangle, std::size_t> void_at;
  std::vector<bool> is_least(corner_bound<4>(delaunay.simplices), false);  // lowest corners of keys
  for (std::size_t i = 0; i < voids.size(); ++i) {
    meshops::require(!voids[i].triangles.empty() && voids[i].triangles.front() < boundary.triangles.size(),
                     "nodes_of: a void has no triangle of the boundary, expected voids() with their boundary");
    const auto& [a, b, c] = boundary.triangles[voids[i].triangles.front()];
    const Triangle face = from_least({a, c, b});
    meshops::require(face[0] < is_least.size(), "nodes_of: a void has a corner that no tetrahedron has");
    void_at.emplace(face, i);
    is_least[face[0]] = true;
  }
  std::vector<std::uint32_t> nodes(voids.size(), VoidTree::none);
  for (std::uint32_t t = 0; t < radii.size(); ++t) {
    if (radii[t] <= alpha) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      const Triangle face = from_least(space::outer_face(delaunay.simplices[t], k));
      if (!is_least[face[0]]) continue;
      if (const auto found = void_at.find(face); found != void_at.end()) nodes[found->second] = tree.void_at(alpha, t);
    }
  }
  for (const std::uint32_t node : nodes)
    meshops::require(node != VoidTree::none,
                     "nodes_of: a void is not in the tree, expected the alpha and the walls of the voids");
  return nodes;
}

}  // namespace rbpa
