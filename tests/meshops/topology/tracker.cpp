#include "meshops/topology/tracker.h"

#include <doctest/doctest.h>

#include <map>
#include <random>

#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/handle/create.h"
#include "meshops/handle/destroy.h"
#include "meshops/stellar/collapse.h"
#include "meshops/stellar/flip.h"
#include "meshops/stellar/split_edge.h"
#include "meshops/stellar/split_face.h"
#include "meshops/stellar/split_vertex.h"
#include "meshops/stellar/undo.h"
#include "meshops/stellar/weld_edge.h"
#include "meshops/stellar/weld_face.h"
#include "support/arguments.h"
#include "support/check_sound.h"
#include "support/corpus.h"
#include "support/on_corpus.h"

using namespace meshops;
using namespace meshops::test;

namespace {

/// Random operators on a mesh, each reported to a tracker. The size of the mesh is kept between two bounds.
class RandomWalk {
 public:
  RandomWalk(TestMesh& mesh, unsigned seed) : mesh_(mesh), random_(seed), tracker_(mesh) {}

  TopologyTracker& tracker() { return tracker_; }
  const std::map<std::string, int>& done() const { return done_; }

  /// Performs one operator that is not refused, or none if chance finds no place for it.
  void step() {
    const std::size_t faces = tracker_.counts().faces;
    // If the mesh is large: only operators that make it smaller, or split it.
    const auto choice = random_() % (faces > 400 ? 14U : 24U);
    if (faces < 60 || choice >= 21) return create();
    if (choice < 3) return collapse_one();
    if (choice < 5) return weld_one();
    if (choice < 6) return destroy_one();
    if (choice < 9) return glue_two();
    if (choice < 13) return unglue_one();
    if (choice < 14) return flip_one();
    if (choice < 15) return zip_two();
    if (choice < 17) return open_or_close();
    if (choice < 19) return split_an_edge();
    if (choice < 20) return split_a_face();
    split_a_vertex();
  }

 private:
  template <typename Handle>
  Handle any(std::size_t count) {
    for (int attempt = 0; attempt < 50; ++attempt)
      if (const Handle element(static_cast<int>(random_() % count)); is_live(mesh_, element)) return element;
    return Handle();
  }
  Halfedge any_boundary() {
    for (int attempt = 0; attempt < rbpa_test::trials(200); ++attempt)
      if (const auto h = any<Halfedge>(mesh_.n_halfedges()); h.is_valid() && mesh_.is_boundary(h)) return h;
    return Halfedge();
  }
  void did(const std::string& what) { ++done_[what]; }

  void create() {
    tracker_.note(create_triangle(mesh_));
    did("create");
  }
  void destroy_one() {
    // Single triangles are rare: make one, and destroy it or another.
    create();
    const auto f = any<Face>(mesh_.n_faces());
    const Face target =
        f.is_valid() && !destroy_triangle_blocker(mesh_, f) ? f : Face(static_cast<int>(mesh_.n_faces()) - 1);
    destroy_triangle(mesh_, target);
    tracker_.note_destroyed();
    did("destroy");
  }
  void glue_two() {
    const Halfedge first = any_boundary();
    if (!first.is_valid()) return;
    const Halfedge second = random_() % 2 ? mesh_.next_halfedge_handle(first) : any_boundary();
    if (glue_blocker(mesh_, first, second)) {
      CHECK_THROWS_AS(tracker_.glue(first, second), ContractViolation);
      return;
    }
    if (random_() % 4 == 0) {
      const GlueEffect effect = glue(mesh_, first, second);
      tracker_.note(effect);
      if (random_() % 2 == 0) {
        tracker_.note(unglue(mesh_, effect));
        return did("glue taken back");
      }
      return did(std::string(name(effect.what)));
    }
    const GlueCase expected = glue_case(mesh_, first, second);
    const GlueEffect effect = tracker_.glue(first, second);
    CHECK(effect.what == expected);
    did(std::string(name(effect.what)));
  }
  void unglue_one() {
    auto h = any<Halfedge>(mesh_.n_halfedges());
    // Edges that are the only connection of two parts are rare: look for a face attached by a single edge.
    const auto hangs = [&](Halfedge side) {
      return mesh_.is_boundary(mesh_.opposite_halfedge_handle(mesh_.next_halfedge_handle(side))) &&
             mesh_.is_boundary(mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(side)));
    };
    if (random_() % 2 == 0)
      for (int attempt = 0; attempt < 40 && h.is_valid() && !hangs(h); ++attempt)
        h = any<Halfedge>(mesh_.n_halfedges());
    if (!h.is_valid() || unglue_blocker(mesh_, h)) return;
    const UnglueEffect effect = unglue(mesh_, h);
    tracker_.note(effect);
    did("un" + std::string(name(effect.what)));
  }
  void zip_two() {
    const Halfedge first = any_boundary(), second = any_boundary();
    if (!first.is_valid() || zip_curves_blocker(mesh_, first, second)) return;
    tracker_.zip_curves(first, second);
    did("zip curves");
  }
  void open_or_close() {
    const auto f = any<Face>(mesh_.n_faces());
    if (f.is_valid() && random_() % 2 == 0 && !open_curve_blocker(mesh_, f)) {
      tracker_.note(open_curve(mesh_, f));
      did("open");
    } else if (const Halfedge h = any_boundary();
               h.is_valid() && !close_curve_blocker(mesh_, h) &&
               mesh_.next_halfedge_handle(mesh_.next_halfedge_handle(mesh_.next_halfedge_handle(h))) == h) {
      tracker_.note(close_curve(mesh_, h));
      did("close curve");
    }
  }
  void split_an_edge() {
    const auto e = any<Edge>(mesh_.n_edges());
    if (!e.is_valid() || split_edge_blocker(mesh_, e, Keep::manifold)) return;
    tracker_.note(split_edge(mesh_, e, Keep::manifold));
    did("split edge");
  }
  void split_a_face() {
    const auto f = any<Face>(mesh_.n_faces());
    if (!f.is_valid() || split_face_blocker(mesh_, f)) return;
    tracker_.note(split_face(mesh_, f));
    did("split face");
  }
  void split_a_vertex() {
    const auto left = any<Halfedge>(mesh_.n_halfedges());
    if (!left.is_valid()) return;
    const Halfedge right = mesh_.next_halfedge_handle(mesh_.opposite_halfedge_handle(left));
    if (split_vertex_blocker(mesh_, left, right, Keep::manifold)) return;
    tracker_.note(split_vertex(mesh_, left, right, Keep::manifold));
    did("split vertex");
  }
  void collapse_one() {
    const auto h = any<Halfedge>(mesh_.n_halfedges());
    if (!h.is_valid() || collapse_blocker(mesh_, h, Keep::manifold)) return;
    const WeldEffect effect = collapse(mesh_, h, Keep::manifold);
    tracker_.note(effect);
    did("collapse");
    if (random_() % 3 == 0) {
      undo(mesh_, effect);
      tracker_.note_undone(effect);
      did("collapse taken back");
    }
  }
  void weld_one() {
    const auto h = any<Halfedge>(mesh_.n_halfedges());
    if (!h.is_valid()) return;
    if (!weld_edge_blocker(mesh_, h, Keep::manifold)) {
      tracker_.note(weld_edge(mesh_, h, Keep::manifold));
      did("weld edge");
    } else if (const Vertex v = mesh_.from_vertex_handle(h); !weld_face_blocker(mesh_, v, Keep::manifold)) {
      tracker_.note(weld_face(mesh_, v, Keep::manifold));
      did("weld face");
    }
  }
  void flip_one() {
    const auto e = any<Edge>(mesh_.n_edges());
    if (!e.is_valid() || flip_blocker(mesh_, e, Keep::manifold)) return;
    flip(mesh_, e, Keep::manifold);
    did("flip");
  }

