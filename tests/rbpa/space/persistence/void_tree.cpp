#include "rbpa/space/persistence/void_tree.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <tuple>
#include <vector>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/error.h"
#include "rbpa/space/balls/full_topology.h"
#include "rbpa/space/persistence/solid_persistence.h"
#include "rbpa/space/persistence/solid_representatives.h"
#include "rbpa/space/solid/solid_boundary.h"
#include "rbpa/space/solid/solid_radii.h"
#include "rbpa/space/solid/voids.h"
#include "support/for_solids.h"
#include "support/infinity.h"
#include "support/solid_sets.h"

using namespace rbpa_test;
using rbpa::ComplexKind;
using rbpa::Solid;
using rbpa::SolidFiltration;
using rbpa::SolidPair;
using rbpa::VoidTree;

TEST_SUITE_BEGIN("space");

namespace {

VoidTree tree_of(const Points3& points, const SolidFiltration& filtration, ComplexKind walls = ComplexKind::full) {
  return rbpa::void_tree(points, filtration.delaunay, filtration.tetrahedron_alpha, walls);
}

/// Returns the sets of tetrahedra left out at a radius, joined through triangles that are not walls; the outside is one
/// more element, the last.
meshops::DisjointSets open_parts(const SolidFiltration& filtration, ComplexKind walls, double alpha) {
  const auto outside = static_cast<std::uint32_t>(filtration.triangles_of.size());
  meshops::DisjointSets sets(outside + 1);
  for (std::uint32_t t = 0; t < outside; ++t) {
    if (filtration.tetrahedron_alpha[t] <= alpha) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t beyond = filtration.delaunay.neighbors[t][k];
      if (walls == ComplexKind::full && filtration.triangle_alpha[filtration.triangles_of[t][k]] <= alpha) continue;
      if (beyond == Solid::none)
        sets.join(t, outside);
      else if (filtration.tetrahedron_alpha[beyond] > alpha)
        sets.join(t, beyond);
    }
  }
  return sets;
}

}  // namespace

TEST_CASE("the open nodes at every radius are the voids, and each tetrahedron is in its own") {
  std::size_t checked = 0, voids = 0;
  for_solids(120, 2500, [&](const Points3& points) {
    const SolidFiltration filtration = rbpa::solid_filtration(points);
    for (const ComplexKind walls : {ComplexKind::solid, ComplexKind::full}) {
      const VoidTree tree = tree_of(points, filtration, walls);
      for (std::size_t t = 0; t < tree.node_of.size(); ++t)
        if (const std::uint32_t node = tree.node_of[t]; node != VoidTree::none) {
          CHECK(tree.nodes[node].closes < filtration.tetrahedron_alpha[t]);
          CHECK(filtration.tetrahedron_alpha[t] <= tree.nodes[node].filled);
        }
      std::vector<double> alphas;
      for (std::size_t i = 0; i < tree.nodes.size(); i += 1 + tree.nodes.size() / 12)
        for (const double alpha : {tree.nodes[i].closes, std::nextafter(tree.nodes[i].filled, 0.0),
                                   std::nextafter(tree.nodes[i].closes, 0.0)})
          alphas.push_back(alpha);
      for (const double alpha : alphas) {
        if (!(alpha > 0) || std::isinf(alpha)) continue;
        CAPTURE(alpha);
        meshops::DisjointSets parts = open_parts(filtration, walls, alpha);
        const auto outside = static_cast<std::uint32_t>(filtration.triangles_of.size());
        std::map<std::uint32_t, std::uint32_t> node_of_part;
        for (std::uint32_t t = 0; t < outside; ++t) {
          if (filtration.tetrahedron_alpha[t] <= alpha) continue;
          const std::uint32_t node = tree.void_at(alpha, t), part = parts.find(t);
          REQUIRE((node == VoidTree::none) == (part == parts.find(outside)));
          if (node == VoidTree::none) continue;
          CHECK(tree.nodes[node].closes <= alpha);
          CHECK(alpha < tree.nodes[node].filled);
          REQUIRE(node_of_part.emplace(part, node).first->second == node);
        }
        std::set<std::uint32_t> nodes;
        for (const auto& [part, node] : node_of_part) nodes.insert(node);
        CHECK(nodes.size() == node_of_part.size());
        const auto alive = std::count_if(tree.nodes.begin(), tree.nodes.end(), [&](const rbpa::VoidNode& node) {
          return node.closes <= alpha && alpha < node.filled;
        });
        CHECK(static_cast<std::size_t>(alive) == nodes.size());
        voids += nodes.size();
        ++checked;
      }
    }
  });
  CHECK(checked > 600);
  CHECK(voids > 3000);
}

