#include "walk/front_walk.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "meshops/core/contract.h"
#include "meshops/core/validate.h"
#include "meshops/front/engine.h"
#include "meshops/handle/close_curve.h"
#include "support/corpus.h"
#include "support/snapshot.h"
#include "walk/front_model.h"

namespace meshops::test {
namespace {

using Corners3 = std::array<Site, 3>;
using State = FrontModel::State;

std::size_t index(RefusalKind kind) { return static_cast<std::size_t>(kind); }

/// Returns the part of the corpus on which a step is compared quickly.
std::vector<Specimen> small_specimens() {
  std::vector<Specimen> small;
  for (const Specimen& specimen : corpus()) {
    TestMesh mesh;
    specimen.build(mesh);
    if (specimen.simplicial && mesh.n_faces() <= 60) small.push_back(specimen);
  }
  return small;
}

class FrontWalk {
 public:
  FrontWalk(Choices& choices, FrontWalkCounts& counts) : choices_(choices), counts_(counts) { begin(); }

  void step() {
    ++counts_.steps;
    switch (below(choices_, 16)) {
      case 0:
      case 1:
      case 2:
      case 3:
      case 4:
        attach(any_halfedge(), any_site());
        break;
      case 5:
      case 6:
        attach(any_halfedge(), near_site());
        break;
      case 7:
      case 8:
      case 9:
        create({any_site(), any_site(), any_site()});
        break;
      case 10:
      case 11:
        detach(any_face());
        break;
      case 12:
        set_state();
        break;
      case 13:
        pop();
        break;
      case 14:
        choices_.one_in(8) ? begin_anew() : next_level();
        break;
      default:
        if (choices_.one_in(4))
          add_site();
        else
          ask();
    }
  }

  void log(const std::string& text) { log_ += text + "; "; }
  const std::string& log() const { return log_; }

 private:
  [[noreturn]] void broken(const std::string& law) const { throw LawBroken(law + " after: " + log_); }
  void demand(bool holds, const char* law) const {
    if (!holds) broken(law);
  }
  template <typename Operate>
  static bool throws(Operate operate) {
    try {
      operate();
    } catch (const ContractViolation&) {
      return true;
    }
    return false;
  }

  void begin() {
    mesh_.emplace();
    if (choices_.one_in(3)) {
      static const std::vector<Specimen> small = small_specimens();
      const Specimen& specimen = small[below(choices_, static_cast<std::uint32_t>(small.size()))];
      specimen.build(*mesh_);
      log("on " + specimen.name);
      if (const auto curves = boundary_curves(*mesh_); !curves.empty() && choices_.one_in(3)) {
        log("one curve closed");
        close_curve(*mesh_, curves.front().front());  // a polygon
      }
      begin_on_mesh({});
    } else {
      const std::size_t sites = 3 + below(choices_, 8);
      log("sites " + std::to_string(sites));
      model_.emplace(sites);
      has_spare_ = choices_.one_in(2);
      front_.emplace(*mesh_, sites, has_spare_ ? 8 : 1);
    }
    behind_.clear();
    check();
  }

  /// Begins a front on the present mesh, by a map of its vertices or with each vertex on its own site.
  void begin_on_mesh(const std::vector<Site>& site_of) {
    front_.reset();
    front_.emplace(*mesh_, site_of);
    has_spare_ = false;
    std::set<SiteCycle> faces;
    for_each_face(*mesh_, [&](Face f) { faces.insert(cycle(f)); });
    std::set<Site> missing;
    if (site_of.empty())
      for (std::size_t i = 0; i < mesh_->n_vertices(); ++i)
        if (!is_live(*mesh_, Vertex(static_cast<int>(i)))) missing.insert(static_cast<Site>(i));
    model_.emplace(front_->sites(), faces, missing);
    behind_.clear();
    ++counts_.begun_on_mesh;
  }

  void begin_anew() {
    const bool by_map = choices_.one_in(2);
    log(by_map ? "begin anew by map" : "begin anew");
    std::vector<Site> site_of = front_->finish();
    demand(validate(*mesh_).empty(), "the mesh is sound after finish()");
    demand(site_of.size() == mesh_->n_vertices(), "finish() returns the site of each vertex");
    begin_on_mesh(by_map ? site_of : std::vector<Site>{});
    check();
  }