  TestMesh& mesh_;
  std::mt19937 random_;
  TopologyTracker tracker_;
  std::map<std::string, int> done_;
};

/// Returns the component of each vertex, computed anew.
std::vector<int> components(const TestMesh& mesh) {
  std::vector<int> of(mesh.n_vertices(), -1);
  int count = 0;
  for_each_vertex(mesh, [&](Vertex seed) {
    if (of[static_cast<std::size_t>(seed.idx())] >= 0) return;
    std::vector<Vertex> open = {seed};
    of[static_cast<std::size_t>(seed.idx())] = count;
    while (!open.empty()) {
      const Vertex v = open.back();
      open.pop_back();
      for (const auto next : mesh.vv_range(v))
        if (int& c = of[static_cast<std::size_t>(next.idx())]; c < 0) {
          c = count;
          open.push_back(next);
        }
    }
    ++count;
  });
  return of;
}

void check_components(const TestMesh& mesh, TopologyTracker& tracker) {
  const std::vector<int> of = components(mesh);
  std::map<int, Vertex> representative;
  bool agree = true;
  for_each_vertex(mesh, [&](Vertex v) {
    const auto [slot, is_new] = representative.try_emplace(of[static_cast<std::size_t>(v.idx())], v);
    if (!is_new) agree = agree && tracker.in_same_component(slot->second, v);
  });
  for (auto a = representative.begin(); a != representative.end(); ++a)
    if (const auto b = std::next(a); b != representative.end())
      agree = agree && !tracker.in_same_component(a->second, b->second);
  CHECK(agree);
}

}  // namespace

TEST_SUITE("tracker") {
  TEST_CASE("a tracker agrees with a recount during a hundred thousand random operators") {
    TestMesh mesh;
    separate_triangles(mesh, 60);
    RandomWalk walk(mesh, 1936);
    int steps = 0;
    for (int i = 0; i < 100000; ++i) {
      walk.step();
      if (++steps % 100 != 0) continue;
      REQUIRE(walk.tracker().counts() == count_topology(mesh));
      if (steps % 1000 != 0) continue;
      check_sound(mesh);
      check_components(mesh, walk.tracker());
    }
    const char* kinds[] = {
        "create",     "destroy",   "join",          "split curve", "handle",          "zip",
        "close",      "unjoin",    "unsplit curve", "unhandle",    "unzip",           "unclose",
        "zip curves", "open",      "close curve",   "split edge",  "split face",      "split vertex",
        "collapse",   "weld edge", "weld face",     "flip",        "glue taken back", "collapse taken back"};
    for (const char* kind : kinds) {
      CAPTURE(std::string(kind));
      CHECK((walk.done().count(kind) != 0 && walk.done().at(kind) >= 20));
    }
  }

  TEST_CASE("a tracker begins with the counts of any mesh") {
    on_corpus([&](const Specimen&, TestMesh& mesh) {
      TopologyTracker tracker(mesh);
      CHECK(tracker.counts() == count_topology(mesh));
      check_components(mesh, tracker);
    });
  }
}