TEST_CASE("closing, filling and volume are those of pairs and their representatives") {
  for_solids(120, 2500, [&](const Points3& points) {
    const SolidFiltration filtration = rbpa::solid_filtration(points);
    const VoidTree tree = tree_of(points, filtration);
    std::vector<SolidPair> pairs = rbpa::solid_persistence(filtration);
    std::erase_if(pairs, [](const SolidPair& pair) { return pair.dimension != 2; });
    const auto shapes = rbpa::solid_representatives(points, filtration, pairs);
    REQUIRE(tree.nodes.size() == pairs.size());
    std::map<std::uint32_t, std::size_t> of_last;
    for (std::size_t i = 0; i < pairs.size(); ++i) of_last[pairs[i].ended_by] = i;
    for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
      const rbpa::VoidNode& node = tree.nodes[n];
      REQUIRE(of_last.contains(node.last));
      const std::size_t i = of_last[node.last];
      CHECK(node.closes == pairs[i].birth);
      CHECK(node.filled == *pairs[i].death);
      CHECK(node.mouth == filtration.triangles[pairs[i].born_by]);
      if (std::isfinite(shapes[i].volume)) CHECK(node.volume == doctest::Approx(shapes[i].volume).epsilon(1e-9));
      if (node.parent != VoidTree::none) {
        CHECK(node.parent < n);
        CHECK(tree.nodes[node.parent].closes <= node.closes);
        CHECK(node.closes < tree.nodes[node.parent].filled);
        CHECK(node.filled <= tree.nodes[node.parent].filled);
      }
    }
  });
}

TEST_CASE("voids of the solid at the radius at which one closes have its volume") {
  std::size_t found = 0;
  for_solids(150, 2500, [&](const Points3& points) {
    const SolidFiltration filtration = rbpa::solid_filtration(points);
    const VoidTree tree = tree_of(points, filtration, ComplexKind::solid);
    for (std::size_t n = 0; n < tree.nodes.size(); n += 1 + tree.nodes.size() / 60) {
      const rbpa::VoidNode& node = tree.nodes[n];
      if (std::isinf(node.closes) || !(node.volume > 1e-250 && node.volume < 1e250)) continue;
      const Solid solid = rbpa::solid(points, node.closes);
      const rbpa::Voids voids = rbpa::voids(points, solid, rbpa::solid_boundary(solid));
      CHECK(std::any_of(voids.all.begin(), voids.all.end(), [&](const rbpa::SolidVoid& v) {
        return std::abs(v.volume - node.volume) <= 1e-7 * node.volume;
      }));
      ++found;
    }
  });
  CHECK(found > 60);
}

TEST_CASE("each void at a radius has its node, in a triangulation of any order") {
  std::size_t found = 0;
  for_solids(150, [&](const Points3& points) {
    const Solid delaunay = rbpa::solid(points, infinity, {.neighbors = true});
    if (delaunay.simplices.empty() || delaunay.simplices.size() > 2500) return;
    const std::vector<double> radii = rbpa::circumradii(points, delaunay.simplices);
    for (const ComplexKind walls : {ComplexKind::solid, ComplexKind::full}) {
      const VoidTree tree = rbpa::void_tree(points, delaunay, radii, walls);
      for (std::size_t n = 0; n < tree.nodes.size(); n += 1 + tree.nodes.size() / 8) {
        const double alpha = tree.nodes[n].closes;
        if (!(alpha > 0) || std::isinf(alpha)) continue;
        CAPTURE(alpha);
        const Solid solid = rbpa::within(delaunay, radii, alpha);
        const rbpa::SolidBoundary boundary = rbpa::solid_boundary(solid);
        rbpa::FullVoids voids{.boundary = boundary.surface, .all = {}};
        if (walls == ComplexKind::full)
          voids = rbpa::full_voids(points, rbpa::void_space(points, delaunay, radii, alpha), alpha);
        else
          voids.all = rbpa::voids(points, solid, boundary).all;
        std::vector<std::uint32_t> nodes = rbpa::nodes_of(tree, delaunay, radii, alpha, voids.boundary, voids.all);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
          REQUIRE(nodes[i] < tree.nodes.size());
          const rbpa::VoidNode& node = tree.nodes[nodes[i]];
          if (node.closes == alpha && node.volume > 1e-250 && node.volume < 1e250)
            CHECK(voids.all[i].volume == doctest::Approx(node.volume).epsilon(1e-7));
        }
        std::sort(nodes.begin(), nodes.end());
        CHECK(std::adjacent_find(nodes.begin(), nodes.end()) == nodes.end());
        CHECK(static_cast<std::ptrdiff_t>(nodes.size()) ==
              std::count_if(tree.nodes.begin(), tree.nodes.end(),
                            [&](const rbpa::VoidNode& node) { return node.closes <= alpha && alpha < node.filled; }));
        found += nodes.size();
      }
    }
  });
  CHECK(found > 1000);
  const Points3 points = uniform_cube(300, 5301);
  const Solid delaunay = rbpa::solid(points, infinity, {.neighbors = true});
  const std::vector<double> radii = rbpa::circumradii(points, delaunay.simplices);
  const VoidTree tree = rbpa::void_tree(points, delaunay, radii, ComplexKind::solid);
  const double alpha = tree.nodes.front().closes;
  const Solid solid = rbpa::within(delaunay, radii, alpha);
  const rbpa::SolidBoundary boundary = rbpa::solid_boundary(solid);
  const rbpa::Voids voids = rbpa::voids(points, solid, boundary);
  CHECK(voids.all.size() == 1);
  CHECK_THROWS_AS(rbpa::nodes_of(tree, delaunay, radii, 9, boundary.surface, voids.all), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::nodes_of(tree, delaunay, radii, alpha, {}, voids.all), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::nodes_of(tree, solid, radii, alpha, boundary.surface, voids.all), meshops::ContractViolation);
}

