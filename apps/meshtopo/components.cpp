#include "meshtopo/components.h"

#include <algorithm>

#include "io/interrupt.h"
#include "meshops/topology/repair.h"
#include "meshtopo/face_fans.h"
#include "rbpa/space/surface/surface_components.h"

namespace rbpa::app {

KeptComponents kept_components(const MeshFile& mesh, const ComponentChoice& choice) {
  // The repair makes the faces of each component agree, and splits no component.
  const meshops::Repair repaired = meshops::repair(mesh.soup, until_interrupted());
  const FaceFans fans(repaired, mesh.positions);
  const SurfaceComponents components = surface_components(fans.points, fans.surface, until_interrupted());
  const std::vector<bool> kept = kept_components(components, {}, choice);
  KeptComponents result;
  result.faces.assign(mesh.soup.faces(), false);
  for (std::size_t t = 0; t < fans.face.size(); ++t)
    if (kept[components.number[t]]) result.faces[repaired.face_was[fans.face[t]]] = true;
  result.dropped = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), false));
  return result;
}

}  // namespace rbpa::app
