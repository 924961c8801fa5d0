// Converts the mesh of a front to arrays in canonical order, like those of rbpa::surface().
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "meshops/front/front.h"
#include "rbpa/space/surface/surface.h"

/// Returns the mesh as an rbpa::Surface: triangles in canonical order, the neighbor opposite to each corner of a
/// triangle, and levels from 0.
/// Requires: `site` is the result of finish(), and next_level() was called before each radius.
inline rbpa::Surface arrays(const meshops::Front& front, const std::vector<meshops::Site>& site) {
  using meshops::Halfedge;
  const meshops::Connectivity& mesh = front.mesh();
  const auto site_at = [&](Halfedge h) { return site[static_cast<std::size_t>(mesh.to_vertex_handle(h).idx())]; };
  std::vector<std::pair<std::array<meshops::Site, 3>, Halfedge>>
      found;  // corners, and the halfedge to the first corner
  for (const meshops::Face f : mesh.faces()) {
    Halfedge h = mesh.halfedge_handle(f);
    while (site_at(h) > site_at(mesh.next_halfedge_handle(h)) || site_at(h) > site_at(mesh.prev_halfedge_handle(h)))
      h = mesh.next_halfedge_handle(h);
    const Halfedge next = mesh.next_halfedge_handle(h);
    found.push_back({{site_at(h), site_at(next), site_at(mesh.next_halfedge_handle(next))}, h});
  }
  std::ranges::sort(found, {}, [](const auto& one) { return one.first; });
  std::vector<std::uint32_t> number(found.size());
  for (std::uint32_t i = 0; i < found.size(); ++i)
    number[static_cast<std::size_t>(mesh.face_handle(found[i].second).idx())] = i;
  rbpa::Surface surface;
  for (const auto& [corners, first] : found) {
    surface.triangles.push_back(corners);
    surface.levels.push_back(static_cast<std::uint32_t>(front.level(mesh.face_handle(first)) - 1));
    auto& across = surface.neighbors.emplace_back();
    Halfedge h = mesh.prev_halfedge_handle(first);  // opposite to the first corner
    for (std::uint32_t& other : across) {
      const meshops::Face f = mesh.face_handle(mesh.opposite_halfedge_handle(h));
      other = f.is_valid() ? number[static_cast<std::size_t>(f.idx())] : rbpa::Surface::none;
      h = mesh.next_halfedge_handle(h);
    }
  }
  return surface;
}