  Site any_site() {
    if (choices_.one_in(40)) return static_cast<Site>(-1) - below(choices_, 3);
    return below(choices_, static_cast<std::uint32_t>(model_->sites()) + (choices_.one_in(8) ? 3 : 0));
  }
  /// Returns a site on the boundary, where most triangles fit.
  Site near_site() { return any_arrow().first; }
  Arrow any_arrow() {
    const auto& boundary = model_->boundary();
    if (boundary.empty()) return {any_site(), any_site()};
    return std::next(boundary.begin(), below(choices_, static_cast<std::uint32_t>(boundary.size())))->first;
  }
  Halfedge any_halfedge() {
    if (choices_.one_in(10))
      return Halfedge(static_cast<int>(below(choices_, static_cast<std::uint32_t>(mesh_->n_halfedges()) + 4)) - 2);
    const Arrow arrow = any_arrow();
    return arrow.first < front_->sites() && arrow.second < front_->sites()
               ? front_->boundary_between(arrow.first, arrow.second)
               : Halfedge();
  }
  Face any_face() {
    return Face(static_cast<int>(below(choices_, static_cast<std::uint32_t>(mesh_->n_faces()) + 4)) - 2);
  }

  SiteCycle cycle(Face f) const {
    SiteCycle corners;
    const Halfedge first = mesh_->halfedge_handle(f);
    Halfedge h = first;
    do {
      corners.push_back(front_->from_site(h));
      h = mesh_->next_halfedge_handle(h);
    } while (h != first);
    return canonical(corners);
  }

  /// Runs an operation that must be refused for one of the reasons, or must be done if there is none.
  template <typename Operate>
  bool goes(const std::set<RefusalKind>& against, const std::optional<Refusal>& blocker, Operate operate) {
    demand(blocker.has_value() == !against.empty(), "the blocker refuses what the model refuses, and nothing else");
    if (!blocker) {
      operate();
      return true;
    }
    demand(against.contains(blocker->kind), "the reason of a refusal is one of the model's");
    demand(!describe(*blocker).empty(), "a refusal has a text");
    ++counts_.refused[index(blocker->kind)];
    const std::vector<int> before = snapshot(*mesh_);
    try {
      operate();
    } catch (const ContractViolation& violation) {
      demand(std::string(violation.what()).ends_with(describe(*blocker)), "the exception has the blocker's reason");
      demand(snapshot(*mesh_) == before, "a refusal leaves the mesh as it was");
      return false;
    }
    broken("what is blocked throws");
  }

  void attach(Halfedge h, Site apex) {
    std::set<RefusalKind> against;
    Corners3 corners{0, 0, apex};
    if (!is_live(*mesh_, h) || !mesh_->to_vertex_handle(h).is_valid() || !mesh_->is_boundary(h)) {
      against.insert(RefusalKind::no_boundary_halfedge);
    } else {
      corners[0] = front_->from_site(h);
      corners[1] = front_->to_site(h);
      against = model_->against(corners);
    }
    log("attach " + std::to_string(h.idx()) + " to " + std::to_string(apex));
    InsertedTriangle inserted;
    if (!goes(against, front_->attach_blocker(h, apex), [&] { inserted = front_->attach(h, apex); })) return;
    demand(inserted.side[0] == h, "the halfedge is the first side of the attached triangle");
    ++counts_.attached;
    added(corners, inserted);
  }

  void create(const Corners3& c) {
    log("create " + std::to_string(c[0]) + ' ' + std::to_string(c[1]) + ' ' + std::to_string(c[2]));
    InsertedTriangle inserted;
    if (!goes(model_->against(c), front_->create_blocker(c[0], c[1], c[2]),
              [&] { inserted = front_->create(c[0], c[1], c[2]); }))
      return;
    ++counts_.created;
    added(c, inserted);
  }

  void added(const Corners3& corners, const InsertedTriangle& inserted) {
    counts_.joined_fans += static_cast<std::size_t>(inserted.merged);
    model_->add(corners);
    demand(cycle(inserted.face) == canonical({corners.begin(), corners.end()}), "the face has the requested corners");
    for (unsigned i = 0; i < 3; ++i)
      demand(front_->from_site(inserted.side[i]) == corners[i], "the sides begin at the corners, in order");
    check();
  }

  void detach(Face f) {
    log("detach " + std::to_string(f.idx()));
    std::set<RefusalKind> against;
    SiteCycle face;
    if (!is_live(*mesh_, f) || !mesh_->halfedge_handle(f).is_valid()) {
      against.insert(RefusalKind::no_such_face);
    } else {
      face = cycle(f);
      against = model_->against_removing(face);
    }
    DetachedTriangle detached;
    if (!goes(against, front_->detach_blocker(f), [&] { detached = front_->detach(f); })) return;
    ++counts_.detached;
    demand(canonical({detached.corners.begin(), detached.corners.end()}) == face, "the corners are returned");
    model_->remove(face);
    for (unsigned i = 0; i < 3; ++i) {
      const Arrow side{detached.corners[i], detached.corners[(i + 1) % 3]};
      demand(detached.side[i].is_valid() == model_->boundary().contains(side),
             "a side that was glued is on the boundary now");
      if (detached.side[i].is_valid())
        demand(front_->boundary_between(side.first, side.second) == detached.side[i],
               "the halfedge is the returned one");
    }
    check();
  }

