// Finds edges and triangles by their sites.
#include "meshops/front/fitting.h"

namespace meshops::detail {
namespace {

/// Walk over the halfedges that leave a site, fan after fan.
class Leaving {
 public:
  Leaving(const Connectivity& mesh, const SiteVertices& vertices, Site s) : mesh_(mesh), vertices_(vertices) {
    begin(vertices.first(s));
  }

  /// Returns the next halfedge, or an invalid handle after the last.
  Halfedge next() {
    const Halfedge found = at_;
    if (!found.is_valid()) return found;
    at_ = mesh_.next_halfedge_handle(mesh_.opposite_halfedge_handle(at_));
    if (at_ == mesh_.halfedge_handle(fan_)) begin(vertices_.next(fan_));
    return found;
  }

 private:
  void begin(Vertex fan) {
    fan_ = fan;
    at_ = fan.is_valid() ? mesh_.halfedge_handle(fan) : Halfedge();
  }
  const Connectivity& mesh_;
  const SiteVertices& vertices_;
  Vertex fan_;
  Halfedge at_;
};

}  // namespace

Halfedge Fitting::edge_between(Site from, Site to) const {
  // The walk alternates between both sites, so that a site with many edges does not make its neighbors slow.
  Leaving out_of(mesh_, vertices_, from), back_from(mesh_, vertices_, to);
  for (;;) {
    const Halfedge out = out_of.next();
    if (!out.is_valid() || end(out) == to) return out;
    const Halfedge back = back_from.next();
    if (!back.is_valid()) return back;
    if (end(back) == from) return mesh_.opposite_halfedge_handle(back);
  }
}

std::vector<Halfedge> Fitting::edges_between(Site from, Site to) const {
  // The walk alternates between both sites. The site whose walk ends first has met all edges between the two.
  Leaving out_of(mesh_, vertices_, from), back_from(mesh_, vertices_, to);
  std::vector<Halfedge> met_out, met_back;
  for (;;) {
    const Halfedge out = out_of.next();
    if (!out.is_valid()) return met_out;
    if (end(out) == to) met_out.push_back(out);
    const Halfedge back = back_from.next();
    if (!back.is_valid()) return met_back;
    if (end(back) == from) met_back.push_back(mesh_.opposite_halfedge_handle(back));
  }
}

Halfedge Fitting::boundary_between(Site from, Site to) const {
  // The walk alternates between both sites. At an open fan, one boundary halfedge leaves the vertex, and one enters it.
  Vertex leaving = vertices_.first(from), entering = vertices_.first(to);
  while (leaving.is_valid()) {
    const Halfedge out = mesh_.halfedge_handle(leaving);
    if (mesh_.is_boundary(out) && end(out) == to) return out;
    leaving = vertices_.next(leaving);
    if (!leaving.is_valid() || !entering.is_valid()) break;
    const Halfedge next = mesh_.halfedge_handle(entering);
    if (mesh_.is_boundary(next))
      if (const Halfedge in = mesh_.prev_halfedge_handle(next); start(in) == from) return in;
    entering = vertices_.next(entering);
  }
  return Halfedge();
}

Face Fitting::triangle_on(Site a, Site b, Site c) const {
  Leaving out_of(mesh_, vertices_, a);
  for (Halfedge h = out_of.next(); h.is_valid(); h = out_of.next()) {
    if (mesh_.is_boundary(h) || end(h) != b) continue;
    const Halfedge next = mesh_.next_halfedge_handle(h);
    if (end(next) == c && mesh_.next_halfedge_handle(next) == mesh_.prev_halfedge_handle(h))
      return mesh_.face_handle(h);
  }
  return Face();
}

}  // namespace meshops::detail
