#include "drawings/drawn_front.h"

#include <map>

#include "meshops/core/live.h"

namespace figures {

using meshops::Front;
using meshops::Site;

DrawnMesh drawn_front(const Front& front, const Mesh& mesh, const std::vector<Place>& places) {
  DrawnMesh drawn;
  drawn.mesh = mesh;
  meshops::for_each_vertex(mesh, [&](Vertex v) {
    const Site s = front.site(v);
    if (mesh.is_isolated(v) && !(front.is_free(s) && v == Vertex(static_cast<int>(s))))
      drawn.mesh.status(v).set_deleted(true);
    else
      drawn.move(v, places[s]);
  });
  std::map<Vertex, Place> apart;
  for (Site s = 0; s < front.sites(); ++s) {
    std::vector<Vertex> fans;
    front.for_each_fan(s, [&](Vertex v) { fans.push_back(v); });
    if (fans.size() < 2) continue;
    for (const Vertex v : fans) {
      Place towards;
      for (const Face f : mesh.vf_range(v)) towards = towards + direction(drawn.centroid(f) - drawn.place(v));
      apart[v] = drawn.place(v) + 0.1 * direction(towards);
    }
  }
  for (const auto& [v, place] : apart) drawn.move(v, place);
  return drawn;
}

}  // namespace figures
