#include "meshops/front/fitting.h"

#include <algorithm>

namespace meshops::detail {

void Fitting::check_corners(Fit& fit) const {
  const std::size_t sites = vertices_.sites();
  const auto& [a, b, c] = fit.corners;
  std::size_t end = sites;  // one past the greatest site, including the new sites
  if (std::max({a, b, c}) >= sites)
    for (unsigned turn = 0; turn < 3; ++turn) end += static_cast<std::size_t>(std::ranges::count(fit.corners, end));
  for (unsigned i = 0; i < 3; ++i) {
    const Site s = fit.corners[i];
    if (s == fit.corners[(i + 1) % 3]) fit.refusal = Refusal{RefusalKind::corner_repeated, s};
    if (s >= end || (s < sites && !vertices_.exists(s))) fit.refusal = Refusal{RefusalKind::no_such_site, s};
    if (fit.refusal) return;
  }
}

void Fitting::find_sides(Fit& fit) const {
  for (unsigned side = 0; side < 3; ++side)
    if (!finds_side(fit, side)) return;
  refuse_closed(fit);
}

void Fitting::find_other_sides(Fit& fit) const {
  const Site apex = fit.corners[2];
  if (is_new(apex) || vertices_.is_free(apex)) return;
  // Usually the side is next to `h` on the curve, and no search is needed.
  const Halfedge h = fit.sides.side[0], next = mesh_.next_halfedge_handle(h), previous = mesh_.prev_halfedge_handle(h);
  if (end(next) == apex)
    fit.sides.side[1] = next;
  else if (!finds_side(fit, 1))
    return;
  if (start(previous) == apex)
    fit.sides.side[2] = previous;
  else if (!finds_side(fit, 2))
    return;
  refuse_closed(fit);
}

/// Sets a side of `fit` to the boundary halfedge between its sites, if there is one. If there is none, but an edge
/// joins the two sites, sets the refusal and returns false; otherwise returns true.
bool Fitting::finds_side(Fit& fit, unsigned side) const {
  const Site from = fit.corners[side], to = fit.corners[(side + 1) % 3];
  if (is_new(from) || is_new(to) || vertices_.is_free(from) || vertices_.is_free(to)) return true;
  Halfedge& h = fit.sides.side[side];
  h = boundary_between(from, to);
  if (h.is_valid() || !edge_between(from, to).is_valid()) return true;
  fit.refusal = Refusal{RefusalKind::side_taken, from, to};
  return false;
}

/// Refuses a triangle with a corner at which nothing is glued, on a site around which all faces close: no further fan
/// may begin there.
void Fitting::refuse_closed(Fit& fit) const {
  for (unsigned i = 0; i < 3; ++i) {
    const Site s = fit.corners[i];
    if (fit.sides.side[i].is_valid() || fit.sides.side[(i + 2) % 3].is_valid() || is_new(s)) continue;
    bool is_open = vertices_.is_free(s);
    vertices_.for_each(s, [&](Vertex v) { is_open = is_open || mesh_.is_boundary(v); });
    if (!is_open) fit.refusal = Refusal{RefusalKind::site_closed, s};
  }
}

void Fitting::refuse_twice(Fit& fit) const {
  const auto& [a, b, c] = fit.corners;
  if (is_new(a) || is_new(b) || is_new(c)) return;
  if (const Face there = triangle_on(a, b, c); there.is_valid())
    fit.refusal = Refusal{RefusalKind::triangle_there, a, b, there.idx()};
}

}  // namespace meshops::detail
