// Patches: Front::lay() and Front::join().
#include "meshops/core/contract.h"
#include "meshops/front/front.h"

namespace meshops {

void Front::lay(const Patch& patch) {
  require(patch.across.size() == patch.triangles.size(), "lay: a patch tells what is across of each triangle");
  if (!rims_.has_begun()) {
    require(faces_ == 0, "lay: there are triangles that are not of a patch");
    require(added_.empty(), "lay: sites were added");
    rims_.begin(sites());
  }
  const std::size_t triangles = patch.triangles.size();
  const auto needed = [](std::size_t used, std::size_t more, std::size_t there) {
    return used + more > there ? used + more - there : 0;
  };
  std::size_t inner = 0;
  for (const auto& across : patch.across)
    for (const int s : across) inner += s >= 0;
  supply(needed(edges_, 3 * triangles - inner / 2, mesh_.n_edges()), needed(faces_, triangles, mesh_.n_faces()));

  side_of_patch_.resize(3 * triangles);
  for (std::size_t t = 0; t < triangles; ++t) {
    const auto& corner = patch.triangles[t];
    const Face face(static_cast<int>(faces_++));
    std::array<Halfedge, 3> side;
    for (unsigned i = 0; i < 3; ++i) {
      const std::size_t s = 3 * t + i;
      const Site from = corner[i], to = corner[(i + 1) % 3];
      const int across = patch.across[t][i];
      Halfedge& h = side[i];
      if (across >= 0 && static_cast<std::size_t>(across) < s)
        h = mesh_.opposite_halfedge_handle(side_of_patch_[static_cast<std::size_t>(across)]);
      else if (across < 0 && across != Patch::nothing)
        h = rims_.take(from, [&](const Rim& rim) { return mesh_.to_vertex_handle(rim.boundary).idx() == to; })
                .value_or(Rim{Halfedge(), false})
                .boundary;
      if (!h.is_valid()) {
        h = Halfedge(static_cast<int>(2 * edges_++));
        const Halfedge beyond = mesh_.opposite_halfedge_handle(h);
        mesh_.set_vertex_handle(h, Vertex(to));
        mesh_.set_vertex_handle(beyond, Vertex(from));
        if (across == Patch::nothing)
          rims_.add_apart({beyond, true});
        else if (across < 0)
          rims_.add(to, {beyond, across == Patch::frozen});
      }
      side_of_patch_[s] = h;
      mesh_.set_face_handle(h, face);
      mesh_.set_halfedge_handle(Vertex(from), h);
    }
    for (unsigned i = 0; i < 3; ++i) mesh_.set_next_halfedge_handle(side[i], side[(i + 1) % 3]);
    mesh_.set_halfedge_handle(face, side[0]);
  }
}

/// The boundary halfedge that follows one whose end has a single vertex yet, within the fan at its end.
Halfedge Front::next_on_boundary(Halfedge boundary) const {
  Halfedge out = mesh_.opposite_halfedge_handle(boundary);
  do out = mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(out));
  while (!mesh_.is_boundary(out));
  return out;
}

void Front::join() {
  rims_.for_each([&](const Rim& rim) {
    if (!mesh_.is_boundary(rim.boundary)) return;
    const Halfedge in = rim.boundary, out = next_on_boundary(in);
    mesh_.set_next_halfedge_handle(in, out);
    const Vertex v = mesh_.to_vertex_handle(in);
    if (!mesh_.is_boundary(mesh_.halfedge_handle(v))) {
      mesh_.set_halfedge_handle(v, out);
      return;
    }
    // The site has a fan already.
    const Vertex own = vertex_for_fan(v.idx());
    mesh_.set_halfedge_handle(own, out);
    mesh_.set_vertex_handle(in, own);
    for (Halfedge h = mesh_.opposite_halfedge_handle(in); h != out;) {
      const Halfedge before = mesh_.prev_halfedge_handle(h);
      mesh_.set_vertex_handle(before, own);
      h = mesh_.opposite_halfedge_handle(before);
    }
  });
  rims_.for_each([&](const Rim& rim) {
    if (!mesh_.is_boundary(rim.boundary)) return;
    if (rim.frozen)
      freeze(rim.boundary);
    else
      activate(rim.boundary);
  });
  mesh_.resize(mesh_.n_vertices(), edges_, faces_);  // what was made for seams that found their other side
  rims_.end();
  side_of_patch_ = {};
}

}  // namespace meshops
