#include "walk/wrong_calls.h"

#include <array>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "meshops/meshops.h"
#include "support/corpus.h"
#include "walk/arguments.h"

namespace meshops::test {
namespace {

struct Thrown : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Policy of a simplification whose answers are drawn, wrong ones among them.
struct AnyPolicy {
  Choices& choices;

  std::optional<double> cost(const Connectivity&, Edge) {
    if (choices.one_in(600)) return std::numeric_limits<double>::quiet_NaN();
    return choices.one_in(20) ? std::nullopt : std::optional<double>(choices.below(9));
  }
  unsigned place(const Connectivity&, Edge) {
    if (choices.one_in(200)) throw Thrown("place");
    return choices.below(9);
  }
  bool allows(const Connectivity&, Edge, unsigned) { return !choices.one_in(4); }
  Vertex survivor(const Connectivity& mesh, Edge e, unsigned) {
    if (choices.one_in(100)) return Vertex(static_cast<int>(choices.below(40)) - 1);
    return mesh.to_vertex_handle(mesh.halfedge_handle(e, choices.below(2)));
  }
  unsigned key(const Connectivity&, Vertex) { return choices.below(3); }
  bool stops(const Connectivity&, Edge, double) { return choices.one_in(200); }
  void merge(Connectivity&, const WeldEffect&, unsigned) {
    if (choices.one_in(100)) throw Thrown("merge");
  }
};

class WrongCalls {
 public:
  explicit WrongCalls(Choices& choices) : choices_(choices), own_(choices, mesh_), foreign_(choices, other_) {
    for (TestMesh* mesh : {&mesh_, &other_}) corpus()[choices_.below(12)].build(*mesh);
    mesh_.add_property(weight_);
    other_.add_property(foreign_weight_);
    other_.add_property(foreign_weight_);  // with a number that the first mesh does not have
    make_deleted();
  }

  void call() {
    using Step = void (WrongCalls::*)();
    static constexpr Step steps[] = {&WrongCalls::handles, &WrongCalls::stellar, &WrongCalls::polygons,
                                     &WrongCalls::hooks,   &WrongCalls::effects, &WrongCalls::cuts,
                                     &WrongCalls::loops,   &WrongCalls::track,   &WrongCalls::history,
                                     &WrongCalls::front,   &WrongCalls::look,    &WrongCalls::simplification};
    (this->*steps[choices_.below(std::size(steps))])();
    if (mesh_.n_edges() > 250) mesh_.garbage_collection();  // remembered effects are then of another mesh
  }
  bool is_small() const { return mesh_.n_edges() < 500; }
  const std::map<std::string, Judge::Tally>& tally() const { return tally_; }

 private:
  // These are handles of the mesh or of the other mesh, valid or not.
  Vertex vertex() { return choices_.one_in(5) ? foreign_.vertex() : own_.vertex(); }
  Edge edge() { return choices_.one_in(5) ? foreign_.edge() : own_.edge(); }
  Face face() { return choices_.one_in(5) ? foreign_.face() : own_.face(); }
  Halfedge halfedge() {
    const auto dead = static_cast<unsigned>(deleted_.size());
    if (dead > 0 && choices_.one_in(8)) return deleted_[choices_.below(dead)];
    return choices_.one_in(5) ? foreign_.halfedge() : choices_.one_in(2) ? own_.boundary() : own_.halfedge();
  }
  Halfedge near(Halfedge h) { return choices_.one_in(2) ? own_.boundary_near(h) : own_.around(h); }

  void make_deleted() {
    for_each_vertex(mesh_, [&](Vertex v) {
      if (!remove_vertex_blocker(mesh_, v) && deleted_.size() < 4) {
        const WeldEffect gone = remove_vertex(mesh_, v);
        deleted_.push_back(gone.halfedge);
        welds_.push_back(gone);
      }
    });
  }

