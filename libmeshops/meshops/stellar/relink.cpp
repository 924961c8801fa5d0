#include "meshops/stellar/relink.h"

#include "meshops/core/add_elements.h"

namespace meshops::detail {
namespace {

/// `heir` takes the place of h in its loop, and in the record of its face. `before` and `after` are the neighbours
/// there.
void take_place(Connectivity& mesh, Halfedge heir, Halfedge h, Halfedge before, Halfedge after) {
  const Face face = mesh.face_handle(h);
  mesh.set_next_halfedge_handle(before, heir);
  mesh.set_next_halfedge_handle(heir, after);
  mesh.set_face_handle(heir, face);
  if (face.is_valid() && mesh.halfedge_handle(face) == h) mesh.set_halfedge_handle(face, heir);
}

void mark_deleted(Connectivity& mesh, const StarElements& removed) {
  mesh.status(removed.vertex).set_deleted(true);
  for (const Face f : removed.faces()) mesh.status(f).set_deleted(true);
  for (const Edge e : removed.edges()) {
    mesh.status(e).set_deleted(true);
    mesh.status(mesh.halfedge_handle(e, 0)).set_deleted(true);
    mesh.status(mesh.halfedge_handle(e, 1)).set_deleted(true);
  }
}

/// The halfedges around the edge of h = v→w, as both triangles lie on a plane: c on the left, d on the right. Handles
/// of a side without a triangle mean nothing.
struct Star {
  Star(const Connectivity& mesh, Halfedge along)
      : h(along),
        o(mesh.opposite_halfedge_handle(h)),
        wc(mesh.next_halfedge_handle(h)),
        cv(mesh.prev_halfedge_handle(h)),
        vc(mesh.opposite_halfedge_handle(cv)),
        vd(mesh.next_halfedge_handle(o)),
        dw(mesh.prev_halfedge_handle(o)),
        dv(mesh.opposite_halfedge_handle(vd)),
        has_left(!mesh.is_boundary(h)),
        has_right(!mesh.is_boundary(o)) {}

  Halfedge h, o, wc, cv, vc, vd, dw, dv;
  bool has_left, has_right;

