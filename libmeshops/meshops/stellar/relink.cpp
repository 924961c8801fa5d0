#include "meshops/stellar/relink.h"

#include <array>
#include <utility>

#include "meshops/core/add_elements.h"
#include "meshops/core/fans.h"

namespace meshops::detail {
namespace {

void mark_deleted(Connectivity& mesh, const StarElements& removed) {
  mesh.status(removed.vertex).set_deleted(true);
  for (const Face f : removed.faces()) mesh.status(f).set_deleted(true);
  for (const Edge e : removed.edges()) {
    mesh.status(e).set_deleted(true);
    mesh.status(mesh.halfedge_handle(e, 0)).set_deleted(true);
    mesh.status(mesh.halfedge_handle(e, 1)).set_deleted(true);
  }
}

/// The halfedges of the two triangles at the edge of h = v→w, named by their ends; c is the apex on the left, d on the
/// right. On a side without a triangle, they are the neighbors of h or o on the boundary, and their opposites.
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

  /// Returns whether v has only one edge besides the edge of h. That edge then leads to c, which is also d.
  bool v_has_degree_two() const { return has_left && has_right && vc == vd; }
};

/// Closes the edge of h as close_edge() does, if v has two edges. Of the edges from w to c, the one right of h stays.
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
  return effect;
}

/// Splits w as open_vertex() does, with the vertex, the edges and the faces that `elements` supplies.
template <typename Elements>
SplitEffect open_with(Connectivity& mesh, Vertex w, Halfedge left, Halfedge right, Elements elements) {
  const bool has_left = left.is_valid(), has_right = right.is_valid();
  const Halfedge named = mesh.halfedge_handle(w);  // at a boundary vertex w, the boundary halfedge that leaves w
  const Halfedge end = has_right ? right : ccw(mesh, named);
  const bool left_was_boundary = has_left && mesh.is_boundary(left);
  SplitEffect effect;
  StarElements& added = effect.added;
  added.at_boundary = !has_left || !has_right;
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
    if (mesh.is_boundary(dw) && mesh.halfedge_handle(d) == dw) mesh.set_halfedge_handle(d, dv);
    take_place(mesh, dv, dw, mesh.prev_halfedge_handle(dw), mesh.next_halfedge_handle(dw));
    make_triangle(mesh, face, o, vd, dw);
  }

  const Halfedge named_of_v = !named_moves ? h : named == left ? vc : named;
  mesh.set_halfedge_handle(v, named_of_v);
  if (named_moves) mesh.set_halfedge_handle(w, o);
  if (!has_left) {
    mesh.set_boundary(h);
    mesh.set_next_halfedge_handle(mesh.prev_halfedge_handle(named), h);
    mesh.set_next_halfedge_handle(h, named);
  }
  if (!has_right) {
    mesh.set_boundary(o);
    mesh.set_next_halfedge_handle(mesh.prev_halfedge_handle(named_of_v), o);
    mesh.set_next_halfedge_handle(o, named_of_v);
  }
  return effect;
}

/// Reverses close_inner_path(): splits the edge of `effect.right` into two edges from w to c, with `v` between them.
void open_inner_path(Connectivity& mesh, const WeldEffect& effect, Vertex v, Halfedge vc, Halfedge wc) {
  const Halfedge h = effect.halfedge, o = mesh.opposite_halfedge_handle(h);
  const Halfedge dw = mesh.opposite_halfedge_handle(*effect.right), cw_left = mesh.opposite_halfedge_handle(wc);
  const Halfedge cv = mesh.opposite_halfedge_handle(vc);
  const Vertex w = effect.survivor, c = mesh.from_vertex_handle(dw);
  for (const auto& [halfedge, to] : {std::pair(h, w), {o, v}, {vc, c}, {cv, v}, {wc, c}, {cw_left, w}})
    mesh.set_vertex_handle(halfedge, to);
  take_place(mesh, cw_left, dw, mesh.prev_halfedge_handle(dw), mesh.next_halfedge_handle(dw));
  make_triangle(mesh, effect.removed.face[0], h, wc, cv);
  make_triangle(mesh, effect.removed.face[1], o, vc, dw);
  mesh.set_halfedge_handle(v, h);
  if (mesh.halfedge_handle(c) == dw) mesh.set_halfedge_handle(c, cw_left);
}