  /// Runs a call and checks the result. A call that only reads, or throws, changes nothing.
  template <typename Call>
  bool run(const char* name, Call call, bool only_looks = false) {
    const std::vector<int> before = snapshot(mesh_);
    bool done = false;
    try {
      call();
      done = true;
    } catch (const ContractViolation& violation) {
      if (std::string(violation.what()).empty()) throw WalkFailure(std::string(name) + " gave no reason");
    } catch (const Thrown&) {
    }
    if ((!done || only_looks) && snapshot(mesh_) != before)
      throw WalkFailure(std::string(name) +
                        (done ? " changed what it looked at" : " changed what it refused to change"));
    for (const Defect& defect : validate(mesh_)) throw WalkFailure(std::string(name) + " left " + describe(defect));
    done ? ++tally_[name].done : ++tally_[name].refused;
    return done;
  }

  void handles() {
    const Halfedge h = halfedge(), g = near(h);
    const Face f = face();
    switch (choices_.below(8)) {
      case 0:
        run("glue", [&] { glues_.push_back(meshops::glue(mesh_, h, g)); });
        break;
      case 1:
        run("unglue", [&] { unglues_.push_back(meshops::unglue(mesh_, h)); });
        break;
      case 2:
        run("close_curve", [&] { close_curve(mesh_, h); });
        break;
      case 3:
        run("open_curve", [&] { open_curve(mesh_, f); });
        break;
      case 4:
        for (int tries = 0; tries < 8; ++tries)  // few curves have equal lengths
          run("zip_curves", [&] { zip_curves(mesh_, tries == 0 ? h : own_.boundary(), halfedge()); });
        break;
      case 5:
        run("destroy_triangle", [&] { destroy_triangle(mesh_, f); });
        break;
      case 6:
        run("remove_triangle", [&] { remove_triangle(mesh_, f); });
        break;
      default:
        run("create_triangle", [&] { create_triangle(mesh_); });
    }
  }

  void stellar() {
    const Halfedge h = halfedge();
    const Keep keep = own_.keep();
    switch (choices_.below(8)) {
      case 0:
        run("split_edge", [&] { split_edge(mesh_, h, keep); });
        break;
      case 1:
        run("split_face", [&] { split_face(mesh_, face()); });
        break;
      case 2:
        run("split_vertex", [&] {
          const auto one = choices_.one_in(4) ? std::nullopt : std::optional(h);
          split_vertex(mesh_, one, choices_.one_in(4) ? std::nullopt : std::optional(near(h)), keep);
        });
        break;
      case 3:
        run("flip", [&] { flips_.push_back(meshops::flip(mesh_, edge(), keep)); });
        break;
      case 4:
        run("collapse", [&] { welds_.push_back(collapse(mesh_, h, keep)); });
        break;
      case 5:
        run("weld_edge", [&] { welds_.push_back(weld_edge(mesh_, h, keep)); });
        break;
      case 6:
        run("weld_face", [&] { welds_.push_back(weld_face(mesh_, vertex(), keep)); });
        break;
      default:
        run("remove_vertex", [&] { welds_.push_back(remove_vertex(mesh_, vertex(), keep)); });
    }
  }

  void polygons() {
    const Halfedge h = halfedge();
    const Face f = choices_.one_in(3) ? face() : own_.polygon();
    switch (choices_.below(4)) {
      case 0:
        run("insert_diagonal", [&] { insert_diagonal(mesh_, h, near(h), own_.keep()); });
        break;
      case 1:
        run("remove_diagonal", [&] { remove_diagonal(mesh_, h); });
        break;
      case 2:
        run("triangulate_face", [&] { triangulate_face(mesh_, f, own_.keep()); });
        break;
      default:
        run("triangulate_face, weight that may throw", [&] {
          triangulate_face(mesh_, f, [&](Vertex, Vertex, Vertex) -> double {
            if (choices_.one_in(6)) throw Thrown("no weight");
            return 1;
          });
        });
    }
  }