  /// The only other edge of v leads to c, which is d.
  bool v_has_degree_two() const { return has_left && has_right && vc == vd; }
};

/// close_edge() where v has two edges: of those from w to c, which become one, that on the right stays.
WeldEffect close_inner_path(Connectivity& mesh, const Star& s, WeldEffect effect) {
  const Halfedge cw_left = mesh.opposite_halfedge_handle(s.wc), wc_right = mesh.opposite_halfedge_handle(s.dw);
  const Vertex w = effect.survivor, c = mesh.to_vertex_handle(s.wc);
  effect.removed.edge = {mesh.edge_handle(s.h), mesh.edge_handle(s.vc), mesh.edge_handle(s.wc)};
  effect.left = effect.right = wc_right;
  effect.named = {mesh.halfedge_handle(w), mesh.halfedge_handle(c), mesh.halfedge_handle(c)};
  if (effect.named[0] == s.o || effect.named[0] == s.wc) mesh.set_halfedge_handle(w, wc_right);
  if (effect.named[1] == s.cv || effect.named[1] == cw_left) mesh.set_halfedge_handle(c, s.dw);
  Halfedge before = mesh.prev_halfedge_handle(cw_left), after = mesh.next_halfedge_handle(cw_left);
  take_place(mesh, s.dw, cw_left, before, after);
  mark_deleted(mesh, effect.removed);
  return effect;
}

}  // namespace

constexpr int usual_degree = 12;

bool are_joined(const Connectivity& mesh, Vertex a, Vertex b) {
  const Halfedge first_of_a = mesh.halfedge_handle(a), first_of_b = mesh.halfedge_handle(b);
  Halfedge from_a = first_of_a, from_b = first_of_b;
  for (int i = 0; i < usual_degree; ++i) {
    if (mesh.to_vertex_handle(from_a) == b) return true;
    from_a = cw(mesh, from_a);
    if (from_a == first_of_a) return false;
  }
  // Around both at once then: a vertex of many edges must not make its neighbours slow.
  do {
    if (mesh.to_vertex_handle(from_a) == b || mesh.to_vertex_handle(from_b) == a) return true;
    from_a = cw(mesh, from_a);
    from_b = cw(mesh, from_b);
  } while (from_a != first_of_a && from_b != first_of_b);
  return false;
}

SplitEffect open_vertex(Connectivity& mesh, Vertex w, Halfedge left, Halfedge right) {
  const bool has_left = left.is_valid(), has_right = right.is_valid();
  const Halfedge named = mesh.halfedge_handle(w);  // on the boundary, what the boundary leaves w by
  const Halfedge end = has_right ? right : ccw(mesh, named);
  const bool left_was_boundary = has_left && mesh.is_boundary(left);
  SplitEffect effect;
  StarElements& added = effect.added;
  added.at_boundary = !has_left || !has_right;
  AddedElements elements(mesh, 1, added.edges().size(), added.faces().size());
  const Vertex v = added.vertex = elements.vertex();
  bool named_moves = left_was_boundary && left == named;
  for (Halfedge out = ccw(mesh, has_left ? left : named); out != end; out = ccw(mesh, out)) {
    mesh.set_vertex_handle(mesh.opposite_halfedge_handle(out), v);
    named_moves = named_moves || out == named;
  }

  const Halfedge h = effect.halfedge = elements.edge(v, w);
  const Halfedge o = mesh.opposite_halfedge_handle(h);
  added.edge[0] = mesh.edge_handle(h);
  Halfedge vc, vd;
  if (has_left) {
    vc = elements.edge(v, mesh.to_vertex_handle(left));
    added.edge[1] = mesh.edge_handle(vc);
    added.face[0] = elements.face();
    take_place(mesh, vc, left, mesh.prev_halfedge_handle(left), mesh.next_halfedge_handle(left));
    make_triangle(mesh, added.face[0], h, left, mesh.opposite_halfedge_handle(vc));
  }
  if (has_right) {
    const Halfedge dw = mesh.opposite_halfedge_handle(right);
    const Vertex d = mesh.to_vertex_handle(right);
    vd = elements.edge(v, d);
    const Halfedge dv = mesh.opposite_halfedge_handle(vd);
    added.edge[has_left ? 2 : 1] = mesh.edge_handle(vd);
    const Face face = added.face[has_left ? 1 : 0] = elements.face();
    if (mesh.is_boundary(dw)) mesh.set_halfedge_handle(d, dv);
    take_place(mesh, dv, dw, mesh.prev_halfedge_handle(dw), mesh.next_halfedge_handle(dw));
    make_triangle(mesh, face, o, vd, dw);
  }

  const Halfedge named_of_v = !named_moves ? h : named == left ? vc : named;
  mesh.set_halfedge_handle(v, named_of_v);
  if (named_moves) mesh.set_halfedge_handle(w, o);
  if (!has_left) {
    mesh.set_next_halfedge_handle(mesh.prev_halfedge_handle(named), h);
    mesh.set_next_halfedge_handle(h, named);
  }
  if (!has_right) {
    mesh.set_next_halfedge_handle(mesh.prev_halfedge_handle(named_of_v), o);
    mesh.set_next_halfedge_handle(o, named_of_v);
  }
  return effect;
}

const char* open_refusal(const Connectivity& mesh, Vertex w, Halfedge left, Halfedge right, Keep keep) {
  if (keep == Keep::manifold) return nullptr;
  const char* const reason = "two edges would join the new vertex and the same other";
  const Vertex c = left.is_valid() ? mesh.to_vertex_handle(left) : Vertex();
  const Vertex d = right.is_valid() ? mesh.to_vertex_handle(right) : Vertex();
  if (c == d) return reason;
  const Halfedge named = mesh.halfedge_handle(w);
  const Halfedge end = right.is_valid() ? right : ccw(mesh, named);
  for (Halfedge out = ccw(mesh, left.is_valid() ? left : named); out != end; out = ccw(mesh, out))
    if (const Vertex to = mesh.to_vertex_handle(out); to == c || to == d) return reason;
  return nullptr;
}

WeldEffect close_edge(Connectivity& mesh, Halfedge h) {
  const Star s(mesh, h);
  const Vertex v = mesh.to_vertex_handle(s.o), w = mesh.to_vertex_handle(s.h);
  WeldEffect effect;
  effect.halfedge = h;
  effect.survivor = w;
  effect.removed.vertex = v;
  effect.removed.at_boundary = !s.has_left || !s.has_right;
  effect.removed.face[0] = mesh.face_handle(s.has_left ? s.h : s.o);
  if (!effect.removed.at_boundary) effect.removed.face[1] = mesh.face_handle(s.o);
  if (s.v_has_degree_two()) return close_inner_path(mesh, s, effect);

  // Nothing may be written to the records of what goes: undo() reads them. So the neighbours are found before.
  const Halfedge wd = mesh.opposite_halfedge_handle(s.dw);
  const Halfedge named_by_v = mesh.halfedge_handle(v);
  effect.removed.edge[0] = mesh.edge_handle(s.h);
  effect.named[0] = mesh.halfedge_handle(w);
  const Halfedge end = s.has_right ? s.vd : s.h;
  for (Halfedge out = ccw(mesh, s.has_left ? s.vc : s.h); out != end; out = ccw(mesh, out))
    mesh.set_vertex_handle(mesh.opposite_halfedge_handle(out), w);
  if (s.has_left && (effect.named[0] == s.o || mesh.is_boundary(named_by_v)))
    mesh.set_halfedge_handle(w, named_by_v == s.h || named_by_v == s.vc ? s.wc
                                : s.has_right && named_by_v == s.vd     ? wd
                                                                        : named_by_v);

  Halfedge before_vc, after_vc, before_dv, after_dv;
  if (s.has_left) {
    before_vc = mesh.prev_halfedge_handle(s.vc);
    after_vc = mesh.next_halfedge_handle(s.vc);
    if (before_vc == s.o) before_vc = mesh.prev_halfedge_handle(s.o);
    if (s.has_right && before_vc == s.dv) before_vc = s.dw;
    if (s.has_right && after_vc == s.dv) after_vc = s.dw;
  }
  if (s.has_right) {
    before_dv = mesh.prev_halfedge_handle(s.dv);
    after_dv = mesh.next_halfedge_handle(s.dv);
    if (after_dv == s.h) after_dv = mesh.next_halfedge_handle(s.h);
    if (s.has_left && before_dv == s.vc) before_dv = s.wc;
    if (s.has_left && after_dv == s.vc) after_dv = s.wc;
  }
  const Vertex c = s.has_left ? mesh.to_vertex_handle(s.wc) : w, d = s.has_right ? mesh.to_vertex_handle(wd) : w;
  effect.named[1] = mesh.halfedge_handle(c);
  effect.named[2] = mesh.halfedge_handle(d);
  if (s.has_left) {
    effect.left = s.wc;
    effect.removed.edge[1] = mesh.edge_handle(s.vc);
    if (effect.named[1] == s.cv) mesh.set_halfedge_handle(c, mesh.opposite_halfedge_handle(s.wc));
    take_place(mesh, s.wc, s.vc, before_vc, after_vc);
  } else if (s.dv != s.cv) {
    mesh.set_next_halfedge_handle(s.cv, s.wc);  // the boundary before and after h
  }
  if (s.has_right) {
    effect.right = wd;
    effect.removed.edge[s.has_left ? 2 : 1] = mesh.edge_handle(s.vd);
    if (effect.named[2] == s.dv) mesh.set_halfedge_handle(d, s.dw);
    take_place(mesh, s.dw, s.dv, before_dv, after_dv);
  } else if (s.vc != s.vd) {
    mesh.set_next_halfedge_handle(s.dw, s.vd);  // the boundary before and after o
  }
  mark_deleted(mesh, effect.removed);
  return effect;
}

const char* close_refusal(const Connectivity& mesh, Halfedge h, Keep keep) {
  const Star s(mesh, h);
  const Vertex v = mesh.to_vertex_handle(s.o), w = mesh.to_vertex_handle(s.h);
  const bool inner = s.has_left && s.has_right;
  if ((s.has_left && !is_triangle(mesh, s.h)) || (s.has_right && !is_triangle(mesh, s.o)))
    return "a face is not a triangle";
  if (inner && mesh.is_boundary(v) && mesh.is_boundary(w))
    return "an inner edge between two boundary vertices: they would become a pinch";

  // Can the two edges that become one lose their last face? Only where nothing else is there.
  const Halfedge cw_left = mesh.opposite_halfedge_handle(s.wc), wd = mesh.opposite_halfedge_handle(s.dw);
  const auto dangles = [&](Halfedge one, Halfedge other) { return mesh.is_boundary(one) && mesh.is_boundary(other); };
  bool only_edge_left = false;
  if (!inner)
    only_edge_left = s.has_left ? dangles(s.vc, cw_left) : dangles(s.dv, wd);
  else if (s.wc == wd)
    only_edge_left = s.v_has_degree_two() || dangles(s.vc, s.dv);
  else if (s.v_has_degree_two())
    only_edge_left = dangles(cw_left, wd);
  if (only_edge_left) return "nothing but an edge would be left of the component";

  const Halfedge end = s.has_right ? s.vd : s.h;
  const Halfedge start = s.v_has_degree_two() ? end : ccw(mesh, s.has_left ? s.vc : s.h);
  for (Halfedge out = start; out != end; out = ccw(mesh, out))
    if (mesh.to_vertex_handle(out) == w) return "another edge joins the two vertices: it would become a loop";
  if (keep == Keep::manifold) return nullptr;

  for (Halfedge out = start; out != end; out = ccw(mesh, out))
    if (are_joined(mesh, w, mesh.to_vertex_handle(out))) return "two edges would join the same vertices";
  // The face between left and right, when v has no more: it must not come to lie on another one of w.
  if (start == end && inner && is_triangle(mesh, s.vc)) {
    const Vertex c = mesh.to_vertex_handle(s.vc), d = mesh.to_vertex_handle(s.vd);
    Halfedge out = s.o;
    do {
      const Vertex to = mesh.to_vertex_handle(out), then = mesh.to_vertex_handle(mesh.next_halfedge_handle(out));
      if (((to == c && then == d) || (to == d && then == c)) && is_triangle(mesh, out))
        return "two triangles would have the same corners";
      out = cw(mesh, out);
    } while (out != s.o);
  }
  return nullptr;
}

}  // namespace meshops::detail
