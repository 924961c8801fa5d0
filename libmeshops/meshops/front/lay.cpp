// Patches: Placement, and Front::place(), fill(), lay() and join().
#include <algorithm>
#include <cstdint>

#include "meshops/core/contract.h"
#include "meshops/front/front.h"

namespace meshops {
namespace {

std::size_t slot(Site s) { return static_cast<std::size_t>(s) % 4096; }

}  // namespace

void Placement::survey(const Patch& patch) {
  require(patch.across.size() == patch.triangles.size(), "lay: a patch tells what is across of each triangle");
  rim_.clear();
  rim_sites_.clear();
  near_rim_.reset();
  for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
    const auto& across = patch.across[t];
    if ((across[0] | across[1] | across[2]) >= 0) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      if (across[i] >= 0) continue;
      const Site from = patch.triangles[t][i];
      rim_.push_back(static_cast<int>(3 * t + i));
      rim_sites_.push_back(from);
      near_rim_.set(slot(from));
    }
  }
  inner_edges_ = (3 * patch.triangles.size() - rim_.size()) / 2;
  // Where a side of the rim ends, another begins.
  std::sort(rim_sites_.begin(), rim_sites_.end());
}

inline bool Placement::is_at_rim(Site s) const {
  return near_rim_.test(slot(s)) && std::binary_search(rim_sites_.begin(), rim_sites_.end(), s);
}

void Front::place(const Patch& patch, Placement& placement) {
  if (!rims_.has_begun()) {
    require(faces_ == 0, "lay: there are triangles that are not of a patch");
    require(added_.empty(), "lay: sites were added");
    rims_.begin(sites());
  }
  const auto needed = [](std::size_t used, std::size_t more, std::size_t there) {
    return used + more > there ? used + more - there : 0;
  };
  const std::size_t triangles = patch.triangles.size(), rim = placement.rim_.size();
  supply(needed(edges_, placement.inner_edges_ + rim, mesh_.n_edges()), needed(faces_, triangles, mesh_.n_faces()));
  placement.first_face_ = static_cast<int>(faces_);
  placement.first_edge_ = static_cast<int>(edges_);
  faces_ += triangles;
  edges_ += placement.inner_edges_;

  placement.at_rim_.resize(rim);
  for (std::size_t k = 0; k < rim; ++k) {
    const auto s = static_cast<std::size_t>(placement.rim_[k]), t = s / 3, i = s % 3;
    const Site from = patch.triangles[t][i], to = patch.triangles[t][(i + 1) % 3];
    const int across = patch.across[t][i];
    Halfedge h;
    if (across != Patch::nothing)
      h = rims_.take(from, [&](const Rim& side) { return mesh_.to_vertex_handle(side.boundary).idx() == to; })
              .value_or(Rim{Halfedge(), false})
              .boundary;
    if (!h.is_valid()) {
      h = Halfedge(static_cast<int>(2 * edges_++));
      const Halfedge beyond = mesh_.opposite_halfedge_handle(h);
      mesh_.set_vertex_handle(h, Vertex(to));
      mesh_.set_vertex_handle(beyond, Vertex(from));
      if (across == Patch::nothing)
        rims_.add_apart({beyond, true});
      else
        rims_.add(to, {beyond, across == Patch::frozen});
    }
    mesh_.set_halfedge_handle(Vertex(from), h);
    placement.at_rim_[k] = h;
  }
}

void Front::fill(const Patch& patch, Placement& placement) {
  const std::size_t triangles = patch.triangles.size();
  int next_edge = placement.first_edge_;
  std::size_t next_rim = 0;
  placement.side_.resize(3 * triangles);
  for (std::size_t t = 0; t < triangles; ++t) {
    const auto& corner = patch.triangles[t];
    const Face face(placement.first_face_ + static_cast<int>(t));
    Halfedge* const side = &placement.side_[3 * t];
    for (unsigned i = 0; i < 3; ++i) {
      const int s = static_cast<int>(3 * t + i), across = patch.across[t][i];
      Halfedge& h = side[i];
      if (across < 0) {
        h = placement.at_rim_[next_rim++];
      } else if (across < s) {
        h = mesh_.opposite_halfedge_handle(placement.side_[static_cast<std::size_t>(across)]);
      } else {
        h = Halfedge(2 * next_edge++);
        mesh_.set_vertex_handle(h, Vertex(corner[(i + 1) % 3]));
        mesh_.set_vertex_handle(mesh_.opposite_halfedge_handle(h), Vertex(corner[i]));
        // The first triangle at a corner comes here: both its sides there are new.
        if (!placement.is_at_rim(corner[i])) mesh_.set_halfedge_handle(Vertex(corner[i]), h);
      }
      mesh_.set_face_handle(h, face);
    }
    for (unsigned i = 0; i < 3; ++i) mesh_.set_next_halfedge_handle(side[i], side[(i + 1) % 3]);
    mesh_.set_halfedge_handle(face, side[0]);
  }
}

void Front::lay(const Patch& patch) {
  placement_.survey(patch);
  place(patch, placement_);
  fill(patch, placement_);
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
  placement_ = {};
}

}  // namespace meshops
