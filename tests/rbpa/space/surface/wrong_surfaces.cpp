// Invalid surfaces, and curves of other surfaces, given to every function that takes them: they are refused, never
// followed. A surface without triangles is valid.
#include <doctest/doctest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/space/repair/close_surface.h"
#include "rbpa/space/repair/crossing_triangles.h"
#include "rbpa/space/repair/fill_holes.h"
#include "rbpa/space/repair/refine_filling.h"
#include "rbpa/space/repair/suggested_repairs.h"
#include "rbpa/space/surface/curve_kinds.h"
#include "rbpa/space/surface/holes.h"
#include "rbpa/space/surface/outer_shells.h"
#include "rbpa/space/surface/split_fans.h"
#include "rbpa/space/surface/surface_components.h"
#include "rbpa/space/surface/surface_mesh.h"
#include "rbpa/space/surface/surface_of.h"
#include "rbpa/space/surface/unused_points.h"
#include "support/space_sets.h"

using namespace rbpa_test;
using rbpa::Hole;
using rbpa::Surface;

TEST_SUITE_BEGIN("space");

namespace {

using Row = std::array<std::uint32_t, 3>;
constexpr std::uint32_t none = Surface::none;

const Points3 places = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const Points3 normals(4, rbpa::Point3{0, 0, 1});

/// Returns two triangles with a common edge.
Surface pair() { return rbpa::surface_of(places, std::vector<Row>{{0, 1, 2}, {0, 3, 1}}); }

std::vector<std::pair<const char*, Surface>> broken_surfaces() {
  std::vector<std::pair<const char*, Surface>> all;
  const auto add = [&](const char* what, auto change) {
    Surface surface = pair();
    change(surface);
    all.emplace_back(what, surface);
  };
  add("a triangle without neighbors", [](Surface& s) { s.neighbors.pop_back(); });
  add("neighbors without a triangle", [](Surface& s) { s.triangles.pop_back(); });
  add("a corner that is not a point", [](Surface& s) { s.triangles[1][1] = 4; });
  add("a corner far away", [](Surface& s) { s.triangles[0][2] = none; });
  add("a corner twice", [](Surface& s) { s.triangles[0][2] = s.triangles[0][1]; });
  add("a neighbor that does not exist", [](Surface& s) { s.neighbors[0][0] = 2; });
  add("a neighbor far away", [](Surface& s) { s.neighbors[0][1] = none - 1; });
  add("a neighbor that does not name it", [](Surface& s) { s.neighbors[1] = {none, none, none}; });
  add("a triangle as its own neighbor", [](Surface& s) { s.neighbors[0] = {0, 0, 0}; });
  add("a neighbor across another side",
      [](Surface& s) { std::rotate(s.neighbors[0].begin(), s.neighbors[0].begin() + 1, s.neighbors[0].end()); });
  return all;
}

using Calls = std::vector<std::pair<const char*, std::function<void(const Surface&)>>>;

Calls calls_on_surfaces() {
  const auto components = [](const Surface& s) {
    rbpa::SurfaceComponents of;
    of.number.assign(s.triangles.size(), 0);
    of.all.resize(s.triangles.empty() ? 0 : 1);
    return of;
  };
  return {
      {"split_fans", [](const Surface& s) { rbpa::split_fans(s); }},
      {"indexable_surface", [](const Surface& s) { rbpa::indexable_surface(s); }},
      {"surface_components", [](const Surface& s) { rbpa::surface_components(places, s); }},
      {"genus_of", [=](const Surface& s) { rbpa::genus_of(s, components(s)); }},
      {"surface_mesh", [](const Surface& s) { rbpa::surface_mesh(places, s); }},
      {"surface_mesh, moved", [](Surface s) { rbpa::surface_mesh(places, std::move(s)); }},
      {"surface_curves", [](const Surface& s) { rbpa::surface_curves(places, s); }},
      {"fill_holes", [](const Surface& s) { rbpa::fill_holes(places, s, std::vector<Hole>()); }},
      {"close_surface", [](const Surface& s) { rbpa::close_surface(places, s); }},
      {"touching_points", [](const Surface& s) { rbpa::touching_points(places, s); }},
      {"refine_filling",
       [](const Surface& s) { rbpa::refine_filling(places, s, std::vector<bool>(s.triangles.size())); }},
      {"surface_of", [](const Surface& s) { rbpa::surface_of(places, s.triangles, s.neighbors); }},
      {"holes", [](const Surface& s) { rbpa::holes(places, normals, 1, s); }},
      {"suggested_repairs",
       [](const Surface& s) {
         rbpa::suggested_repairs(places, normals, std::vector<double>{1}, s, std::vector<Hole>());
       }},
      {"outer_shells", [=](const Surface& s) { rbpa::outer_shells(places, 1, s, components(s)); }},
      {"unused_points", [](const Surface& s) { rbpa::unused_points(places, normals, 1, s); }},
  };
}

Calls calls_with_duplicates() {
  Calls calls = calls_on_surfaces();
  std::erase_if(calls, [](const auto& call) {
    const std::string_view name = call.first;
    return name != "holes" && name != "suggested_repairs" && name != "unused_points";
  });
  return calls;
}

/// Returns how a call ended.
std::string end_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const meshops::ContractViolation&) {
    return "refused";
  } catch (const rbpa::InvalidInput&) {
    return "refused";
  }
  return "done";
}

}  // namespace