/// Returns the halfedge by which the deleted edge `e` left `v`, according to the records that the mesh still has.
Halfedge leaving(const Connectivity& mesh, Edge e, Vertex v) {
  return mesh.halfedge_handle(e, mesh.to_vertex_handle(mesh.halfedge_handle(e, 0)) == v ? 1 : 0);
}

/// Source of the elements that a weld removed, which it returns one by one in the order of WeldEffect::removed.
class RevivedElements {
 public:
  RevivedElements(Connectivity& mesh, const WeldEffect& effect)
      : mesh_(mesh), removed_(effect.removed), along_{effect.halfedge, Halfedge(), Halfedge()} {
    for (std::size_t i = 1; i < removed_.edges().size(); ++i)
      along_[i] = leaving(mesh, removed_.edge[i], removed_.vertex);
  }
  Vertex vertex() const { return removed_.vertex; }
  Halfedge edge(Vertex from, Vertex to) {
    const Halfedge h = along_[edges_++];
    mesh_.set_vertex_handle(h, to);
    mesh_.set_vertex_handle(mesh_.opposite_halfedge_handle(h), from);
    return h;
  }
  Face face() { return removed_.face[faces_++]; }

 private:
  Connectivity& mesh_;
  const StarElements& removed_;
  std::array<Halfedge, 3> along_;  // for each edge, the halfedge that leaves the vertex
  std::size_t edges_ = 0, faces_ = 0;
};

/// Returns whether a gap of the boundary between `left` and `right` is not the only gap at `w`. A gap lies between each
/// boundary halfedge that leaves `w` and the next edge counter-clockwise. With several gaps, the boundary halfedge of
/// the vertex on one side of the split would be ambiguous.
bool parts_gaps(const Connectivity& mesh, Vertex w, std::optional<Halfedge> left, std::optional<Halfedge> right) {
  const Halfedge named = mesh.halfedge_handle(w);
  const auto gaps_between = [&](Halfedge first, Halfedge end) {
    int gaps = 0;
    for (Halfedge out = first; out != end; out = ccw(mesh, out)) gaps += mesh.is_boundary(out);
    return gaps;
  };
  // An absent halfedge stands for the gap at the boundary halfedge of w.
  if (!right) return gaps_between(*left, named) > 0;
  if (!left) return gaps_between(ccw(mesh, named), *right) > 0;
  const bool full_turn = *left == *right;
  const int within =
      (full_turn && mesh.is_boundary(*left) ? 1 : 0) + gaps_between(full_turn ? ccw(mesh, *left) : *left, *right);
  return within > 1 || (within == 1 && !full_turn && gaps_between(*right, *left) > 0);
}

/// Returns a neighbor to which two edges would join the new vertex; an invalid handle if there is none.
Vertex joined_twice(const Connectivity& mesh, Vertex w, Halfedge left, Halfedge right) {
  const Vertex c = left.is_valid() ? mesh.to_vertex_handle(left) : Vertex();
  const Vertex d = right.is_valid() ? mesh.to_vertex_handle(right) : Vertex();
  if (c == d) return c;
  const Halfedge named = mesh.halfedge_handle(w);
  const Halfedge end = right.is_valid() ? right : ccw(mesh, named);
  for (Halfedge out = ccw(mesh, left.is_valid() ? left : named); out != end; out = ccw(mesh, out))
    if (const Vertex to = mesh.to_vertex_handle(out); to == c || to == d) return to;
  return Vertex();
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
  // The walk alternates between both vertices, so that a vertex with many edges does not make its neighbors slow.
  do {
    if (mesh.to_vertex_handle(from_a) == b || mesh.to_vertex_handle(from_b) == a) return true;
    from_a = cw(mesh, from_a);
    from_b = cw(mesh, from_b);
  } while (from_a != first_of_a && from_b != first_of_b);
  return false;
}