  /// Calls with hooks that throw, and properties that the mesh does not have.
  void hooks() {
    const Halfedge h = halfedge();
    const auto throws = [](TestMesh&, const auto&) { throw Thrown("hook"); };
    const auto wrong = choices_.one_in(2) ? foreign_weight_ : OpenMesh::VPropHandleT<double>();
    switch (choices_.below(7)) {
      case 6:
        run("collapse, hook that throws", [&] { collapse(mesh_, h, throws); });
        break;
      case 0:
        run("split_edge, hook that throws", [&] { split_edge(mesh_, h, throws); });
        break;
      case 1:
        run("split_face, hook that throws", [&] { split_face(mesh_, face(), throws); });
        break;
      case 2:
        run("split_vertex, hook that throws", [&] { split_vertex(mesh_, h, near(h), throws); });
        break;
      case 3:
        run("split_edge, Interpolate", [&] { split_edge(mesh_, h, Interpolate(weight_)); });
        break;
      case 4:
        run("split_edge, Interpolate of another mesh", [&] { split_edge(mesh_, h, Interpolate(weight_, wrong)); });
        break;
      default:
        run("split_face, Interpolate of another mesh", [&] { split_face(mesh_, face(), Interpolate(wrong)); });
    }
  }

  template <typename Effect>
  Effect replayed(const std::vector<Effect>& all) {
    return all.empty() || choices_.one_in(8) ? Effect() : all[choices_.below(static_cast<unsigned>(all.size()))];
  }

  /// Calls with remembered effects, repeatedly, of whatever mesh they were.
  void effects() {
    switch (choices_.below(4)) {
      case 0: {
        const GlueEffect effect = replayed(glues_);
        const bool once = run("unglue of an effect", [&] { meshops::unglue(mesh_, effect); });
        if (once && run("unglue of an effect, again", [&] { meshops::unglue(mesh_, effect); }))
          throw WalkFailure("unglue() undid an effect twice");
        break;
      }
      case 1: {
        const WeldEffect effect = replayed(welds_);
        const bool once = run("undo of a weld", [&] { undo(mesh_, effect); });
        if (once && run("undo of a weld, again", [&] { undo(mesh_, effect); }))
          throw WalkFailure("undo() undid a weld twice");
        break;
      }
      case 2:
        run("undo of a flip", [&] { undo(mesh_, replayed(flips_)); });
        break;
      default: {
        const UnglueEffect effect = replayed(unglues_);
        run("glue of an effect", [&] { meshops::glue(mesh_, effect.first, effect.second); });
      }
    }
  }

  void cuts() {
    switch (choices_.below(3)) {
      case 0: {
        std::vector<Edge> edges;
        for (unsigned count = choices_.below(4); count > 0; --count) edges.push_back(edge());
        run("cut_open", [&] { cut_open(mesh_, edges); });
        break;
      }
      case 1:
        run("cut_open along a cut graph", [&] { cut_open(mesh_, homology(choices_.one_in(3) ? other_ : mesh_)); });
        break;
      default: {
        std::vector<UnglueEffect> cuts;
        if (!run("cut_open and glue_back", [&] {
              cuts = cut_open(mesh_, homology(mesh_));
              glue_back(mesh_, cuts);
            }))
          break;
        if (!cuts.empty() && run("glue_back, again", [&] { glue_back(mesh_, std::span(cuts).first(1)); }))
          throw WalkFailure("glue_back() glued an edge twice");
      }
    }
  }

  void loops() {
    std::vector<std::array<double, 3>> places;
    for (std::size_t v = 0; v < mesh_.n_vertices(); ++v)
      places.push_back({static_cast<double>(choices_.below(50)), static_cast<double>(choices_.below(50)),
                        static_cast<double>(choices_.below(50))});
    if (choices_.one_in(6) && !places.empty()) places.pop_back();
    std::vector<Loop> all = homology(choices_.one_in(4) ? other_ : mesh_).generators;
    if (choices_.one_in(2)) {
      Loop& loop = all.emplace_back();
      for (unsigned count = choices_.below(4); count > 0; --count) loop.push_back(halfedge());
    }
    run(
        "loop_kinds", [&] { loop_kinds(mesh_, places, all); }, true);
    run(
        "homology_signature", [&] { homology_signature(mesh_).of(edge()); }, true);
    std::vector<double> lengths(mesh_.n_edges(), choices_.one_in(4) ? -1 : 1);
    if (choices_.one_in(4)) lengths.resize(choices_.below(static_cast<unsigned>(lengths.size()) + 1));
    run(
        "shortest_homology_loops", [&] { shortest_homology_loops(mesh_, lengths, choices_.below(9)); }, true);
  }

