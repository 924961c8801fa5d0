// Changes of a front during a call by the engine are refused. The state of a front when a Fit was made is checked when
// it is inserted.
#include <doctest/doctest.h>

#include <functional>
#include <string>

#include "meshops/core/contract.h"
#include "meshops/front/engine.h"
#include "support/check_sound.h"
#include "support/meshes.h"
#include "support/refusal.h"
#include "support/snapshot.h"

using namespace meshops;
using namespace meshops::test;

namespace {

enum class When { seed, propose, key, glues, seeded, attached, frozen, curve, never };
using Change = std::function<void(Front&)>;

/// Changes the front at one call or event.
struct Meddling : CurveVisitor {
  Front* front = nullptr;
  When when = When::never;
  Change change;
  void at(When now) {
    if (now == when) change(*front);
  }
  std::optional<std::array<Site, 3>> seed(const Front& f) {
    at(When::seed);
    return f.faces() == 0 ? std::optional(std::array<Site, 3>{0, 1, 2}) : std::nullopt;
  }
  std::optional<Site> propose(const Front& f, Halfedge h) {
    at(When::propose);
    if (f.faces() > 2) return std::nullopt;
    return f.faces() == 1 ? 3 : f.to_site(f.mesh().next_halfedge_handle(h));
  }
  int key(const Front&, Halfedge) {
    at(When::key);
    return 0;
  }
  bool glues(const Front&, Halfedge, Site) {
    at(When::glues);
    return true;
  }
  void seeded(const Front&, const InsertedTriangle&) { at(When::seeded); }
  void attached(const Front&, Halfedge, const InsertedTriangle&) { at(When::attached); }
  void frozen(const Front&, Halfedge) { at(When::frozen); }
  void curve_begun(const Front&, Halfedge) { at(When::curve); }
};

std::string refusal_message(When when, const Change& change) {
  TestMesh mesh;
  Front front(mesh, 9);
  Meddling meddling;
  meddling.front = &front;
  meddling.when = when;
  meddling.change = change;
  const std::string words = refusal([&] { advance(front, meddling, meddling); });
  check_sound(mesh);
  // The engine is left in order: after the call the front may be changed.
  CHECK_NOTHROW(front.create(6, 7, 8));
  return words;
}

}  // namespace

TEST_SUITE("changed while the policy proposes") {
  TEST_CASE("a policy that changes the front during a call is refused, whatever the call and the change") {
    const std::vector<Change> changes = {[](Front& f) { f.create(4, 5, 6); },
                                         [](Front& f) { f.attach(Halfedge(1), 5); },
                                         [](Front& f) { f.insert(f.fit(4, 5, 6)); },
                                         [](Front& f) { f.detach(Face(0)); },
                                         [](Front& f) { f.add_site(); },
                                         [](Front& f) { f.pop(); },
                                         [](Front& f) { f.activate(Halfedge(1)); },
                                         [](Front& f) { f.freeze(Halfedge(1)); },
                                         [](Front& f) { f.next_level(); },
                                         [](Front& f) { f.finish(); }};
    for (const When when : {When::seed, When::propose, When::key, When::glues})
      for (const Change& change : changes)
        CHECK(refusal_message(when, change) == "Front: the policy changed the front during a call");
  }

  TEST_CASE("a visitor may activate and freeze, and is refused when it does more") {
    for (const When when : {When::seeded, When::attached, When::frozen, When::curve}) {
      for (const Change& change : {Change([](Front& f) { f.create(4, 5, 6); }), Change([](Front& f) { f.pop(); }),
                                   Change([](Front& f) { f.detach(Face(0)); }), Change([](Front& f) { f.finish(); })})
        CHECK(refusal_message(when, change) ==
              "Front: the visitor changed the front while it was called, other than activate() and freeze() do");
      CHECK(refusal_message(when, [](Front& f) {
              f.freeze(f.boundary_between(f.curves()[0].length() > 3 ? 2 : 1, 0));
            }) != "Front: the policy changed the front during a call");
    }
  }

  TEST_CASE("glues() that changes the front outside of a run is detected, and does not hang") {
    TestMesh mesh;
    Front front(mesh, 9);
    front.create(0, 1, 2);
    CHECK(refusal([&] {
            (void)front.fit(1, 0, 3, [&](Halfedge h, Site) {
              front.attach(h, 4);
              return false;
            });
          }) == "fit: glues() changed the front during the call");
    check_sound(mesh);
  }

  TEST_CASE("a stale fit, a fit of another front and one that was refused are not inserted") {
    TestMesh mesh, other_mesh;
    Front front(mesh, 9), other(other_mesh, 9);
    const Fit fit = front.fit(0, 1, 2);
    CHECK(refusal([&] { other.insert(fit); }) == "insert: the fit is one of another front");
    front.insert(fit);
    const std::vector<int> before = snapshot(mesh);
    constexpr const char* stale = "insert: the fit is stale: a triangle was attached or detached since it was made";
    CHECK(refusal([&] { front.insert(fit); }) == stale);
    CHECK(refusal([&] { front.insert(front.fit(0, 1, 2)); }).starts_with("insert: a face already lies"));
    CHECK(snapshot(mesh) == before);
    const Fit attached = front.fit(front.boundary_between(1, 0), 3);
    front.insert(attached);
    CHECK(refusal([&] { front.insert(attached); }) == stale);
    const Fit again = front.fit(2, 1, 4);
    front.detach(Face(1));
    CHECK(refusal([&] { front.insert(again); }) == stale);
    check_sound(mesh);
  }

  TEST_CASE("a fit made by hand is checked: its corners, and that sides are on the boundary between them") {
    TestMesh mesh;
    Front front(mesh, 9);
    front.create(0, 1, 2);
    const std::vector<int> before = snapshot(mesh);
    const auto with_side = [](std::array<Site, 3> corners, Halfedge side) {
      Fit fit(corners);
      fit.sides.side[0] = side;
      return fit;
    };
    const Halfedge boundary = front.boundary_between(1, 0), inner = mesh.opposite_halfedge_handle(boundary);
    CHECK(refusal([&] { front.insert(Fit({3, 3, 4})); }).starts_with("insert: site 3 "));
    CHECK(refusal([&] { front.insert(Fit({3, 4, static_cast<Site>(-1)})); }) == "insert: there is no site 4294967295");
    CHECK(refusal([&] { front.insert(with_side({0, 1, 3}, inner)); }).starts_with("insert: "));
    CHECK(refusal([&] { front.insert(with_side({1, 0, 3}, Halfedge(77))); }).starts_with("insert: "));
    CHECK(refusal([&] {
            front.insert(with_side({0, 1, 3}, boundary));
          }) == "insert: a given side does not run between its corners");
    CHECK(snapshot(mesh) == before);
    CHECK(front.sites() == 9);
    CHECK_NOTHROW(front.insert(with_side({1, 0, 9}, boundary)));  // the next new site
    CHECK(front.sites() == 10);
    check_sound(mesh);
  }
}
