#include "meshops/patch/site_vertices.h"

#include <limits>

namespace meshops {

SiteVertices::SiteVertices(Connectivity& mesh, std::size_t sites) : mesh_(mesh), first_(sites) {
  std::size_t live = 0;
  for_each_vertex(mesh, [&](Vertex) { ++live; });
  has_dead_ = live < mesh.n_vertices();
}

SiteVertices::SiteVertices(Connectivity& mesh, std::span<const Site> site_of) : mesh_(mesh), first_(0) {
  require_one_each("Front", site_of.size(), "sites", mesh.n_vertices(), "vertices of the mesh");
  further_.resize(site_of.size());
  for (std::size_t i = 0; i < site_of.size(); ++i) {
    further_[i] = {site_of[i], none};
    if (!is_live(mesh, vertex(static_cast<int>(i)))) continue;
    while (sites() <= site_of[i]) add_site();
  }
  // The loop runs backward, so that each list begins with its least vertex.
  for (int i = static_cast<int>(site_of.size()); i-- > 0;)
    if (is_live(mesh, vertex(i)) && !mesh.is_isolated(vertex(i))) list(i);
  for (int i = 0; i < static_cast<int>(site_of.size()); ++i) {
    if (!is_live(mesh, vertex(i))) continue;
    if (int& begin = link(site_of[static_cast<std::size_t>(i)]); begin == none) begin = waiting - i;
  }
}

Site SiteVertices::add_site() {
  require(sites() < static_cast<std::size_t>(std::numeric_limits<int>::max()),
          "Front: there are 2^31 - 1 sites already, and no more can be added");
  listed_.push_back(none);
  return static_cast<Site>(sites() - 1);
}

void SiteVertices::clear() {
  first_ = 0;
  // An assignment of {} would empty the vector but keep its memory.
  further_ = std::vector<Further>();
  listed_at_first_ = std::vector<int>();
  listed_ = std::vector<int>();
  spare_ = std::vector<Vertex>();
}

int& SiteVertices::link(Site s) {
  if (!is_first(s)) return listed_[s - first_];
  if (listed_at_first_.empty()) listed_at_first_.assign(first_, none);
  return listed_at_first_[s];
}

void SiteVertices::list(int index) {
  Further& further = further_[static_cast<std::size_t>(index)];
  int& begin = link(further.site);
  further.next = begin;
  begin = index;
}

Vertex SiteVertices::take(Site s) {
  const auto require_live = [this](Vertex v) {
    require(is_live(mesh_, v), "Front: the mesh was changed by others: a vertex that waits is marked deleted");
  };
  if (const Vertex own(static_cast<int>(s)); is_first(s) && mesh_.is_isolated(own)) {
    require_live(own);
    return own;
  }
  if (const int begin = first_listed(s); begin <= waiting) {
    require_live(vertex(waiting - begin));
    link(s) = none;
    list(waiting - begin);
    return vertex(waiting - begin);
  }
  const Vertex model = first(s);
  Vertex taken;
  if (spare_.empty()) {
    further_.push_back({s, none});
    taken = mesh_.new_vertex();
  } else {
    taken = spare_.back();
    spare_.pop_back();
    further_[static_cast<std::size_t>(index_of(taken))].site = s;
    if (mesh_.has_vertex_status()) mesh_.status(taken).set_deleted(false);
  }
  if (model.is_valid()) mesh_.copy_all_properties(model, taken, true);
  list(index_of(taken));
  return taken;
}

void SiteVertices::release(Vertex v) {
  const int index = index_of(v);
  if (index < 0) return;
  const Site s = further_[static_cast<std::size_t>(index)].site;
  int* to = &link(s);
  while (*to != index) {
    require(*to >= 0, "Front: the mesh was changed by others: a vertex is not listed at its site");
    to = &further_[static_cast<std::size_t>(*to)].next;
  }
  *to = further_[static_cast<std::size_t>(index)].next;
  if (!is_first(s) && first_listed(s) == none) {
    link(s) = waiting - index;
    return;
  }
  spare_.push_back(v);
  if (mesh_.has_vertex_status()) mesh_.status(v).set_deleted(true);
}

}  // namespace meshops