  void set_state() {
    const Halfedge h = any_halfedge();
    const bool freezes = choices_.one_in(2);
    log((freezes ? "freeze " : "activate ") + std::to_string(h.idx()));
    const bool is_boundary = front_->is_boundary(h);
    try {
      freezes ? front_->freeze(h) : front_->activate(h);
    } catch (const ContractViolation&) {
      demand(!is_boundary, "a boundary halfedge can be frozen and woken");
      return;
    }
    demand(is_boundary, "only a boundary halfedge can be frozen or woken");
    model_->set({front_->from_site(h), front_->to_site(h)}, freezes ? State::frozen : State::active);
    check();
  }

  void pop() {
    log("pop");
    const Halfedge h = front_->pop();
    const auto& boundary = model_->boundary();
    const bool dry =
        std::none_of(boundary.begin(), boundary.end(), [](const auto& side) { return side.second == State::active; });
    demand(h.is_valid() == !dry, "pop() returns an active halfedge as long as there is one");
    if (!h.is_valid()) return;
    const Arrow arrow{front_->from_site(h), front_->to_site(h)};
    demand(boundary.at(arrow) == State::active, "a popped halfedge was active");
    model_->set(arrow, State::popped);
    check();
  }

  void next_level() {
    log("next level");
    ++counts_.levels;
    // A halfedge that is neither active nor frozen belongs to the caller that popped it: a transfer is refused then.
    for (const auto& [arrow, state] : std::map(model_->boundary()))
      if (state == State::popped) {
        demand(throws([&] { front_->next_level(); }), "no transfer forgets a popped halfedge");
        front_->freeze(front_->boundary_between(arrow.first, arrow.second));
        model_->set(arrow, State::frozen);
      }
    const auto& boundary = model_->boundary();
    const auto frozen = static_cast<std::size_t>(
        std::count_if(boundary.begin(), boundary.end(), [](const auto& side) { return side.second == State::frozen; }));
    const LevelTransfer transfer = front_->next_level();
    demand(transfer.carried == model_->carried(), "carried sites are those that are free or on the boundary");
    demand(transfer.reactivated == frozen, "all frozen halfedges become active");
    std::set<Site> behind;
    for (Site s = 0; s < model_->sites(); ++s)
      if (model_->is_closed(s)) behind.insert(s);
    const auto fresh = static_cast<std::size_t>(
        std::count_if(behind.begin(), behind.end(), [&](Site s) { return !behind_.contains(s); }));
    demand(transfer.left_behind >= fresh, "sites that became inner are left behind");
    behind_ = behind;
    model_->next_level();
    check();
  }

  void add_site() {
    log("add site");
    demand(front_->add_site() == model_->sites(), "a new site has the next number");
    model_->add_site();
    check();
  }

  /// Queries things that do not exist.
  void ask() {
    const Site s = any_site();
    const Halfedge h(static_cast<int>(below(choices_, 2000)) - 1000);
    log("ask " + std::to_string(s) + ' ' + std::to_string(h.idx()));
    const bool there = s < model_->sites();
    demand(throws([&] { (void)front_->is_free(s); }) == !there, "is_free() knows its sites");
    demand(throws([&] { front_->for_each_fan(s, [](Vertex) {}); }) == !there, "for_each_fan() knows its sites");
    demand(throws([&] { (void)front_->edge_between(s, 0); }) == !there, "edge_between() knows its sites");
    demand(throws([&] { (void)front_->edges_between(s, 0); }) == !there, "edges_between() knows its sites");
    if (h.idx() < 0 || static_cast<std::size_t>(h.idx()) >= mesh_->n_faces())
      demand(throws([&] { (void)front_->level(Face(h.idx())); }), "level() knows its faces");
    demand(throws([&] { (void)front_->site(Vertex(h.idx())); }) ==
               (h.idx() < 0 || static_cast<std::size_t>(h.idx()) >= mesh_->n_vertices()),
           "site() knows its vertices");
    const bool in_use = h.idx() >= 0 && static_cast<std::size_t>(h.idx()) < mesh_->n_halfedges();
    if (!in_use) demand(throws([&] { (void)front_->from_site(h); }), "from_site() knows its halfedges");
    demand(!front_->is_active(h) || in_use, "no halfedge is active that does not exist");
  }

  void check() {
    check_faces();
    check_boundary();
    for (Site s = 0; s < model_->sites(); ++s) check_site(s);
  }

