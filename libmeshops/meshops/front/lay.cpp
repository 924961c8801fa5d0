// Patches: Front::place(), fill(), lay() and join().
#include <array>
#include <optional>

#include "meshops/core/contract.h"
#include "meshops/front/front.h"

namespace meshops {
namespace {

constexpr std::size_t edges_at_a_time = 16;  // at the rim
constexpr std::size_t ahead = 8;             // as many sides before, memory is asked for

std::size_t index(int side) { return static_cast<std::size_t>(side); }

int next_in_triangle(int side) { return side % 3 == 2 ? side - 2 : side + 1; }

/// Without a branch.
int either(int a, int b, bool is_a) { return b ^ ((a ^ b) & -static_cast<int>(is_a)); }

}  // namespace

void Front::reserve(std::size_t edges, std::size_t faces) {
  mesh_.reserve(mesh_.n_vertices(), edges + edges_at_a_time, faces);
}

void Front::place(const Patch& patch, const Outline& outline, Placement& placement) {
  const std::size_t triangles = patch.triangles.size(), sides = 3 * triangles, rim = outline.rim.size();
  require(patch.across.size() == triangles && rim <= sides && (sides - rim) % 2 == 0,
          "lay: the outline is of another patch");
  if (!rims_.has_begun()) {
    require(faces_ == 0, "lay: there are triangles that are not of a patch");
    require(added_.empty(), "lay: sites were added");
    rims_.begin(sites());
  }
  const std::size_t inner_edges = (sides - rim) / 2;
  const auto needed = [](std::size_t used, std::size_t more, std::size_t there) {
    return used + more > there ? used + more - there : 0;
  };
  supply(needed(edges_, inner_edges, mesh_.n_edges()), needed(faces_, triangles, mesh_.n_faces()));
  placement.first_face_ = static_cast<int>(faces_);
  placement.first_edge_ = static_cast<int>(edges_);
  placement.make_room(sides);
  faces_ += triangles;
  edges_ += inner_edges;

  const auto from = [&](int side) { return patch.triangles[index(side) / 3][index(side) % 3]; };
  for (std::size_t k = 0; k < rim; ++k) {
    if (k + ahead < rim) rims_.prepare(from(outline.rim[k + ahead]));
    const int side = outline.rim[k];
    const Site a = from(side), b = from(next_in_triangle(side));
    const int across = patch.across[index(side) / 3][index(side) % 3];
    std::optional<Rim> other;
    if (across != Patch::nothing) other = rims_.take(a, [b](const Rim& seam) { return seam.to == b; });
    Halfedge h;
    if (other) {
      h = other->boundary;
    } else {
      if (edges_ == mesh_.n_edges()) supply(edges_at_a_time, 0);
      h = Halfedge(static_cast<int>(2 * edges_++));
      const Halfedge beyond = mesh_.opposite_halfedge_handle(h);
      mesh_.set_vertex_handle(beyond, Vertex(a));
      const Rim opposite = {beyond, a, across != Patch::open};
      if (across == Patch::nothing)
        rims_.add_apart(opposite);
      else
        rims_.add(b, opposite);
    }
    mesh_.set_halfedge_handle(Vertex(a), h);
    placement.at(side) = h;
  }
}

void Front::fill(const Patch& patch, const Outline& outline, Placement& placement) {
  const std::size_t triangles = patch.triangles.size();
  int next = 2 * placement.first_edge_;
  int side = 0;
  for (std::size_t t = 0; t < triangles; ++t) {
    const auto corner = patch.triangles[t];
    const auto across = patch.across[t];
    const Face face(placement.first_face_ + static_cast<int>(t));
    std::array<Halfedge, 3> h;
    // A side tells the one across its halfedge. Only the first of two need do so, but which it is, is a toss of a coin.
    for (unsigned i = 0; i < 3; ++i, ++side) {
      const bool comes_first = side < across[i];
      h[i] = Halfedge(either(next, placement.at(side).idx(), comes_first));
      next += 2 * comes_first;
      placement.at(across[i]) = mesh_.opposite_halfedge_handle(h[i]);
    }
    for (unsigned i = 0; i < 3; ++i) {
      mesh_.set_face_handle(h[i], face);
      mesh_.set_vertex_handle(h[i], Vertex(corner[(i + 1) % 3]));
      mesh_.set_next_halfedge_handle(h[i], h[(i + 1) % 3]);
    }
    mesh_.set_halfedge_handle(face, h[0]);
  }
  for (const int out : outline.inside) {
    const std::size_t t = index(out) / 3, i = index(out) % 3;
    const Halfedge back = placement.at(patch.across[t][i]);
    mesh_.set_halfedge_handle(Vertex(patch.triangles[t][i]), mesh_.opposite_halfedge_handle(back));
  }
}

void Front::lay(const Patch& patch) {
  survey(patch, outline_);
  place(patch, outline_, placement_);
  fill(patch, outline_, placement_);
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
  outline_ = {};
  placement_ = {};
}

}  // namespace meshops
