#include "meshops/front/front.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "meshops/core/contract.h"

namespace meshops {

Front::Front(Connectivity& mesh, std::size_t sites, std::size_t supply)
    : mesh_(mesh), first_sites_(sites), supply_(supply) {
  require(mesh.n_vertices() == 0, "Front: the mesh is not empty");
  require(supply > 0, "Front: supply is 0");
  mesh.resize(sites, 0, 0);
}

void Front::supply(std::size_t edges, std::size_t faces) {
  mesh_.resize(mesh_.n_vertices(), mesh_.n_edges() + edges, mesh_.n_faces() + faces);
}

Site Front::add_site() {
  const auto s = static_cast<Site>(sites());
  added_.push_back(-1);
  return s;
}

Vertex Front::vertex_for_fan(Site s) {
  if (is_first(s) && is_free(s)) return Vertex(s);
  int index;
  if (unused_.empty()) {
    index = mesh_.new_vertex().idx() - static_cast<int>(first_sites_);
    extra_.push_back({});
  } else {
    index = unused_.back().idx() - static_cast<int>(first_sites_);
    unused_.pop_back();
  }
  chain(s, index);
  return Vertex(static_cast<int>(first_sites_) + index);
}

/// Puts an extra vertex on a site.
void Front::chain(Site s, int index) {
  if (is_first(s) && first_extra_.empty()) first_extra_.assign(first_sites_, -1);
  int& first = first_on(s);
  extra_[static_cast<std::size_t>(index)] = {s, first};
  first = index;
}

void Front::release(Vertex v) {
  // Of two merged vertices the lower handle stays, so the one left over is always an extra one.
  const int index = v.idx() - static_cast<int>(first_sites_);
  const Site s = site(v);
  int* link = &first_on(s);
  while (*link != index) link = &extra_[static_cast<std::size_t>(*link)].next;
  *link = extra_[static_cast<std::size_t>(index)].next;
  unused_.push_back(v);
}

InsertedTriangle Front::insert(TriangleSides sides, Site a, Site b, Site c) {
  const std::array<Site, 3> on = {a, b, c};
  for (unsigned i = 0; i < 3; ++i)
    if (!sides.side[i].is_valid() && !sides.side[(i + 2) % 3].is_valid()) sides.corner[i] = vertex_for_fan(on[i]);
  const InsertedTriangle result = insert_triangle(mesh_, sides, Supply{*this});
  for (unsigned i = 0; i < static_cast<unsigned>(result.merged); ++i) release(result.left_over[i]);
  return result;
}

InsertedTriangle Front::insert_and_activate(const TriangleSides& sides, Site a, Site b, Site c) {
  const InsertedTriangle result = insert(sides, a, b, c);
  for (unsigned i = 0; i < 3; ++i)
    if (!sides.side[i].is_valid()) activate(mesh_.opposite_halfedge_handle(result.side[i]));
  return result;
}

TriangleSides Front::sides_of(Site a, Site b, Site c) const {
  TriangleSides sides;
  sides.side = {boundary_into(a, b), boundary_into(b, c), boundary_into(c, a)};
  return sides;
}

InsertedTriangle Front::create(Site a, Site b, Site c) { return insert_and_activate(sides_of(a, b, c), a, b, c); }

TriangleSides Front::sides_of(Halfedge h, Site apex) const {
  TriangleSides sides;
  sides.side[0] = h;
  if (!is_free(apex)) {
    // The neighbours on the curve are the common case and need no search.
    const Halfedge next = mesh_.next_halfedge_handle(h), prev = mesh_.prev_halfedge_handle(h);
    sides.side[1] = to_site(next) == apex ? next : boundary_into(to_site(h), apex);
    sides.side[2] = from_site(prev) == apex ? prev : boundary_out_of(apex, from_site(h));
  }
  return sides;
}

InsertedTriangle Front::attach(Halfedge h, Site apex) {
  const Site a = from_site(h), b = to_site(h);
  return insert_and_activate(sides_of(h, apex), a, b, apex);
}

void Front::activate(Halfedge h) {
  // The part before head_ is spent: reuse it when it is most of the queue, so that the queue stays as long as the
  // front and not as the run.
  if (active_.size() == active_.capacity() && head_ > active_.size() / 2) {
    active_.erase(active_.begin(), active_.begin() + static_cast<std::ptrdiff_t>(head_));
    head_ = 0;
  }
  active_.push_back(h);
}

std::vector<BoundaryCurve> Front::curves() const {
  std::vector<BoundaryCurve> found;
  std::vector<bool> seen(2 * edges_, false);
  for (std::size_t i = 0; i < 2 * edges_; ++i) {
    const Halfedge h(static_cast<int>(i));
    if (seen[i] || !mesh_.is_boundary(h)) continue;
    found.emplace_back(mesh_, h);
    for (const Halfedge on_curve : found.back()) seen[static_cast<std::size_t>(on_curve.idx())] = true;
  }
  return found;
}

std::vector<BoundaryCurve> Front::curves_at(Site s) const {
  std::vector<BoundaryCurve> found;
  for_each_fan(s, [&](Vertex v) {
    if (const auto curve = boundary_curve_at(mesh_, v)) found.push_back(*curve);
  });
  return found;
}

LevelTransfer Front::next_level() {
  LevelTransfer transfer;
  for (auto s = static_cast<Site>(carried_before_); s < static_cast<Site>(sites()); ++s) carried_.push_back(s);
  carried_before_ = sites();
  // Sites on the boundary are known from its halfedges, so that no fan of any other is read.
  std::vector<Site> on_boundary;
  const auto note = [&](Halfedge h) {
    if (mesh_.is_boundary(h)) on_boundary.push_back(from_site(h));
  };
  std::for_each(frozen_.begin(), frozen_.end(), note);
  std::for_each(active_.begin() + static_cast<std::ptrdiff_t>(head_), active_.end(), note);
  std::sort(on_boundary.begin(), on_boundary.end());
  on_boundary.erase(std::unique(on_boundary.begin(), on_boundary.end()), on_boundary.end());
  std::vector<Site> free;
  std::copy_if(carried_.begin(), carried_.end(), std::back_inserter(free), [&](Site s) { return is_free(s); });
  transfer.carried.resize(on_boundary.size() + free.size());
  std::merge(on_boundary.begin(), on_boundary.end(), free.begin(), free.end(), transfer.carried.begin());
  transfer.left_behind = carried_.size() - transfer.carried.size();
  carried_ = transfer.carried;
  for (const Halfedge h : frozen_) {
    if (!mesh_.is_boundary(h)) continue;
    activate(h);
    ++transfer.reactivated;
  }
  frozen_.clear();
  return transfer;
}

/// Moves the vertices from `first` on to their new numbers. One without triangles has that of the next, which then
/// overwrites it: no branch is needed where it could not be foreseen.
void Front::renumber(std::size_t first, const std::vector<int>& number) {
  for (auto property = mesh_.vprops_begin(); property != mesh_.vprops_end(); ++property) {
    if (*property == nullptr) continue;
    for (std::size_t i = first; i < number.size(); ++i) (*property)->copy(i, static_cast<std::size_t>(number[i]));
  }
  for (std::size_t i = first; i < number.size(); ++i)
    mesh_.set_halfedge_handle(Vertex(number[i]), mesh_.halfedge_handle(Vertex(static_cast<int>(i))));
  for (int i = 0; i < static_cast<int>(2 * edges_); ++i) {
    const Halfedge h(i);
    mesh_.set_vertex_handle(h, Vertex(number[static_cast<std::size_t>(mesh_.to_vertex_handle(h).idx())]));
  }
}

std::vector<Site> Front::finish() {
  const auto is_unused = [&](std::size_t i) { return mesh_.is_isolated(Vertex(static_cast<int>(i))); };
  // Vertices of fans that have grown together are at the end: where no others are unused, none needs a new number.
  std::size_t end = mesh_.n_vertices(), left = 0;
  while (end > 0 && is_unused(end - 1)) --end;
  std::vector<Site> site_of(end);
  for (; left < site_of.size() && !is_unused(left); ++left) site_of[left] = site(Vertex(static_cast<int>(left)));
  if (const std::size_t first = left; first < site_of.size()) {
    std::vector<int> number(site_of.size());
    std::iota(number.begin(), number.begin() + static_cast<std::ptrdiff_t>(first), 0);
    for (std::size_t i = first; i < site_of.size(); ++i) {
      site_of[left] = site(Vertex(static_cast<int>(i)));
      number[i] = static_cast<int>(left);
      left += !is_unused(i);
    }
    renumber(first, number);
    site_of.resize(left);
  }
  mesh_.resize(site_of.size(), edges_, faces_);
  extra_ = {};
  first_extra_ = {};
  unused_ = {};
  active_ = {};
  frozen_ = {};
  carried_ = {};
  return site_of;
}

}  // namespace meshops
