#include "meshops/patch/assembler.h"

#include <algorithm>
#include <utility>

#include "meshops/core/contract.h"

namespace meshops {
namespace {

constexpr std::size_t edges_at_a_time = 16;  // number of edges by which the mesh grows at the rim
constexpr std::size_t ahead = 8;             // number of sides by which prefetching is ahead

std::size_t index(int side) { return static_cast<std::size_t>(side); }

int next_in_triangle(int side) { return side % 3 == 2 ? side - 2 : side + 1; }
int last_in_triangle(int side) { return side % 3 == 0 ? side + 2 : side - 1; }
Vertex vertex_of(Site s) { return Vertex(static_cast<int>(s)); }
Site from(const Patch& patch, int side) { return patch.triangles[index(side) / 3][index(side) % 3]; }

/// Returns `a` if `is_a` is true, otherwise `b`, without a branch.
int either(int a, int b, bool is_a) { return b ^ ((a ^ b) & -static_cast<int>(is_a)); }

}  // namespace

PatchAssembler::PatchAssembler(Connectivity& mesh, std::size_t sites) : mesh_(mesh), vertices_(mesh, sites) {
  require(mesh.n_vertices() == 0, "PatchAssembler: the mesh has ", static_cast<long long>(mesh.n_vertices()),
          " vertices, expected none");
  mesh.resize(sites, 0, 0);
  rims_.begin(sites);
  holes_.has_vertex.assign(sites, false);
}

void PatchAssembler::reserve(std::size_t edges, std::size_t faces) {
  mesh_.reserve(mesh_.n_vertices(), edges + edges_at_a_time, faces);
}

void PatchAssembler::place(const Patch& patch, const Outline& outline, Placement& placement) {
  const std::size_t triangles = patch.triangles.size(), sides = 3 * triangles, rim = outline.rim.size(),
                    holes = outline.holes.size();
  require(patch.across.size() == triangles && rim + holes <= sides && (sides - rim - holes) % 2 == 0 &&
              outline.next_hole.size() == holes,
          "place: the outline is of another patch (survey() computes that of this one)");
  const std::size_t inner_edges = (sides - rim - holes) / 2;
  mesh_.resize(mesh_.n_vertices(), std::max(mesh_.n_edges(), edges_ + inner_edges + holes),
               std::max(mesh_.n_faces(), faces_ + triangles));
  placement.first_face_ = static_cast<int>(faces_);
  placement.first_edge_ = static_cast<int>(edges_);
  placement.make_room(sides);
  faces_ += triangles;
  edges_ += inner_edges;
  place_holes(patch, outline, placement);

  for (std::size_t k = 0; k < rim; ++k) {
    if (k + ahead < rim) rims_.prepare(from(patch, outline.rim[k + ahead]));
    const int side = outline.rim[k];
    const Site a = from(patch, side), b = from(patch, next_in_triangle(side));
    Halfedge h;
    if (const auto other = rims_.take(a, [b](const Rim& seam) { return seam.to == b; })) {
      h = other->boundary;
    } else {
      if (edges_ == mesh_.n_edges()) mesh_.resize(mesh_.n_vertices(), edges_ + edges_at_a_time, mesh_.n_faces());
      h = Halfedge(static_cast<int>(2 * edges_++));
      const Halfedge beyond = mesh_.opposite_halfedge_handle(h);
      mesh_.set_vertex_handle(beyond, vertex_of(a));
      rims_.add(b, {beyond, a});
    }
    if (!holes_.has_vertex[a]) mesh_.set_halfedge_handle(vertex_of(a), h);
    placement.at(side) = h;
  }
}

/// Returns the handle of a further vertex on site `s`, at which the boundary halfedge `into` ends. join() makes it.
Vertex PatchAssembler::further_vertex(Site s, Halfedge into) {
  holes_.into.push_back(into);
  return vertices_.announce(s);
}

/// Gives numbers to the edges of holes, and vertices to the fans between them: the first fan on a site gets the vertex
/// of the site, each other fan a further vertex.
void PatchAssembler::place_holes(const Patch& patch, const Outline& outline, Placement& placement) {
  const std::size_t count = outline.holes.size();
  const auto first = static_cast<int>(edges_);
  placement.first_hole_ = first;
  placement.of_fan_.resize(count);
  if (count == 0) return;
  edges_ += count;
  holes_.edges.push_back({first, static_cast<int>(edges_)});
  for (std::size_t k = 0; k < count; ++k) {
    const Halfedge h(2 * (first + static_cast<int>(k)));
    const Site s = from(patch, outline.holes[k]);
    auto has_vertex = holes_.has_vertex[s];
    Vertex& v = placement.of_fan_[k];
    if (outline.next_hole[k] < 0) {
      v = Vertex();
      holes_.loose.push_back(mesh_.opposite_halfedge_handle(h));
      if (!has_vertex) mesh_.set_halfedge_handle(vertex_of(s), h);
    } else if (!has_vertex) {
      v = vertex_of(s);
      has_vertex = true;
    } else {
      v = further_vertex(s, mesh_.opposite_halfedge_handle(h));
    }
  }
}

void PatchAssembler::fill(const Patch& patch, const Outline& outline, Placement& placement) {
  const std::size_t triangles = patch.triangles.size();
  for (std::size_t k = 0; k < outline.holes.size(); ++k)
    placement.at(outline.holes[k]) = Halfedge(2 * (placement.first_hole_ + static_cast<int>(k)));
  int next = 2 * placement.first_edge_;
  int side = 0;
  for (std::size_t t = 0; t < triangles; ++t) {
    const auto corner = patch.triangles[t];
    const auto across = patch.across[t];
    const Face face(placement.first_face_ + static_cast<int>(t));
    std::array<Halfedge, 3> h;
    // Each side stores its halfedge for the side across. Only the first of the two sides needs to do this, but which
    // side is first cannot be predicted.
    for (unsigned i = 0; i < 3; ++i, ++side) {
      const bool comes_first = side < across[i];
      h[i] = Halfedge(either(next, placement.at(side).idx(), comes_first));
      next += 2 * comes_first;
      placement.at(across[i]) = mesh_.opposite_halfedge_handle(h[i]);
    }
    for (unsigned i = 0; i < 3; ++i) {
      mesh_.set_face_handle(h[i], face);
      mesh_.set_vertex_handle(h[i], vertex_of(corner[(i + 1) % 3]));
      mesh_.set_next_halfedge_handle(h[i], h[(i + 1) % 3]);
    }
    mesh_.set_halfedge_handle(face, h[0]);
  }
  for (const int out : outline.inside) {
    const std::size_t t = index(out) / 3, i = index(out) % 3;
    const Halfedge back = placement.at(patch.across[t][i]);
    mesh_.set_halfedge_handle(vertex_of(patch.triangles[t][i]), mesh_.opposite_halfedge_handle(back));
  }
  fill_holes(patch, outline, placement);
}

void PatchAssembler::fill_holes(const Patch& patch, const Outline& outline, Placement& placement) {
  for (std::size_t k = 0; k < outline.holes.size(); ++k) {
    const int hole = outline.holes[k], next = outline.next_hole[k];
    const Halfedge boundary = mesh_.opposite_halfedge_handle(placement.at(hole));
    const Vertex site = vertex_of(from(patch, hole)), v = placement.of_fan_[k];
    mesh_.set_vertex_handle(boundary, next < 0 ? site : v);
    if (next < 0) continue;
    const Halfedge out = mesh_.opposite_halfedge_handle(placement.at(next));
    mesh_.set_next_halfedge_handle(boundary, out);
    if (v == site) {
      mesh_.set_halfedge_handle(v, out);
      continue;
    }
    for (int side = hole; side >= 0;) {
      const int before = last_in_triangle(side);
      mesh_.set_vertex_handle(placement.at(before), v);
      side = patch.across[index(before) / 3][index(before) % 3];
    }
  }
}

void PatchAssembler::lay(const Patch& patch) {
  survey(patch, outline_);
  lay(patch, outline_);
}

void PatchAssembler::lay(const Patch& patch, const Outline& outline) {
  place(patch, outline, placement_);
  fill(patch, outline, placement_);
}

/// Returns the boundary halfedge that leaves the end of `boundary`, on the other side of the same fan. Requires: all
/// fans at this end still share one vertex.
Halfedge PatchAssembler::next_on_boundary(Halfedge boundary) const {
  Halfedge out = mesh_.opposite_halfedge_handle(boundary);
  do out = mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(out));
  while (!mesh_.is_boundary(out));
  return out;
}