TEST_CASE("every function of surfaces refuses invalid ones, and takes one without triangles") {
  for (const auto& [name, call] : calls_on_surfaces()) {
    const auto& shown_name = name;
    CAPTURE(std::string(shown_name));
    for (const auto& [what, surface] : broken_surfaces()) {
      const auto& shown_what = what;
      CAPTURE(std::string(shown_what));
      const auto& given = surface;
      const auto& called = call;
      const bool has_no_points = std::string(name) == "split_fans" || std::string(name) == "indexable_surface" ||
                                 std::string(name) == "genus_of";
      if (has_no_points && std::string(what) == "a corner that is not a point") continue;
      CHECK(end_of([&] { called(given); }) == "refused");
    }
    const auto& called = call;
    CHECK(end_of([&] { called(Surface()); }) == "done");
  }
}

TEST_CASE("duplicates that are not those of the points are refused") {
  const std::vector<std::vector<rbpa::Duplicate>> broken = {{{4, 0}}, {{none, 0}},      {{3, 4}},         {{3, 3}},
                                                            {{2, 3}}, {{3, 0}, {3, 0}}, {{3, 0}, {2, 0}}, {{3, none}}};
  for (const auto& [name, call] : calls_with_duplicates()) {
    const auto& shown_name = name;
    CAPTURE(std::string(shown_name));
    const auto& called = call;
    for (const std::vector<rbpa::Duplicate>& duplicates : broken) {
      Surface surface = rbpa::surface_of(places, std::vector<Row>{{0, 1, 2}});
      surface.duplicates = duplicates;
      CAPTURE(duplicates.back().index);
      CHECK(end_of([&] { called(surface); }) == "refused");
    }
  }
}

TEST_CASE("every function of curves refuses those of another surface") {
  const Surface surface = pair();
  const std::vector<Hole> good = rbpa::surface_curves(places, surface);
  REQUIRE(good.size() == 1);
  const auto components = rbpa::surface_components(places, surface);
  std::vector<std::pair<const char*, Hole>> wrong = {{"without an edge", Hole()}};
  const auto add = [&](const char* what, auto change) {
    Hole hole = good[0];
    change(hole.edges[1]);
    wrong.emplace_back(what, hole);
  };
  add("a triangle that is not there", [](rbpa::RimEdge& e) { e.triangle = 2; });
  add("a triangle far away", [](rbpa::RimEdge& e) { e.triangle = none; });
  add("a point that is not there", [](rbpa::RimEdge& e) { e.from = 4; });
  add("a point far away", [](rbpa::RimEdge& e) { e.from = none; });
  for (const auto& [what, hole] : wrong) {
    const auto& shown_what = what;
    CAPTURE(std::string(shown_what));
    const std::vector<Hole> curves = {hole};
    CHECK(end_of([&] { rbpa::fill_holes(places, surface, curves); }) == "refused");
    CHECK(end_of([&] { rbpa::curve_kinds(places, components, curves); }) == "refused");
  }
  CHECK(end_of([&] { rbpa::fill_holes(places, surface, good); }) == "done");
  CHECK(end_of([&] { rbpa::curve_kinds(places, components, good); }) == "done");
  const std::vector<Hole> twice = {good[0], good[0]};
  CHECK(end_of([&] { rbpa::fill_holes(places, surface, twice); }) == "refused");
}

TEST_CASE("triangles, loops and lists that do not belong together are refused") {
  const std::vector<Row> triangles = {{0, 1, 2}, {0, 3, 1}};
  using Loops = std::vector<std::vector<std::uint32_t>>;
  const Loops good = rbpa::boundary_loops(triangles);
  CHECK(end_of([&] { rbpa::fill_holes(places, triangles, good); }) == "done");
  for (const Loops& loops : {Loops{{}}, Loops{{0}}, Loops{{0, 1}}, Loops{{0, 1, 2}}, Loops{{0, 1, 9}},
                             Loops{{0, 1, none}}, Loops{good[0], good[0]}, Loops{{1, 2, 0}}})
    CHECK(end_of([&] { rbpa::fill_holes(places, triangles, loops); }) == "refused");
  for (const Row& row : {Row{0, 1, 4}, Row{0, none, 1}}) {
    const std::vector<Row> wrong = {triangles[0], row};
    CHECK(end_of([&] { rbpa::fill_holes(places, wrong, Loops()); }) == "refused");
    CHECK(end_of([&] { rbpa::crossing_triangles(places, wrong, 10); }) == "refused");
    CHECK(end_of([&] { rbpa::surface_of(places, wrong); }) == "refused");
  }
  const Surface surface = pair();
  CHECK(end_of([&] { rbpa::refine_filling(places, surface, std::vector<bool>(1)); }) == "refused");
  CHECK(end_of([&] { rbpa::keep_triangles(surface, std::vector<bool>(3)); }) == "refused");
  const auto components = rbpa::surface_components(places, surface);
  CHECK(end_of([&] { rbpa::keep_components(surface, components, std::vector<bool>(2)); }) == "refused");
  rbpa::SurfaceComponents few = components, far = components;
  few.number.pop_back();
  far.number[1] = 7;
  for (const rbpa::SurfaceComponents& wrong : {few, far}) {
    CHECK(end_of([&] { rbpa::keep_components(surface, wrong, std::vector<bool>(1)); }) == "refused");
    CHECK(end_of([&] { rbpa::genus_of(surface, wrong); }) == "refused");
  }
  for (const Row& row : {Row{0, 1, 4}, Row{none, 1, 2}})
    CHECK(end_of([&] { rbpa::normals_between(normals, std::vector<Row>{row}); }) == "refused");
}

TEST_SUITE_END();