SplitEffect open_vertex(Connectivity& mesh, Vertex w, Halfedge left, Halfedge right) {
  const std::size_t sides = (left.is_valid() ? 1U : 0U) + (right.is_valid() ? 1U : 0U);
  return open_with(mesh, w, left, right, AddedElements(mesh, 1, 1 + sides, sides));
}

void open_vertex_again(Connectivity& mesh, const WeldEffect& effect) {
  const StarElements& removed = effect.removed;
  const Vertex v = removed.vertex, w = effect.survivor;
  // The removed elements still have their old records. Those read here cannot be derived from the rest of the mesh.
  const Halfedge h = effect.halfedge, named_by_v = mesh.halfedge_handle(v);
  const std::array<Halfedge, 2> named_by_face = {
      mesh.halfedge_handle(removed.face[0]), removed.at_boundary ? Halfedge() : mesh.halfedge_handle(removed.face[1])};
  const Edge beside_o = mesh.edge_handle(mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(h)));
  const bool v_had_degree_two = !removed.at_boundary && effect.left == effect.right && beside_o == removed.edge[1];

  mesh.status(v).set_deleted(false);
  for (const Face f : removed.faces()) mesh.status(f).set_deleted(false);
  for (const Edge e : removed.edges()) {
    mesh.status(e).set_deleted(false);
    for (const unsigned side : {0U, 1U}) mesh.status(mesh.halfedge_handle(e, side)).set_deleted(false);
  }
  if (v_had_degree_two)
    open_inner_path(mesh, effect, v, leaving(mesh, removed.edge[1], v), leaving(mesh, removed.edge[2], w));
  else
    open_with(mesh, w, effect.left.value_or(Halfedge()), effect.right.value_or(Halfedge()),
              RevivedElements(mesh, effect));

  name_again(mesh, v, named_by_v);
  name_again(mesh, w, effect.named[0]);
  if (effect.left) name_again(mesh, mesh.to_vertex_handle(*effect.left), effect.named[1]);
  if (effect.right) name_again(mesh, mesh.to_vertex_handle(*effect.right), effect.named[2]);
  for (std::size_t i = 0; i < removed.faces().size(); ++i)
    if (const Halfedge side = named_by_face[i]; is_live(mesh, side) && mesh.face_handle(side) == removed.face[i])
      mesh.set_halfedge_handle(removed.face[i], side);
}

std::optional<Blocker> open_blocker(const Connectivity& mesh, std::optional<Halfedge> left,
                                    std::optional<Halfedge> right, Keep keep) {
  if (!left && !right) return Blocker(BlockerKind::none_given);
  for (const auto& h : {left, right})
    if (h && !is_live(mesh, *h)) return Blocker(BlockerKind::missing, *h);
  const Vertex w = mesh.from_vertex_handle(left ? *left : *right);
  if (left && right && mesh.from_vertex_handle(*right) != w) return Blocker(BlockerKind::other_vertex, *right);
  if ((!left || !right) && !mesh.is_boundary(w)) return Blocker(BlockerKind::not_on_boundary, w);
  if (mesh.is_boundary(w) && parts_gaps(mesh, w, left, right)) return Blocker(BlockerKind::several_fans, w);
  if (keep == Keep::manifold) return std::nullopt;
  const Vertex twice = joined_twice(mesh, w, left.value_or(Halfedge()), right.value_or(Halfedge()));
  return twice.is_valid() ? std::optional(Blocker(BlockerKind::double_edge, twice)) : std::nullopt;
}

WeldEffect close_links(Connectivity& mesh, Halfedge h) {
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

  // The neighbors of removed elements are found first: undo() reads the records of the elements, which must not change.
  const Halfedge wd = mesh.opposite_halfedge_handle(s.dw);
  const Halfedge named_by_v = mesh.halfedge_handle(v);
  effect.removed.edge[0] = mesh.edge_handle(s.h);
  effect.named[0] = mesh.halfedge_handle(w);
  const Halfedge end = s.has_right ? s.vd : s.h;
  for (Halfedge out = ccw(mesh, s.has_left ? s.vc : s.h); out != end; out = ccw(mesh, out))
    mesh.set_vertex_handle(mesh.opposite_halfedge_handle(out), w);
  if (s.has_left && (effect.named[0] == s.o || (mesh.is_boundary(named_by_v) && !mesh.is_boundary(effect.named[0]))))
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
    mesh.set_next_halfedge_handle(s.cv, s.wc);  // the boundary halfedges before and after h
  }
  if (s.has_right) {
    effect.right = wd;
    effect.removed.edge[s.has_left ? 2 : 1] = mesh.edge_handle(s.vd);
    if (effect.named[2] == s.dv) mesh.set_halfedge_handle(d, s.dw);
    take_place(mesh, s.dw, s.dv, before_dv, after_dv);
  } else if (s.vc != s.vd) {
    mesh.set_next_halfedge_handle(s.dw, s.vd);  // the boundary halfedges before and after o
  }
  return effect;
}