TEST_CASE("a tree of voids does not depend on the order of the points, to the last bit of its volumes") {
  Points3 points = uniform_cube(1200, 5302);
  std::vector<std::vector<std::tuple<double, double, double>>> found;
  for (int i = 0; i < 3; ++i) {
    const Solid delaunay = rbpa::solid(points, infinity, {.neighbors = true});
    const std::vector<double> radii = rbpa::circumradii(points, delaunay.simplices);
    found.emplace_back();
    for (const rbpa::VoidNode& node : rbpa::void_tree(points, delaunay, radii).nodes)
      found.back().emplace_back(node.closes, node.filled, node.volume);
    std::shuffle(points.begin(), points.end(), std::mt19937(static_cast<unsigned>(i)));
  }
  CHECK(found[0].size() > 500);
  CHECK(found[1] == found[0]);
  CHECK(found[2] == found[0]);
}

TEST_CASE("the inside of a bottle is a pocket, with its neck as the mouth, until the neck closes") {
  // A sphere of radius 1 with a hole of radius 0.4 around its top.
  Points3 bottle;
  for (int i = 0; i < 1500; ++i) {
    const double z = (2 * i + 1) / 1500.0 - 1, r = std::sqrt(1 - z * z);
    if (z < std::sqrt(1 - 0.16)) bottle.push_back({r * std::cos(2.399963 * i), r * std::sin(2.399963 * i), z});
  }
  const SolidFiltration filtration = rbpa::solid_filtration(bottle);
  const VoidTree tree = tree_of(bottle, filtration);
  const rbpa::VoidNode& inside =
      *std::max_element(tree.nodes.begin(), tree.nodes.end(),
                        [](const rbpa::VoidNode& a, const rbpa::VoidNode& b) { return a.volume < b.volume; });
  CHECK(inside.closes == doctest::Approx(0.4).epsilon(0.1));
  CHECK(inside.filled == doctest::Approx(1).epsilon(0.05));
  CHECK(inside.volume == doctest::Approx(4.1).epsilon(0.05));
  for (const std::uint32_t corner : inside.mouth) CHECK(bottle[corner].z > 0.8);
  CHECK(inside.parent == VoidTree::none);
}

TEST_CASE("points of another filtration are refused, and a run can be cancelled") {
  const Points3 points = uniform_cube(2000, 5300);
  const SolidFiltration filtration = rbpa::solid_filtration(points);
  CHECK_THROWS_AS(tree_of(Points3(points.begin(), points.end() - 1), filtration), meshops::ContractViolation);
  const auto& [delaunay, radii, triangles, triangle_alpha, edges, edge_alpha, triangles_of, edges_of, point_alpha] =
      filtration;
  const auto stop = [] { return false; };
  CHECK_THROWS_AS(rbpa::void_tree(points, delaunay, radii, ComplexKind::full, 1, stop), rbpa::Cancelled);
  Solid broken = delaunay;
  for (auto& row : broken.neighbors)
    for (std::uint32_t& n : row) n = n == 7 ? 8 : n;
  CHECK_THROWS_AS(rbpa::void_tree(points, broken, radii), meshops::ContractViolation);
  broken.neighbors.pop_back();
  CHECK_THROWS_AS(rbpa::void_tree(points, broken, radii), meshops::ContractViolation);
  const Points3 one = {{1, 2, 3}};
  CHECK(tree_of(one, rbpa::solid_filtration(one)).nodes.empty());
}

TEST_CASE("a neighbor that does not share its face is refused, wherever it is") {
  const Points3 points = uniform_cube(60, 5301);
  const Solid delaunay = rbpa::solid(points, infinity, {.neighbors = true});
  const std::vector<double> radii = rbpa::circumradii(points, delaunay.simplices);
  REQUIRE(rbpa::void_tree(points, delaunay, radii).node_of.size() == radii.size());
  std::size_t refused = 0, damaged = 0;
  for (std::size_t t = 0; t < radii.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k) {
      const auto refuses = [&](auto damage) {
        Solid broken = delaunay;
        damage(broken.neighbors[t]);
        if (broken.neighbors[t] == delaunay.neighbors[t]) return;  // nothing was damaged
        ++damaged;
        try {
          rbpa::void_tree(points, broken, radii);
        } catch (const meshops::ContractViolation&) {
          ++refused;
        }
      };
      refuses([&](auto& row) { row[k] = Solid::none; });
      refuses([&](auto& row) { row[k] = static_cast<std::uint32_t>(t); });
      refuses([&](auto& row) { row[k] = row[(k + 1) % 4]; });
      refuses([&](auto& row) { row[k] = static_cast<std::uint32_t>((t + 1) % radii.size()); });
      refuses([&](auto& row) { std::swap(row[k], row[(k + 1) % 4]); });
    }
  CHECK(refused == damaged);
}