  void track() {
    TopologyTracker tracker(mesh_);
    const TopologyCounts counts = tracker.counts();
    const bool noted = run(
        "a note to a tracker",
        [&] {
          switch (choices_.below(8)) {
            case 0:
              return tracker.note(replayed(glues_));
            case 1:
              return tracker.note(replayed(unglues_));
            case 2:
              return tracker.note(replayed(welds_));
            case 3:
              return tracker.note_undone(replayed(welds_));
            case 4:
              return tracker.note(CreateTriangleEffect{face(), halfedge(), halfedge()});
            case 5:
              return tracker.note(CloseCurveEffect{face()});
            case 6:
              return tracker.note(OpenCurveEffect{halfedge()});
            default:
              return tracker.note(SplitEffect{{.vertex = vertex()}, halfedge()});
          }
        },
        true);
    if (!noted && !(tracker.counts() == counts)) throw WalkFailure("a tracker counted what it refused");
  }

  /// Does a few steps, some of which throw; undoing all restores the mesh before, and redoing all gives the mesh after.
  void history() {
    const std::vector<int> before = snapshot(mesh_);
    History history(mesh_);
    for (unsigned count = 1 + choices_.below(6); count > 0; --count) {
      const Halfedge h = halfedge();
      const std::size_t steps = history.steps();
      const bool throws = choices_.one_in(4);
      const auto hook = [throws](TestMesh& m, const auto& effect) {
        CarryOver()(m, effect);
        if (throws) throw Thrown("hook");
      };
      const bool done = run("a step of a history", [&] {
        switch (choices_.below(10)) {
          case 0:
            return void(history.glue(h, near(h)));
          case 1:
            return void(history.unglue(h));
          case 2:
            return void(history.collapse(h, own_.keep()));
          case 3:
            return void(history.flip(edge()));
          case 4:
            return void(history.split_edge(mesh_, h, hook));
          case 5:
            return void(history.split_face(mesh_, face(), hook));
          case 6:
            return void(history.split_vertex(mesh_, h, near(h), hook));
          case 7:
            return void(history.split_edge(other_, h));
          case 8:
            return void(history.destroy_triangle(face()));
          default:
            return history.undo_to(choices_.below(8));
        }
      });
      if (!done && history.steps() != steps) throw WalkFailure("a history keeps a step that was refused");
    }
    const std::vector<int> after = snapshot(mesh_);
    const std::size_t steps = history.steps();
    history.undo_to(0);
    if (snapshot(mesh_) != before) throw WalkFailure("a history does not lead back");
    for (std::size_t i = 0; i < steps; ++i) history.redo();
    if (snapshot(mesh_) != after) throw WalkFailure("a history does not lead forth again");
  }