WeldEffect close_edge(Connectivity& mesh, Halfedge h) {
  const WeldEffect effect = close_links(mesh, h);
  mark_deleted(mesh, effect.removed);
  return effect;
}

std::optional<Blocker> close_blocker(const Connectivity& mesh, Halfedge h, Keep keep) {
  const Star s(mesh, h);
  const Vertex v = mesh.to_vertex_handle(s.o), w = mesh.to_vertex_handle(s.h);
  const bool inner = s.has_left && s.has_right;
  if (s.has_left && !is_triangle(mesh, s.h)) return Blocker(BlockerKind::not_triangle, mesh.face_handle(s.h));
  if (s.has_right && !is_triangle(mesh, s.o)) return Blocker(BlockerKind::not_triangle, mesh.face_handle(s.o));
  if (inner && mesh.is_boundary(v) && mesh.is_boundary(w)) return Blocker(BlockerKind::pinch, mesh.edge_handle(h));

  // Two edges that become one have no face left if neither has a face besides the triangle between them.
  const Halfedge cw_left = mesh.opposite_halfedge_handle(s.wc), wd = mesh.opposite_halfedge_handle(s.dw);
  const auto dangles = [&](Halfedge one, Halfedge other) { return mesh.is_boundary(one) && mesh.is_boundary(other); };
  bool only_edge_left = false;
  if (!inner)
    only_edge_left = s.has_left ? dangles(s.vc, cw_left) : dangles(s.dv, wd);
  else if (s.wc == wd)
    only_edge_left = s.v_has_degree_two() || dangles(s.vc, s.dv);
  else if (s.v_has_degree_two())
    only_edge_left = dangles(cw_left, wd);
  if (only_edge_left) return Blocker(BlockerKind::only_edge_left, mesh.edge_handle(h));

  const Halfedge end = s.has_right ? s.vd : s.h;
  const Halfedge start = s.v_has_degree_two() ? end : ccw(mesh, s.has_left ? s.vc : s.h);
  int gaps = (s.has_left ? mesh.is_boundary(s.vc) : 1);
  for (Halfedge out = start; out != end; out = ccw(mesh, out)) {
    if (mesh.to_vertex_handle(out) == w) return Blocker(BlockerKind::loop_edge, mesh.edge_handle(out));
    gaps += mesh.is_boundary(out);
  }
  if (gaps > 1) return Blocker(BlockerKind::several_fans, v);
  if (keep == Keep::manifold) return std::nullopt;

  for (Halfedge out = start; out != end; out = ccw(mesh, out))
    if (const Vertex to = mesh.to_vertex_handle(out); are_joined(mesh, w, to))
      return Blocker(BlockerKind::double_edge, to);
  // If v has only one more face, between left and right, this face must not get the corners of another face of w.
  if (start == end && inner && is_triangle(mesh, s.vc)) {
    const Vertex c = mesh.to_vertex_handle(s.vc), d = mesh.to_vertex_handle(s.vd);
    Halfedge out = s.o;
    do {
      const Vertex to = mesh.to_vertex_handle(out), then = mesh.to_vertex_handle(mesh.next_halfedge_handle(out));
      if (((to == c && then == d) || (to == d && then == c)) && is_triangle(mesh, out))
        return Blocker(BlockerKind::double_triangle, mesh.face_handle(out));
      out = cw(mesh, out);
    } while (out != s.o);
  }
  return std::nullopt;
}

}  // namespace meshops::detail
