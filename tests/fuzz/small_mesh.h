// What: small meshes made of bytes, and the topology that they must keep.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fuzz/target.h"
#include "meshops/core/live.h"
#include "meshops/core/validate.h"
#include "meshops/topology/build_mesh.h"
#include "meshops/topology/repair.h"
#include "meshops/topology/report.h"
#include "rbpa/base/point3.h"
#include "walk/choices.h"

namespace fuzz {

/// Fills an empty mesh with the repair of some triangles. Returns the place of each vertex, of small whole coordinates.
inline std::vector<rbpa::Point3> build(meshops::test::ByteChoices& choices, meshops::Connectivity& mesh) {
  meshops::PolygonSoup soup;
  soup.points = 3 + choices.below(14);
  std::vector<rbpa::Point3> points;
  for (std::size_t i = 0; i < soup.points; ++i)
    points.push_back({double(choices.below(4)), double(choices.below(4)), double(choices.below(3))});
  const auto corner = [&] { return choices.below(static_cast<unsigned>(soup.points)); };
  for (unsigned faces = choices.below(60); faces > 0 && choices.any_left(); --faces)
    soup.add_face(std::array<std::uint32_t, 3>{corner(), corner(), corner()});
  const meshops::Repair repaired = meshops::repair(soup);
  for (std::size_t f = 0; f < repaired.soup.faces(); ++f)
    if (repaired.soup.face(f).size() != 3) return {};  // a corner was dropped
  std::vector<rbpa::Point3> places;
  for (const std::uint32_t point : meshops::build_mesh(mesh, repaired.soup))
    places.push_back(points[repaired.stands_on[point]]);
  return places;
}

/// Ends the process unless the mesh is sound and has the topology that was before.
inline void check_same(const meshops::Connectivity& mesh, const meshops::TopologyReport& before) {
  require(meshops::validate(mesh).empty(), "the mesh stays sound");
  const meshops::TopologyReport now = meshops::report(mesh);
  require(now.betti == before.betti && now.genus == before.genus, "Betti numbers and genus stay");
  require(now.boundary_curves == before.boundary_curves, "every boundary curve stays one");
  require(now.components == before.components && now.solid_components == before.solid_components, "components stay");
}

}  // namespace fuzz