  /// Works on a copy, because a front merges vertices.
  void front() {
    std::set<std::pair<int, int>> ends;  // ends of halfedges: a front has one edge between two sites
    for (const Halfedge h : live_halfedges(mesh_))
      if (!ends.emplace(mesh_.from_vertex_handle(h).idx(), mesh_.to_vertex_handle(h).idx()).second) return;
    TestMesh copy = mesh_;
    Front front(copy);
    const auto site = [&] { return static_cast<Site>(choices_.below(static_cast<unsigned>(copy.n_vertices()) + 3)); };
    std::optional<Fit> stale;
    for (unsigned count = 1 + choices_.below(10); count > 0; --count) {
      const std::vector<int> before = snapshot(copy);
      const char* name = "a call of a front";
      bool done = false;
      try {
        switch (choices_.below(9)) {
          case 0:
            front.attach(halfedge(), site());
            break;
          case 1:
            front.create(site(), site(), site());
            break;
          case 2:
            front.detach(face());
            break;
          case 3:
            front.activate(halfedge());
            break;
          case 4:
            front.freeze(halfedge());
            break;
          case 5:
            stale = front.fit(halfedge(), site());
            break;
          case 6:
            if (stale) front.insert(*stale);
            break;
          case 7:
            front.edges_between(site(), site());
            front.curves_at(site());
            break;
          default:
            if (choices_.one_in(8)) front.finish();
        }
        done = true;
      } catch (const ContractViolation&) {
        if (snapshot(copy) != before) throw WalkFailure("a front changed what it refused to change");
      }
      for (const Defect& defect : validate(copy)) throw WalkFailure("a front left " + describe(defect));
      done ? ++tally_[name].done : ++tally_[name].refused;
    }
  }

  /// Simplifies a copy of the mesh, which stays sound and keeps its topology also if the policy is wrong.
  void simplification() {
    TestMesh copy = mesh_;
    const TopologyReport before = report(copy);
    const Keep keep = own_.keep();
    bool done = false;
    try {
      simplify(copy, AnyPolicy{choices_}, {.faces = choices_.below(20), .keep = keep});
      done = true;
    } catch (const ContractViolation&) {
    } catch (const Thrown&) {
    }
    for (const Defect& defect : validate(copy)) throw WalkFailure("simplify left " + describe(defect));
    const TopologyReport after = report(copy);
    if (after.betti != before.betti || after.boundary_curves != before.boundary_curves || after.genus != before.genus)
      throw WalkFailure("simplify changed the topology");
    done ? ++tally_["simplify"].done : ++tally_["simplify"].refused;
  }

  void look() {
    const Halfedge h = halfedge(), g = near(h);
    const Vertex v = vertex();
    const Face f = face();
    const Edge e = edge();
    run(
        "on_same_curve", [&] { on_same_curve(mesh_, h, g); }, true);
    run(
        "smaller_part", [&] { smaller_part(mesh_, f, face(), e); }, true);
    run(
        "BoundaryCurve", [&] { BoundaryCurve(mesh_, h).contains(g); }, true);
    run(
        "boundary_curve_at", [&] { boundary_curve_at(mesh_, v); }, true);
    run(
        "rim_of", [&] { rim_of(mesh_, f); }, true);
    run(
        "glue_case", [&] { glue_case(mesh_, h, g); }, true);
    run(
        "unglue_case", [&] { unglue_case(mesh_, h); }, true);
    run(
        "a view", [&] { degree(v, PrimalGraph(mesh_)); }, true);
    run(
        "a view of faces", [&] { degree(f, DualGraph(mesh_)); }, true);
    run(
        "length_map", [&] { get(length_map(mesh_), h); }, true);
    run(
        "report", [&] { report(mesh_, std::vector<std::uint32_t>(choices_.below(9))); }, true);
    run(
        "soup_of", [&] { soup_of(mesh_, std::vector<std::uint32_t>(choices_.below(9))); }, true);
    run("build_mesh", [&] { build_mesh(mesh_, soup_of(other_)); });
  }

  Choices& choices_;
  TestMesh mesh_, other_;
  Arguments own_, foreign_;
  OpenMesh::VPropHandleT<double> weight_, foreign_weight_;
  std::vector<Halfedge> deleted_;
  std::vector<GlueEffect> glues_;
  std::vector<UnglueEffect> unglues_;
  std::vector<WeldEffect> welds_;
  std::vector<FlipEffect> flips_;
  std::map<std::string, Judge::Tally> tally_;
};

}  // namespace

std::map<std::string, Judge::Tally> call_wrongly(Choices& choices, std::size_t calls) {
  WrongCalls walk(choices);
  for (std::size_t i = 0; i < calls && walk.is_small() && choices.any_left(); ++i) walk.call();
  return walk.tally();
}

}  // namespace meshops::test
