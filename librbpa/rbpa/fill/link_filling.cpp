#include "rbpa/fill/link_filling.h"

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <utility>
#include <vector>

#include "meshops/topology/build_mesh.h"

namespace rbpa {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

struct GroupSide {
  std::uint32_t from, to;
  std::size_t group;
  friend auto operator<=>(const GroupSide&, const GroupSide&) = default;
};

/// Groups that are neighbours of no other: of each of two triangles that have the same edge on their left.
std::vector<std::size_t> overlapping(const Filling& filling) {
  if (filling.groups.empty()) return {};
  const auto [least, greatest] = std::minmax_element(filling.groups.begin(), filling.groups.end());
  if (*least == *greatest) return {};
  std::vector<GroupSide> sides;
  for (std::size_t t = 0; t < filling.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      sides.push_back({filling.triangles[t][k], filling.triangles[t][(k + 1) % 3], filling.groups[t]});
  std::sort(sides.begin(), sides.end());
  std::vector<std::size_t> groups;
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
    if (sides[i].from == sides[i + 1].from && sides[i].to == sides[i + 1].to) {
      groups.push_back(sides[i].group);
      groups.push_back(sides[i + 1].group);
    }
  std::sort(groups.begin(), groups.end());
  groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
  return groups;
}

/// The triangles on sites of which each is a point; a point has several where overlapping groups have it.
struct Sites {
  meshops::PolygonSoup soup;
  std::vector<std::uint32_t> point;
};

Sites sites_of(const Filling& filling) {
  Sites sites;
  for (std::uint32_t i = 0; i < filling.points.size(); ++i) sites.point.push_back(i);
  const std::vector<std::size_t> apart = overlapping(filling);
  const auto is_apart = [&](std::size_t t) {
    return std::binary_search(apart.begin(), apart.end(), filling.groups[t]);
  };
  // The points of groups that are apart; the first group with a point uses the point itself, if no other does.
  std::vector<std::pair<std::size_t, std::uint32_t>> owned;
  std::vector<bool> taken(filling.points.size(), false);
  for (std::size_t t = 0; t < filling.triangles.size(); ++t)
    for (const std::uint32_t i : filling.triangles[t]) {
      if (is_apart(t))
        owned.emplace_back(filling.groups[t], i);
      else
        taken[i] = true;
    }
  std::sort(owned.begin(), owned.end());
  owned.erase(std::unique(owned.begin(), owned.end()), owned.end());
  std::vector<std::uint32_t> site_of_owned;
  for (const auto& [group, i] : owned) {
    if (taken[i]) {
      site_of_owned.push_back(static_cast<std::uint32_t>(sites.point.size()));
      sites.point.push_back(i);
    } else {
      site_of_owned.push_back(i);
      taken[i] = true;
    }
  }
  sites.soup.points = sites.point.size();
  for (std::size_t t = 0; t < filling.triangles.size(); ++t) {
    Triangle corners = filling.triangles[t];
    if (is_apart(t))
      for (std::uint32_t& i : corners) {
        const auto own = std::lower_bound(owned.begin(), owned.end(), std::pair(filling.groups[t], i));
        i = site_of_owned[static_cast<std::size_t>(own - owned.begin())];
      }
    sites.soup.add_face(corners);
  }
  return sites;
}

}  // namespace

void link(Filling& filling) {
  const Sites sites = sites_of(filling);
  Mesh& mesh = filling.mesh;
  filling.point_of_vertex = meshops::build_mesh(mesh, sites.soup);
  for (std::uint32_t& point : filling.point_of_vertex) point = sites.point[point];
  for (std::size_t v = 0; v < filling.point_of_vertex.size(); ++v) {
    const Point& p = filling.points[filling.point_of_vertex[v]];
    mesh.set_point(meshops::Vertex(static_cast<int>(v)), {p.x, p.y, 0});
  }
  for (std::size_t t = 0; t < filling.triangles.size(); ++t) {
    const meshops::Halfedge first = mesh.halfedge_handle(meshops::Face(static_cast<int>(t)));
    const auto beyond = [&](meshops::Halfedge h) {
      const meshops::Face f = mesh.face_handle(mesh.opposite_halfedge_handle(h));
      return f.is_valid() ? static_cast<std::uint32_t>(f.idx()) : TriangleArrays::none;
    };
    filling.neighbors.push_back(
        {beyond(mesh.next_halfedge_handle(first)), beyond(mesh.prev_halfedge_handle(first)), beyond(first)});
  }
}

}  // namespace rbpa
