#include "rbpa/surface_mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>

#include "meshops/core/contract.h"
#include "meshops/patch/assembler.h"
#include "rbpa/base/error.h"
#include "rbpa/base/input.h"

namespace rbpa {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// The triangles as one patch, with a site for each corner: corner k of triangle t is 3t + k.
meshops::Patch patch_of(const Surface& surface) {
  meshops::Patch patch;
  const auto& triangles = surface.triangles;
  const std::size_t count = triangles.size();
  if (surface.neighbors.size() != count)
    throw meshops::ContractViolation("surface_mesh: neighbours of other triangles");
  patch.triangles.resize(count);
  patch.across.resize(count);
  for (std::size_t t = 0; t < count; ++t)
    for (std::size_t side = 0; side < 3; ++side) {
      patch.triangles[t][side] = static_cast<meshops::Site>(3 * t + side);
      // Side `side` is from that corner to the next, across from the third.
      const std::uint32_t other = surface.neighbors[t][(side + 2) % 3];
      int& across = patch.across[t][side];
      across = meshops::Patch::nothing;
      if (other == Surface::none) continue;
      for (std::size_t j = 0; j < 3 && other < count; ++j)
        if (surface.neighbors[other][(j + 2) % 3] == t && triangles[other][j] == triangles[t][(side + 1) % 3] &&
            triangles[other][(j + 1) % 3] == triangles[t][side])
          across = static_cast<int>(3 * other + j);
      if (across == meshops::Patch::nothing)
        throw meshops::ContractViolation("surface_mesh: triangle " + std::to_string(t) +
                                         " has a neighbour that does not know it");
    }
  return patch;
}

/// For each corner, the least corner of its fan.
std::vector<std::uint32_t> fans_of(const meshops::Patch& patch) {
  std::vector<std::uint32_t> least(3 * patch.triangles.size());
  std::iota(least.begin(), least.end(), std::uint32_t{0});
  const auto root = [&](std::uint32_t i) {
    while (least[i] != i) i = least[i] = least[least[i]];
    return i;
  };
  const auto join = [&](std::uint32_t i, std::uint32_t j) {
    i = root(i), j = root(j);
    least[std::max(i, j)] = std::min(i, j);
  };
  for (std::uint32_t side = 0; side < least.size(); ++side) {
    const int across = patch.across[side / 3][side % 3];
    if (across < 0) continue;
    const auto other = static_cast<std::uint32_t>(across);
    const auto end = [](std::uint32_t s) { return s - s % 3 + (s % 3 + 1) % 3; };  // the corner at which side s ends
    join(side, end(other));
    join(end(side), other);
  }
  for (std::uint32_t i = 0; i < least.size(); ++i) least[i] = root(i);
  return least;
}

}  // namespace

namespace {

/// Calls give_back() as soon as the surface is no longer needed.
template <typename GiveBack>
SurfaceMesh mesh_of(std::span<const Point3> points, const Surface& surface, GiveBack give_back) {
  if (surface.triangles.size() > max_points)
    throw InvalidInput(std::to_string(surface.triangles.size()) + " triangles, expected at most " +
                       std::to_string(max_points) + ", whose halfedges can be numbered in int");
  for (const Triangle& t : surface.triangles)
    for (const std::uint32_t i : t)
      if (i >= points.size())
        throw meshops::ContractViolation("surface_mesh: corner " + std::to_string(i) + " of " +
                                         std::to_string(points.size()) + " points");
  meshops::Patch patch = patch_of(surface);
  std::vector<std::uint32_t> fan = fans_of(patch);

  // Each fan is a site of its own for the assembler. Sites are sorted by point, fans of one point by their least corners.
  const auto point_of = [&](std::uint32_t corner) { return surface.triangles[corner / 3][corner % 3]; };
  std::vector<std::uint32_t> fans;
  for (std::uint32_t corner = 0; corner < fan.size(); ++corner)
    if (fan[corner] == corner) fans.push_back(corner);
  std::sort(fans.begin(), fans.end(), [&](std::uint32_t f, std::uint32_t g) {
    return point_of(f) != point_of(g) ? point_of(f) < point_of(g) : f < g;
  });
  // The least corner of a fan is numbered first; the others copy its number.
  const auto site_at = [&](std::uint32_t corner) -> meshops::Site& { return patch.triangles[corner / 3][corner % 3]; };
  for (std::size_t i = 0; i < fans.size(); ++i) site_at(fans[i]) = static_cast<meshops::Site>(i);
  for (std::uint32_t corner = 0; corner < fan.size(); ++corner) site_at(corner) = site_at(fan[corner]);
  fan = std::vector<std::uint32_t>();

  for (std::uint32_t& f : fans) f = point_of(f);
  give_back();

  SurfaceMesh result;
  meshops::PatchAssembler assembler(result.mesh, fans.size());
  assembler.lay(patch);
  result.input_index = std::move(assembler).join().finish();
  for (std::size_t v = 0; v < result.input_index.size(); ++v) {
    const std::uint32_t index = fans[result.input_index[v]];
    const Point3& p = points[index];
    result.mesh.set_point(Mesh::VertexHandle(static_cast<int>(v)), {p.x, p.y, p.z});
    result.input_index[v] = index;
  }
  return result;
}

}  // namespace

SurfaceMesh surface_mesh(std::span<const Point3> points, const Surface& surface) {
  return mesh_of(points, surface, [] {});
}

SurfaceMesh surface_mesh(std::span<const Point3> points, Surface&& surface) {
  return mesh_of(points, surface, [&] { surface = Surface(); });
}

}  // namespace rbpa