/// Links the boundary around a fan, and gives the fan a vertex: that of the site if it is free, else a further vertex.
void PatchAssembler::close_fan(Halfedge boundary) {
  const Halfedge out = next_on_boundary(boundary);
  mesh_.set_next_halfedge_handle(boundary, out);
  const Vertex site = mesh_.to_vertex_handle(boundary);
  if (!mesh_.is_boundary(mesh_.halfedge_handle(site))) {
    mesh_.set_halfedge_handle(site, out);
    return;
  }
  // The vertex of the site belongs to another fan already.
  const Vertex own = further_vertex(static_cast<Site>(site.idx()), boundary);
  mesh_.set_vertex_handle(boundary, own);
  for (Halfedge h = mesh_.opposite_halfedge_handle(boundary); h != out;) {
    const Halfedge before = mesh_.prev_halfedge_handle(h);
    mesh_.set_vertex_handle(before, own);
    h = mesh_.opposite_halfedge_handle(before);
  }
}

AssembledPatches PatchAssembler::join() && {
  std::vector<Halfedge> open;
  for (const Halfedge boundary : holes_.loose) close_fan(boundary);
  rims_.for_each([&](const Rim& rim) {
    if (!mesh_.is_boundary(rim.boundary)) return;
    close_fan(rim.boundary);
    open.push_back(rim.boundary);
  });
  rims_.end();
  // The mesh grew by several edges at a time, so that unused edges must be removed.
  const std::size_t first_further = vertices_.vertices() - holes_.into.size();
  mesh_.resize(vertices_.vertices(), edges_, faces_);
  for (std::size_t i = 0; i < holes_.into.size(); ++i)
    mesh_.set_halfedge_handle(Vertex(static_cast<int>(first_further + i)), mesh_.next_halfedge_handle(holes_.into[i]));
  vertices_.list_announced();
  AssembledPatches assembled(mesh_, std::move(vertices_));
  assembled.open_ = std::move(open);
  assembled.holes_ = std::move(holes_.edges);
  return assembled;
}

}  // namespace meshops
