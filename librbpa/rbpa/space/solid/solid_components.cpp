#include "rbpa/space/solid/solid_components.h"

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/arrays/grouped.h"
#include "rbpa/base/triangle_arrays.h"
#include "rbpa/space/solid/boundary/connected.h"
#include "rbpa/space/solid/boundary/measures.h"

namespace rbpa {

SolidComponents solid_components(std::span<const Point3> points, const Solid& solid, const SolidBoundary& boundary,
                                 Connection through) {
  space::require_boundary(points.size(), solid, boundary);
  meshops::DisjointSets sets = space::connected_through_faces(solid);
  if (through == Connection::points) space::connect_through_points(points.size(), boundary, sets);

  SolidComponents result;
  const space::Grouped of_tetrahedra(solid.simplices.size(), solid.simplices.size(),
                                     [&](std::uint32_t t) { return sets.find(t); });
  const space::Grouped of_triangles(boundary.tetrahedra.size(), of_tetrahedra.size(),
                                    [&](std::uint32_t t) { return of_tetrahedra.number()[boundary.tetrahedra[t]]; });
  meshops::require(of_triangles.size() == of_tetrahedra.size(),
                   "solid_components: found a component without boundary triangles, expected solid_boundary(solid)");
  const space::Measures measure(points);
  std::vector<space::ClosedMeasures> measures;
  std::vector<std::uint32_t> component;  // for each element of `measures`, its component
  for (std::size_t c = 0; c < of_triangles.size(); ++c) {
    const auto triangles = of_triangles.items(c);
    measures.push_back(measure.of(boundary.surface.triangles, triangles));
    component.push_back(of_tetrahedra.number()[boundary.tetrahedra[triangles.front()]]);
  }
  std::vector<std::uint32_t> place(measures.size());
  for (const std::uint32_t c : space::by_volume(measures)) {
    place[component[c]] = static_cast<std::uint32_t>(result.all.size());
    const space::ClosedMeasures& of = measures[c];
    result.all.push_back(
        {of_tetrahedra.items(component[c]).size(), of_triangles.items(c).size(), of.volume, of.area, of.low, of.high});
  }
  result.number = of_tetrahedra.number();
  for (std::uint32_t& number : result.number) number = place[number];
  return result;
}

}  // namespace rbpa