  void check_faces() {
    std::set<SiteCycle> faces;
    std::size_t count = 0;
    for (int f = 0; f < static_cast<int>(mesh_->n_faces()); ++f)
      if (is_live(*mesh_, Face(f)) && mesh_->halfedge_handle(Face(f)).is_valid()) {
        const SiteCycle face = cycle(Face(f));
        faces.insert(face);
        ++count;
        demand(front_->level(Face(f)) == model_->level(face), "a face has the level at which it was inserted");
      }
    demand(faces == model_->faces() && count == faces.size(), "the mesh has the faces of the model");
    demand(front_->faces() == count, "faces() returns their number");
    demand(front_->level() == model_->level(), "level() returns the number of transfers");
    if (!has_spare_) demand(validate(*mesh_).empty(), "the mesh is sound");
  }

  void check_boundary() {
    std::set<Arrow> edges;
    std::size_t boundary = 0;
    for (const SiteCycle& face : model_->faces())
      for (std::size_t i = 0; i < face.size(); ++i) edges.insert(std::minmax(face[i], face[(i + 1) % face.size()]));
    for (int i = 0; i < static_cast<int>(mesh_->n_halfedges()); ++i) {
      const Halfedge h(i);
      if (!front_->is_boundary(h)) continue;
      if (mesh_->is_boundary(mesh_->opposite_halfedge_handle(h))) continue;  // in supply
      ++boundary;
      const auto found = model_->boundary().find({front_->from_site(h), front_->to_site(h)});
      demand(found != model_->boundary().end(), "a boundary halfedge is one of the model");
      demand(front_->is_active(h) == (found->second == State::active), "the active halfedges are those of the model");
      demand(front_->is_frozen(h) == (found->second == State::frozen), "the frozen halfedges are those of the model");
    }
    demand(boundary == model_->boundary().size(), "each boundary arrow of the model has a halfedge");
    demand(front_->edges() == edges.size(), "between two sites there is at most one edge");
    std::size_t on_curves = 0;
    for (const BoundaryCurve& curve : front_->curves()) on_curves += curve.length();
    demand(on_curves == boundary, "the curves have each boundary halfedge once");
  }

  void check_site(Site s) {
    std::set<std::set<SiteCycle>> fans;
    std::size_t count = 0;
    bool open = false;
    front_->for_each_fan(s, [&](Vertex v) {
      ++count;
      demand(front_->site(v) == s, "a fan stands on the site that lists it");
      open = open || mesh_->is_boundary(v);
      std::set<SiteCycle> fan;
      for (const auto out : mesh_->voh_range(v))
        if (const Face f = mesh_->face_handle(out); f.is_valid()) fan.insert(cycle(f));
      fans.insert(fan);
    });
    demand(fans == model_->fans(s) && count == fans.size(), "a site has a vertex for each of its fans");
    counts_.pinches += count > 1;
    if (model_->exists(s)) demand(front_->is_free(s) == model_->is_free(s), "is_free() agrees with the model");
    demand(front_->is_on_boundary(s) == open, "is_on_boundary() agrees with the fans");
    const Site t = below(choices_, static_cast<std::uint32_t>(model_->sites()));
    const Halfedge h = front_->edge_between(s, t);
    demand(h.is_valid() == (model_->has_side({s, t}) || model_->has_side({t, s})), "edge_between() finds every edge");
    if (h.is_valid())
      demand(front_->from_site(h) == s && front_->to_site(h) == t, "the halfedge has the right direction");
    demand(front_->edges_between(s, t) == (h.is_valid() ? std::vector{h} : std::vector<Halfedge>{}),
           "edges_between() finds the same");
    const Halfedge in = front_->boundary_between(s, t);
    demand(in.is_valid() == model_->boundary().contains({s, t}), "boundary_between() finds every boundary halfedge");
    if (in.is_valid())
      demand(front_->from_site(in) == s && front_->to_site(in) == t, "the halfedge has the right direction");
  }

  Choices& choices_;
  FrontWalkCounts& counts_;
  std::optional<TestMesh> mesh_;
  std::optional<Front> front_;
  std::optional<FrontModel> model_;
  std::set<Site> behind_;
  bool has_spare_ = false;  // there are unused elements until finish()
  std::string log_;
};

}  // namespace

void walk_on_front(Choices& choices, std::size_t steps, FrontWalkCounts& counts) {
  for (std::size_t done = 0; done < steps && choices.any_left();) {
    FrontWalk walk(choices, counts);
    const std::size_t length = 10 + below(choices, 120);
    for (std::size_t i = 0; i < length && choices.any_left(); ++i, ++done) walk.step();
  }
}

}  // namespace meshops::test
